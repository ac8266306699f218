// What JavaScript sees of the core: a few functions from values to values, and one handle, the
// session. js/index.js makes the public API of it. Nothing throws: a result with `error` is an
// error as JSON text.
#include <emscripten/bind.h>

#include <memory>
#include <optional>

#include "io/describe.h"
#include "io/domain/domain_format.h"
#include "io/error_text.h"
#include "io/mesh/mesh_format.h"
#include "io/report.h"
#include "marshal.h"
#include "mesh/quality.h"
#include "options.h"
#include "pipeline/mesh_domain.h"
#include "pipeline/session.h"
#include "pipeline/snapshot.h"

namespace lpq {
namespace {

/// {sizes, guides: as in marshal.h; seeds: Float64Array x, y, ..; size, angle: functions of (x, y),
/// or undefined}
UserFields fields_from(const val& fields) {
  UserFields user;
  user.sizes = sizes_from(fields["sizes"]);
  user.guides = guides_from(fields["guides"]);
  user.seeds = points_from(fields["seeds"]);
  const val size = fields["size"], angle = fields["angle"];
  if (!size.isUndefined()) user.size = [size](Vec2 p) { return size(p.x, p.y).as<double>(); };
  if (!angle.isUndefined()) user.angle = [angle](Vec2 p) { return angle(p.x, p.y).as<double>(); };
  return user;
}

val mesh_result(const OutputMesh& mesh, const Report& report, const Options& options) {
  val result = to_js(mesh);
  result.set("report", write_report_json(report, mesh, options));
  return result;
}

bool ask(const Progress& progress, void* callback) {
  const val& on_progress = *static_cast<const val*>(callback);
  const val go_on = on_progress(std::string(progress.stage), progress.iteration,
                                progress.max_iterations, progress.energy);
  return go_on.isTrue();
}

/// `progress(stage, iteration, maxIterations, energy)` returns false to cancel; or null.
val mesh_packed_domain(const val& packed, const val& option_object, const val& fields,
                       val progress) {
  return guarded([&] {
    const auto options = options_from(option_object);
    if (!options) return failure(options.error());
    const Monitor monitor = progress.isNull() ? Monitor{} : Monitor{ask, &progress};
    const auto outcome =
        mesh_domain(domain_from(packed), *options, monitor, nullptr, fields_from(fields));
    if (!outcome) return failure(outcome.error());
    return mesh_result(outcome->mesh, outcome->report, *options);
  });
}

/// What a mesh on a surface cannot be written as.
Problem unwritable(MeshFormat format, const MeshWriteOptions& options, const val& given) {
  if (!is_shell_format(format))
    return Error{ErrorCode::bad_option,
                 "That format is for meshes in the plane; a mesh on a surface can be written as " +
                     shell_endings() + ".",
                 {}};
  if (!given["inpElement"].isUndefined() && options.inp_element != InpElement::s4)
    return Error{
        ErrorCode::bad_option, "The elements of a surface are shells: inpElement 'S4'.", {}};
  return std::nullopt;
}

val write_mesh_text(const val& mesh_object, const std::string& format, const val& option_object) {
  return guarded([&] {
    const auto mesh = mesh_from(mesh_object);
    if (!mesh) return failure(mesh.error());
    const auto options = write_options_from(option_object);
    if (!options) return failure(options.error());
    const auto known = mesh_format_by_name(format);
    if (!known)
      return failure({ErrorCode::bad_option, "There is no mesh format '" + format + "'.", {}});
    if (mesh->in_space())
      if (const auto error = unwritable(*known, *options, option_object)) return failure(*error);
    return text_result(write_mesh(*mesh, *known, *options));
  });
}

class JsSession {
 public:
  explicit JsSession(Session session) : session_(std::move(session)) {}
  /// {session}, whose owner is JavaScript.
  static val handle(Session session) {
    val result = val::object();
    result.set("session", val(std::make_shared<JsSession>(std::move(session))));
    return result;
  }

  val step(int n) {
    return advance([&] { return session_.step(n); });
  }
  val restore(int k) {
    return advance([&] { return session_.restore(k); });
  }
  val clone() const { return handle(session_); }

