// See stages.h.
#include "io/stages.h"

#include <algorithm>
#include <array>

#include "io/iterates.h"
#include "io/json_write.h"
#include "io/mesh/obj.h"
#include "io/picture/svg.h"
#include "io/plain_text.h"

namespace lpq {
namespace {

TriMesh to_world(TriMesh mesh, const UnitFrame& frame) {
  for (Vec2& p : mesh.points) p = frame.to_world(p);
  return mesh;
}

OutputMesh to_world(const QuadMesh& mesh, const UnitFrame& frame) {
  OutputMesh world;
  for (const Vec2 p : mesh.points) world.points.push_back(frame.to_world(p));
  world.faces = mesh.faces;
  world.region = mesh.region;
  world.fixed = mesh.fixed;
  return world;
}

void append_points(JsonWriter& json, std::string_view name, std::span<const Vec2> points,
                   const UnitFrame& frame) {
  json.begin_array(name);
  for (const Vec2 p : points) {
    const Vec2 world = frame.to_world(p);
    json.tuple(world.x, world.y);
  }
  json.end_array();
  json.new_line();
}

/// {"points", "triangles", "twins", "region"}
std::string triangles_json(const TriMesh& mesh, const UnitFrame& frame) {
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  append_points(json, "points", mesh.points, frame);
  json.begin_array("triangles");
  for (const Tri& t : mesh.triangles) json.tuple(t[0], t[1], t[2]);
  json.end_array();
  json.new_line();
  json.array("twins", mesh.twins);
  json.new_line();
  json.array("region", mesh.region);
  json.end_object();
  out += '\n';
  return out;
}

/// {"points", "z": e^{4 i theta}, "axis": (cos, sin) theta, "singularities":[{x, y, index}..]}
std::string crosses_json(const Fields& fields, const UnitFrame& frame) {
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  append_points(json, "points", fields.background.points, frame);
  json.begin_array("z");
  for (const Vec2 z : fields.z) json.tuple(z.x, z.y);
  json.end_array();
  json.new_line();
  json.begin_array("axis");
  for (const Vec2 z : fields.z) {
    const Vec2 axis = axis_of(z);
    json.tuple(axis.x, axis.y);
  }
  json.end_array();
  json.new_line();
  json.begin_array("singularities");
  for (const Singularity& s : fields.singularities) {
    const Vec2 at = frame.to_world(s.position);
    json.begin_object();
    json.member("x", at.x);
    json.member("y", at.y);
    json.member("index", s.index);
    json.end_object();
  }
  json.end_array();
  json.end_object();
  out += '\n';
  return out;
}

std::string sizes_json(const Fields& fields, const UnitFrame& frame) {
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  append_points(json, "points", fields.background.points, frame);
  json.begin_array("h");
  for (const double h : fields.h) json.value(frame.length_to_world(h));
  json.end_array();
  json.end_object();
  out += '\n';
  return out;
}

/// {"sites":[[x,y]..], "cells":[[polygon,..],..]}: row i is the cell of site i.
std::string cells_json(const Trace& trace) {
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  append_points(json, "sites", trace.triangles.points, trace.frame);
  json.begin_array("cells");
  for (const auto& cell : cell_polygons(trace.triangles, trace.cells)) {
    json.begin_array();
    for (const std::vector<Vec2>& polygon : cell) {
      json.begin_array();
      for (const Vec2 p : polygon) {
        const Vec2 world = trace.frame.to_world(p);
        json.tuple(world.x, world.y);
      }
      json.end_array();
    }
    json.end_array();
  }
  json.end_array();
  json.end_object();
  out += '\n';
  return out;
}

/// The energy has no unit (rho = h^-(p+2)); areas and gradients are in the caller's units.
std::string energy_json(const Trace& trace, const Report& report) {
  const double scale = trace.frame.scale;
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  json.member("p", trace.norm);
  json.member("energy", trace.energy);
  json.array("history", report.energy_history);
  json.array("gradientNormHistory", report.gradient_norm_history);
  json.new_line();
  json.array("cellEnergy", trace.cell_energy);
  json.new_line();
  json.begin_array("cellArea");
  for (const double area : trace.cell_area) json.value(area / scale / scale);
  json.end_array();
  json.new_line();
  json.begin_array("gradient");
  for (const Vec2 g : trace.gradient) json.tuple(g.x * scale, g.y * scale);
  json.end_array();
  json.end_object();
  out += '\n';
  return out;
}

std::string seeds_json(const Trace& trace) {
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  append_points(json, "seeds", trace.seeds, trace.frame);
  json.member("count", trace.seeds.size());
  json.end_object();
  out += '\n';
  return out;
}

constexpr std::string_view quad_stage = "quads-";

/// "quads-1-matched": stages in order, names fit for files.
std::string quad_stage_name(std::size_t number, std::string_view name) {
  std::string text(quad_stage);
  append_integer(text, static_cast<std::int64_t>(number));
  text += '-';
  for (const char c : name) {
    text += is_letter(c) || is_digit(c) ? c : '-';
  }
  return text;
}

}  // namespace

std::string write_matching_json(std::span<const CostEdge> graph, const Matching& matching) {
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  json.member("n", matching.mate.size());
  json.member("cost", matching.cost);
  json.begin_array("edges");
  for (const CostEdge& edge : graph) json.tuple(edge.u, edge.v, edge.cost);
  json.end_array();
  json.new_line();
  json.begin_array("matching");
  for (std::size_t u = 0; u < matching.mate.size(); ++u) {
    const Index v = matching.mate[u];
    if (v > static_cast<Index>(u)) json.tuple(static_cast<Index>(u), v);
  }
  json.end_array();
  json.new_line();
  json.begin_array("y");
  for (const std::int64_t y : matching.duals.y) json.value(half_units_to_decimal(y));
  json.end_array();
  json.new_line();
  json.begin_array("blossoms");
  for (const OddSet& set : blossom_sets(matching.duals)) {
    json.begin_object();
    json.array("nodes", set.nodes);
    json.member("z", half_units_to_decimal(set.z));
    json.end_object();
  }
  json.end_array();
  json.end_object();
  out += '\n';
  return out;
}

bool is_stage_name(std::string_view name) {
  constexpr std::array<std::string_view, 17> names{
      "background.obj", "background.json", "crosses.json",   "crosses.svg",
      "sizes.json",     "seeds.json",      "start.obj",      "iterates.json",
      "iterates.bin",   "triangles.obj",   "triangles.json", "matched_triangles.obj",
      "triangles.svg",  "cells.json",      "cells.svg",      "energy.json",
      "matching.json"};
  if (std::find(names.begin(), names.end(), name) != names.end()) return true;
  return name.substr(0, quad_stage.size()) == quad_stage;
}

void write_stages(const Trace& trace, const Report& report, FileSink sink) {
  const UnitFrame& frame = trace.frame;
  const Fields& fields = *trace.fields;
  sink("background.obj", write_obj(to_world(fields.background, frame)));
  sink("background.json", triangles_json(fields.background, frame));
  sink("crosses.json", crosses_json(fields, frame));
  sink("crosses.svg", draw_crosses(fields));
  sink("sizes.json", sizes_json(fields, frame));
  sink("seeds.json", seeds_json(trace));
  sink("start.obj", write_obj(to_world(trace.start, frame)));
  write_iterates(trace, sink);
  sink("triangles.obj", write_obj(to_world(trace.triangles, frame)));
  sink("triangles.json", triangles_json(trace.triangles, frame));
  sink("matched_triangles.obj", write_obj(to_world(trace.matched_triangles, frame)));
  sink("triangles.svg", draw_triangles(trace.triangles));
  sink("cells.json", cells_json(trace));
  sink("cells.svg", draw_cells(trace.triangles, trace.cells, trace.cell_energy, trace.cell_area));
  sink("energy.json", energy_json(trace, report));
  sink("matching.json", write_matching_json(trace.graph, trace.matching));
  for (std::size_t k = 0; k < trace.quads.size(); ++k) {
    const std::string name = quad_stage_name(k + 1, trace.quads[k].name);
    sink(name + ".obj", write_obj(to_world(trace.quads[k].mesh, frame)));
    sink(name + ".svg", draw_quads(trace.quads[k].mesh));
  }
}

}  // namespace lpq
