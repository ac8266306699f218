// See snapshot.h.
#include "shell/snapshot.h"

#include "shell/mesh_charts.h"
#include "shell/quality.h"
#include "surface/frames.h"

namespace lpq {
namespace {

double face_eta(const ShellMesh& mesh, const Face& face) {
  if (corner_count(face) < 4) return 0;
  return quad_eta(mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]],
                  mesh.points[face[3]]);
}

}  // namespace

FeatureLayer feature_layer(const SurfaceMesher& mesher) {
  const SurfaceFeatures& features = mesher.features();
  FeatureLayer layer;
  for (Index edge = 0; edge < features.edges.count(); ++edge)
    if (features.is_feature(edge)) {
      layer.edges.push_back(features.edges.ends[edge]);
      layer.kinds.push_back(static_cast<Index>(features.kind[edge]));
    }
  for (std::size_t v = 0; v < features.corner.size(); ++v)
    if (features.corner[v]) layer.corners.push_back(static_cast<Index>(v));
  layer.faces = features.face;
  return layer;
}

SurfaceCrossLayer cross_layer(const SurfaceMesher& mesher) {
  SurfaceCrossLayer layer;
  layer.singularities = mesher.cross_field().singularities;
  Index t = 0;
  for (const Vec2 z : mesher.cross_field().z) {
    const TriangleAxes axes = axes_of(mesher.surface(), t++);
    const Vec2 arm = axis_of(z);
    layer.axes.push_back(arm.x * axes.x + arm.y * axes.y);
  }
  return layer;
}

ChartLayer chart_layer(const SurfaceMesher& mesher) {
  const Atlas& atlas = mesher.atlas();
  ChartLayer layer;
  if (atlas.charts.empty()) return layer;
  const SurfaceMesh& surface = mesher.surface();
  layer.charts.assign(surface.triangles.size(), none);
  layer.uv.resize(3 * surface.triangles.size());
  for (std::size_t c = 0; c < atlas.charts.size(); ++c) {
    const Chart& chart = atlas.charts[c];
    for (std::size_t t = 0; t < chart.triangles.size(); ++t) {
      layer.charts[chart.triangles[t]] = static_cast<Index>(c);
      for (int k = 0; k < 3; ++k)
        layer.uv[3 * chart.triangles[t] + k] = chart.plane.points[chart.plane.triangles[t][k]];
    }
  }
  for (Index e = 0; e < static_cast<Index>(atlas.cut.size()); ++e)
    if (atlas.cut[e] && surface.twins[e] > e && !mesher.features().half_edge_is_feature(e))
      layer.cuts.push_back({surface.origin(e), surface.target(e)});
  return layer;
}

ChartCellLayer chart_cell_layer(const SurfaceMesher& mesher) {
  ChartCellLayer layer;
  const ChartsMesher* charts = mesher.charts();
  if (charts == nullptr || charts->plane() == nullptr) return layer;
  layer.chart = charts->chart();
  layer.plane = cell_layer(*charts->plane());
  layer.points = charts->lifted(layer.plane.polygons.values);
  return layer;
}

ShellLayer shell_layer(const SurfaceMesher& mesher) {
  const ShellMesh& mesh = mesher.mesh();
  ShellLayer layer;
  layer.points = mesh.points;
  layer.valence.assign(mesh.points.size(), 0);
  for (const Pin pin : mesh.pins) layer.pins.push_back(static_cast<Index>(pin));
  layer.edges = mesh.edges;
  for (const int corners : {4, 3})
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Face& face = mesh.faces[f];
      if (corner_count(face) != corners) continue;
      layer.faces.push_back(face);
      layer.regions.push_back(mesh.face[f]);
      layer.eta.push_back(face_eta(mesh, face));
      for (int k = 0; k < corners; ++k) ++layer.valence[face[k]];
    }
  return layer;
}

}  // namespace lpq
