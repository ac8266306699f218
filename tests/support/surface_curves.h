// What must hold of the 1D mesh of every surface.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "catch.h"
#include "surface/curve_counts.h"
#include "surface/curves.h"

namespace lpq_test {

/// Every feature edge is on one curve, between corners, with the same faces all along.
inline void check_curves(const lpq::SurfaceMesh& mesh, const lpq::SurfaceFeatures& features,
                         const lpq::SurfaceCurves& curves) {
  using lpq::Index;
  std::vector<Index> times(features.edges.ends.size(), 0);
  Index bad = 0;
  for (Index c = 0; c < curves.count(); ++c) {
    const auto vertices = curves.vertices.row(c);
    const auto edges = curves.edges.row(c);
    REQUIRE(vertices.size() == edges.size() + 1);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      ++times[edges[k]];
      bad += features.edges.other_end(edges[k], vertices[k]) != vertices[k + 1];
      bad += k > 0 && features.corner[vertices[k]];
      std::vector<Index> faces;
      for (const Index e : features.edges.half_edges.row(edges[k]))
        faces.push_back(features.face[lpq::triangle_of(e)]);
      std::sort(faces.begin(), faces.end());
      const auto row = curves.faces.row(c);
      bad += !std::equal(faces.begin(), faces.end(), row.begin(), row.end());
    }
    bad += features.corner[vertices.front()] != features.corner[vertices.back()];
    bad += curves.is_loop[c] && vertices.front() != vertices.back();
    bad += curves.is_loop[c] == features.corner[vertices.front()];
  }
  for (Index i = 0; i < features.edges.count(); ++i) bad += times[i] != features.is_feature(i);
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    if (mesh.twins[e] == lpq::none || features.half_edge_is_feature(e)) continue;
    bad += features.face[lpq::triangle_of(e)] != features.face[lpq::triangle_of(mesh.twins[e])];
  }
  CHECK(bad == 0);
}

/// Nodes lie where their places say, curves meet in corners, every face can be all quads.
inline void check_curve_mesh(const lpq::SurfaceMesh& mesh, const lpq::SurfaceFeatures& features,
                             const lpq::SurfaceCurves& curves, const lpq::CurveMesh& nodes) {
  using lpq::Index;
  Index bad = 0;
  REQUIRE(nodes.points.size() == nodes.places.size());
  for (std::size_t n = 0; n < nodes.points.size(); ++n) {
    const lpq::CurvePlace& place = nodes.places[n];
    if (place.vertex != lpq::none) {
      bad += !features.corner[place.vertex] || nodes.node_of_corner[place.vertex] != Index(n) ||
             !(nodes.points[n] == mesh.points[place.vertex]);
      continue;
    }
    const auto vertices = curves.vertices.row(place.curve);
    const lpq::Vec3 a = mesh.points[vertices[place.edge]],
                    b = mesh.points[vertices[place.edge + 1]];
    bad += !(place.t >= 0 && place.t < 1) || !(nodes.points[n] == a + place.t * (b - a));
  }
  std::vector<Index> counts;
  std::vector<std::array<Index, 2>> edges;
  for (Index c = 0; c < curves.count(); ++c) {
    const auto row = nodes.nodes.row(c);
    counts.push_back(static_cast<Index>(row.size()) - 1);
    bad += row.front() == row.back() && counts.back() < 4;
    bad +=
        !curves.is_loop[c] && row.front() != nodes.node_of_corner[curves.vertices.row(c).front()];
    bad += !curves.is_loop[c] && row.back() != nodes.node_of_corner[curves.vertices.row(c).back()];
    for (std::size_t k = 1; k < row.size(); ++k)
      edges.push_back({std::min(row[k - 1], row[k]), std::max(row[k - 1], row[k])});
  }
  CHECK(bad == 0);
  for (const Index n : lpq::face_counts(curves, features.face_count, counts)) bad += n % 2;
  CHECK(bad == 0);
  std::sort(edges.begin(), edges.end());
  CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end());
}

}  // namespace lpq_test
