// What must hold for every clipped Voronoi diagram.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/lp_problem.h"
#include "voronoi/clipped.h"

namespace lpq_test {

struct AreaReport {
  double sum = 0;       // of all fan triangles, signed
  double least = 0;     // the most negative fan triangle
  double negative = 0;  // sum of the negative ones
};

inline AreaReport fan_areas(const TriMesh& mesh, const lpq::ClippedVoronoi& voronoi) {
  AreaReport report;
  for (const lpq::FanTriangle& fan : voronoi.cells.values) {
    const Vec2 x = mesh.points[fan.site];
    const double area =
        0.5 * cross(voronoi.vertices[fan.c1].point - x, voronoi.vertices[fan.c2].point - x);
    report.sum += area;
    report.least = std::min(report.least, area);
    report.negative += std::min(0.0, area);
  }
  return report;
}

/// How well double precision can place a vertex: 1 for generators in general position, 0 for three
/// collinear ones or a bisector parallel to its wall.
inline double conditioning(const TriMesh& mesh, const lpq::VoronoiVertex& vertex) {
  const auto point = [&](int k) { return mesh.points[vertex.sites[k]]; };
  if (vertex.kind == lpq::VertexKind::three_bisectors) {
    const Vec2 u = point(1) - point(0), v = point(2) - point(0);
    const double longest = std::max({length(u), length(v), length(v - u)});
    return cross(u, v) / (longest * longest);
  }
  const Vec2 across = point(1) - point(0);
  const Vec2 wall = mesh.points[mesh.target(vertex.wall)] - mesh.points[mesh.origin(vertex.wall)];
  return dot(across, wall) / (length(across) * length(wall));
}

/// Largest difference between a vertex's distances to its generators, times conditioning, relative
/// to the mesh's extent (a vertex on a wall is as exact as the wall's ends).
inline double equidistance_error(const TriMesh& mesh, const lpq::ClippedVoronoi& voronoi) {
  double worst = 0, extent = 0;
  for (const Vec2 p : mesh.points) extent = std::max(extent, length(p));
  for (const lpq::VoronoiVertex& vertex : voronoi.vertices) {
    if (vertex.kind == lpq::VertexKind::corner) continue;
    std::vector<double> radii;
    for (const Index s : vertex.sites)
      if (s != lpq::none) radii.push_back(distance(vertex.point, mesh.points[s]));
    const auto [nearest, farthest] = std::minmax_element(radii.begin(), radii.end());
    worst = std::max(worst, (*farthest - *nearest) / extent * conditioning(mesh, vertex));
  }
  return worst;
}

}  // namespace lpq_test
