// Surfaces for JavaScript: one handle, the session; js/surface.js makes the public API of it. A
// module of its own, which a page loads when it meshes its first surface.
#include <emscripten/bind.h>

#include <memory>

#include "io/error_text.h"
#include "io/surface_report.h"
#include "marshal.h"
#include "options.h"
#include "shell/output.h"
#include "shell/snapshot.h"

namespace lpq {
namespace {

class JsSurfaceSession {
 public:
  explicit JsSurfaceSession(SurfaceMesher mesher) : mesher_(std::move(mesher)) {}

  /// Up to n ticks. What failed once goes on failing.
  val step(int n) {
    for (int k = 0; k < n && !failure_ && mesher_.stage() != SurfaceStage::done; ++k) tick();
    return failure_ ? failure(*failure_) : state();
  }

  val state() const {
    val js = val::object();
    js.set("stage", std::string(stage_name(mesher_.stage())));
    js.set("tick", ticks_);
    js.set("chart", mesher_.charts_meshed());
    js.set("chartCount", static_cast<Index>(mesher_.atlas().charts.size()));
    js.set("share", mesher_.share());
    return js;
  }

  val result() const {
    const ShellOutcome& outcome = mesher_.outcome();
    std::vector<Index> triangles;
    std::vector<double> weights;
    for (const SurfacePlace& place : outcome.mesh.places) {
      triangles.push_back(place.triangle);
      weights.insert(weights.end(), place.weight, place.weight + 3);
    }
    val js = to_js(shell_output(outcome));
    js.set("placeTriangles", to_array(triangles));
    js.set("placeWeights", to_array(weights));
    js.set("surface", surface());
    js.set("report", write_surface_report_json(outcome, mesher_.options()));
    return js;
  }

  val surface() const {
    const SurfaceMesh& surface = mesher_.surface();
    val js = val::object();
    js.set("points", to_array(surface.points));
    js.set("triangles", to_corners(surface.triangles));
    js.set("groups", to_array(surface.group));
    js.set("groupNames", to_strings(mesher_.outcome().group_names));
    std::vector<Index> bodies;
    if (!surface.body.empty())
      for (const Tri& t : surface.triangles) bodies.push_back(surface.body[t[0]]);
    js.set("bodies", to_array(bodies));
    js.set("bodyNames", to_strings(mesher_.outcome().body_names));
    return js;
  }
  val features() const {
    const FeatureLayer layer = feature_layer(mesher_);
    val js = val::object();
    js.set("edges", to_pairs(layer.edges));
    js.set("kinds", to_array(layer.kinds));
    js.set("corners", to_indices(layer.corners));
    js.set("faces", to_array(layer.faces));
    return js;
  }
  val sizes() const {
    val js = val::object();
    js.set("sizes", to_array(mesher_.sizes()));
    return js;
  }
  val crosses() const {
    const SurfaceCrossLayer layer = cross_layer(mesher_);
    std::vector<Index> vertices, indices;
    for (const SurfaceSingularity& s : layer.singularities) {
      vertices.push_back(s.vertex);
      indices.push_back(s.index);
    }
    val js = val::object();
    js.set("axes", to_array(layer.axes));
    js.set("singularities", to_indices(vertices));
    js.set("indices", to_array(indices));
    return js;
  }
  val charts() const {
    const ChartLayer layer = chart_layer(mesher_);
    val js = val::object();
    js.set("charts", to_array(layer.charts));
    js.set("uv", to_array(layer.uv));
    js.set("cuts", to_pairs(layer.cuts));
    return js;
  }
  val cells() const {
    const ChartCellLayer layer = chart_cell_layer(mesher_);
    val js = val::object();
    js.set("chart", layer.chart);
    js.set("uv", to_array(layer.plane.polygons.values));
    js.set("points", to_array(layer.points));
    js.set("offsets", to_array(layer.plane.polygons.offsets));
    js.set("sites", to_array(layer.plane.site));
    js.set("density", to_array(layer.plane.density));
    return js;
  }
  val quads() const {
    const ShellLayer layer = shell_layer(mesher_);
    val js = val::object();
    js.set("points", to_array(layer.points));
    js.set("quads", to_corners(layer.faces, 4));
    js.set("triangles", to_corners(layer.faces, 3));
    js.set("regions", to_array(layer.regions));
    js.set("eta", to_array(layer.eta));
    js.set("valence", to_array(layer.valence));
    js.set("pinned", to_array(layer.pins));
    js.set("edges", to_pairs(layer.edges));
    return js;
  }

 private:
  void tick() {
    try {
      if (const auto stage = mesher_.step(); !stage) failure_ = stage.error();
    } catch (const std::bad_alloc&) {
      failure_ = out_of_memory();
    }
    ++ticks_;
  }

  SurfaceMesher mesher_;
  int ticks_ = 0;
  Problem failure_;
};

/// {session}, whose owner is JavaScript, or {error}.
val start_session(const val& packed, const val& option_object) {
  return guarded([&] {
    const auto options = surface_options_from(option_object);
    if (!options) return failure(options.error());
    auto mesher = SurfaceMesher::start(soup_from(packed), *options);
    if (!mesher) return failure(mesher.error());
    val result = val::object();
    result.set("session", val(std::make_shared<JsSurfaceSession>(std::move(*mesher))));
    return result;
  });
}

template <val (JsSurfaceSession::*look)() const>
val looked(const JsSurfaceSession& session) {
  return guarded([&] { return (session.*look)(); });
}

}  // namespace

EMSCRIPTEN_BINDINGS(lpquad_surface) {
  using namespace emscripten;
  function("start", &start_session);
  class_<JsSurfaceSession>("SurfaceSession")
      .smart_ptr<std::shared_ptr<JsSurfaceSession>>("SurfaceSession")
      .function("step", &JsSurfaceSession::step)
      .function("state", &JsSurfaceSession::state)
      .function("result", &looked<&JsSurfaceSession::result>)
      .function("surface", &looked<&JsSurfaceSession::surface>)
      .function("features", &looked<&JsSurfaceSession::features>)
      .function("sizes", &looked<&JsSurfaceSession::sizes>)
      .function("crosses", &looked<&JsSurfaceSession::crosses>)
      .function("charts", &looked<&JsSurfaceSession::charts>)
      .function("cells", &looked<&JsSurfaceSession::cells>)
      .function("quads", &looked<&JsSurfaceSession::quads>);
}

}  // namespace lpq
