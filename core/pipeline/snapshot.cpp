// See snapshot.h.
#include "pipeline/snapshot.h"

#include <algorithm>

#include "cleanup/ideal_valence.h"
#include "lpcvt/energy.h"
#include "voronoi/clipped.h"

namespace lpq {
namespace {

std::vector<Vec2> to_world(const std::vector<Vec2>& points, const UnitFrame& frame) {
  std::vector<Vec2> world;
  world.reserve(points.size());
  for (const Vec2 p : points) world.push_back(frame.to_world(p));
  return world;
}

/// Energy per cell in the workspace, the total returned.
double evaluate(const Mesher& mesher, EnergyWorkspace& workspace) {
  EnergyOptions options;
  options.p = mesher.options().norm;
  return lp_energy(mesher.triangles(), mesher.fields(), options, workspace, {});
}

}  // namespace

TriangleLayer triangle_layer(const Mesher& mesher) {
  const TriMesh& mesh = mesher.triangles();
  return {to_world(mesh.points, mesher.frame()), mesh.triangles, mesh.fixed};
}

CellLayer cell_layer(const Mesher& mesher) {
  CellLayer layer;
  const TriMesh& mesh = mesher.triangles();
  if (mesh.triangles.empty()) return layer;
  ClippedVoronoi diagram;
  clip_voronoi(mesh, diagram);
  const auto cells = cell_polygons(mesh, diagram);
  for (std::size_t v = 0; v < cells.size(); ++v) {
    for (const std::vector<Vec2>& polygon : cells[v]) {
      for (const Vec2 p : polygon) layer.polygons.values.push_back(mesher.frame().to_world(p));
      layer.polygons.end_row();
      layer.site.push_back(static_cast<Index>(v));
    }
  }
  EnergyWorkspace workspace;
  layer.energy = evaluate(mesher, workspace);
  const double area_unit = mesher.frame().scale * mesher.frame().scale;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const double area = workspace.cell_area[v];
    layer.density.push_back(area > 0 ? workspace.cell_energy[v] / area * area_unit : 0);
  }
  return layer;
}

CrossLayer cross_layer(const Mesher& mesher) {
  const Fields& fields = mesher.fields();
  CrossLayer layer;
  layer.points = to_world(fields.background.points, mesher.frame());
  for (const Vec2 z : fields.z) layer.axis.push_back(axis_of(z));
  layer.singularities = fields.singularities;
  for (Singularity& s : layer.singularities) s.position = mesher.frame().to_world(s.position);
  return layer;
}

SizeLayer size_layer(const Mesher& mesher) {
  const Fields& fields = mesher.fields();
  SizeLayer layer;
  layer.points = to_world(fields.background.points, mesher.frame());
  layer.triangles = fields.background.triangles;
  for (const double h : fields.h) layer.h.push_back(mesher.frame().length_to_world(h));
  return layer;
}

MatchingLayer matching_layer(const Mesher& mesher) {
  MatchingLayer layer;
  const Trace* trace = mesher.trace();
  if (trace == nullptr || trace->graph.empty()) return layer;
  const TriMesh& mesh = trace->matched_triangles;
  layer.points = to_world(mesh.points, mesher.frame());
  layer.triangles = mesh.triangles;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const Index mate = trace->matching.mate[t], edge = trace->matching.edge[t];
    const bool merged = mate != none && mate < mesh.triangle_count();
    bool common = false;
    for (Index e = 3 * t; e < 3 * t + 3; ++e)
      common = common || (merged && mesh.twins[e] != none && mesh.twins[e] / 3 == mate);
    layer.mate.push_back(merged ? mate : none);
    layer.extra.push_back(merged && !common ? 1 : 0);
    layer.cost.push_back(edge == none ? 0 : static_cast<double>(trace->graph[edge].cost));
  }
  return layer;
}

QuadLayer quad_layer(const Mesher& mesher) {
  QuadLayer layer;
  const QuadMesh& mesh = mesher.quads();
  if (mesh.faces.empty()) return layer;
  layer.points = to_world(mesh.points, mesher.frame());
  layer.faces = mesh.faces;
  layer.fixed = mesh.fixed;
  std::stable_partition(layer.faces.begin(), layer.faces.end(),
                        [](const Face& face) { return corner_count(face) == 4; });
  for (const Face& face : layer.faces) layer.eta.push_back(face_eta(mesh.points, face));
  const QuadTopology topology(mesh);
  const IdealValence ideal(topology);
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    const Index valence = topology.valence(v);
    layer.valence.push_back(valence);
    layer.excess.push_back(valence == 0 ? 0 : valence - ideal.wanted(v));
  }
  return layer;
}

}  // namespace lpq