  val state() const {
    const Mesher& m = session_.mesher();
    val js = val::object();
    js.set("stage", std::string(stage_name(m.stage())));
    js.set("tick", session_.ticks());
    js.set("iteration", m.iterations());
    js.set("maxIterations", m.max_iterations());
    js.set("energy", m.energy());
    js.set("gradientNorm", m.gradient_norm());
    js.set("tau", tau(m.triangles()));
    return js;
  }
  val result() const {
    const Mesher& m = session_.mesher();
    return mesh_result(m.output(), m.report(), m.options());
  }

  val triangles() const {
    const TriangleLayer layer = triangle_layer(session_.mesher());
    val js = val::object();
    js.set("points", to_array(layer.points));
    js.set("triangles", to_corners(layer.triangles));
    js.set("boundaryNodes", layer.fixed);
    return js;
  }
  val cells() const {
    const CellLayer layer = cell_layer(session_.mesher());
    val js = val::object();
    js.set("points", to_array(layer.polygons.values));
    js.set("offsets", to_array(layer.polygons.offsets));
    js.set("sites", to_array(layer.site));
    js.set("density", to_array(layer.density));
    js.set("energy", layer.energy);
    return js;
  }
  val crosses() const {
    const CrossLayer layer = cross_layer(session_.mesher());
    std::vector<Vec2> at;
    std::vector<Index> index;
    for (const Singularity& s : layer.singularities) {
      at.push_back(s.position);
      index.push_back(s.index);
    }
    val js = val::object();
    js.set("points", to_array(layer.points));
    js.set("axes", to_array(layer.axis));
    js.set("singularities", to_array(at));
    js.set("indices", to_array(index));
    return js;
  }
  val sizes() const {
    const SizeLayer layer = size_layer(session_.mesher());
    val js = val::object();
    js.set("points", to_array(layer.points));
    js.set("triangles", to_corners(layer.triangles));
    js.set("sizes", to_array(layer.h));
    return js;
  }
  val matching() const {
    const MatchingLayer layer = matching_layer(session_.mesher());
    val js = val::object();
    js.set("points", to_array(layer.points));
    js.set("triangles", to_corners(layer.triangles));
    js.set("mates", to_array(layer.mate));
    js.set("extra", to_array(layer.extra));
    js.set("costs", to_array(layer.cost));
    return js;
  }
  val quads() const {
    const QuadLayer layer = quad_layer(session_.mesher());
    val js = val::object();
    js.set("points", to_array(layer.points));
    js.set("quads", to_corners(layer.faces, 4));
    js.set("triangles", to_corners(layer.faces, 3));
    js.set("eta", to_array(layer.eta));
    js.set("valence", to_array(layer.valence));
    js.set("excess", to_array(layer.excess));
    js.set("boundaryNodes", layer.fixed);
    return js;
  }

 private:
  template <class Move>
  val advance(Move&& move) {
    return guarded([&] {
      const auto stage = move();
      return stage ? state() : failure(stage.error());
    });
  }

  Session session_;
};

/// {session} or {error}.
val start_session(const val& packed, const val& option_object, const val& fields, bool memory) {
  return guarded([&] {
    const auto options = options_from(option_object);
    if (!options) return failure(options.error());
    auto session = Session::start(domain_from(packed), *options, fields_from(fields),
                                  memory ? Session::Memory::everything : Session::Memory::nothing);
    if (!session) return failure(session.error());
    return JsSession::handle(std::move(*session));
  });
}

template <val (JsSession::*look)() const>
val looked(const JsSession& session) {
  return guarded([&] { return (session.*look)(); });
}

}  // namespace

EMSCRIPTEN_BINDINGS(lpquad) {
  using namespace emscripten;
  function("meshDomain", &mesh_packed_domain);
  function("start", &start_session);
  function("writeMesh", &write_mesh_text);
  function("describe", &write_description);
  class_<JsSession>("Session")
      .smart_ptr<std::shared_ptr<JsSession>>("Session")
      .function("step", &JsSession::step)
      .function("restore", &JsSession::restore)
      .function("clone", &looked<&JsSession::clone>)
      .function("state", &JsSession::state)
      .function("result", &looked<&JsSession::result>)
      .function("triangles", &looked<&JsSession::triangles>)
      .function("cells", &looked<&JsSession::cells>)
      .function("crosses", &looked<&JsSession::crosses>)
      .function("sizes", &looked<&JsSession::sizes>)
      .function("matching", &looked<&JsSession::matching>)
      .function("quads", &looked<&JsSession::quads>);
}

}  // namespace lpq
