// Problems for tests of the clipped Voronoi diagram, the energy and the optimiser: boundaries with
// walls and holes, points scattered inside, fields given by formulas.
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "base/rng.h"
#include "catch.h"
#include "delaunay/delaunay.h"
#include "delaunay/locate.h"
#include "domain/boundary.h"
#include "field/field.h"
#include "geometry/predicates.h"
#include "support/field_boundary.h"

namespace lpq_test {

using lpq::BoundaryMesh;
using lpq::Index;
using lpq::TriMesh;
using lpq::Vec2;

/// The nodes and edges of a domain as they are, with no demand for even counts.
inline BoundaryMesh raw_boundary(const lpq::Domain& domain) {
  BoundaryMesh boundary;
  boundary.points = boundary.world = domain.points;
  boundary.edges = domain.segments;
  boundary.spacing.assign(domain.points.size(), 0.0);
  std::vector<int> degree(domain.points.size(), 0);
  for (const lpq::Segment& edge : domain.segments)
    for (const Index v : {edge.a, edge.b}) {
      boundary.spacing[v] += distance(domain.points[edge.a], domain.points[edge.b]);
      ++degree[v];
    }
  for (Index i = 0; i < static_cast<Index>(degree.size()); ++i) {
    if (degree[i] > 0) boundary.spacing[i] /= degree[i];
    boundary.source.push_back(i);
    boundary.output_rank.push_back(i);
  }
  return boundary;
}

/// Adds an open polyline of walls with the domain on both sides.
inline void add_wall(BoundaryMesh& boundary, std::span<const Vec2> points) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Index at = static_cast<Index>(boundary.points.size());
    if (k > 0) boundary.edges.push_back({at - 1, at, 0, 0, lpq::none, lpq::none, lpq::none, 0});
    boundary.points.push_back(points[k]);
    boundary.world.push_back(points[k]);
    boundary.source.push_back(lpq::none);
    boundary.output_rank.push_back(at);
    boundary.spacing.push_back(distance(points[0], points[1]));
  }
}

inline TriMesh triangulated(const BoundaryMesh& boundary, std::span<const Vec2> interior) {
  auto mesh = lpq::triangulate(boundary, interior);
  INFO((mesh ? "" : mesh.error().message));
  REQUIRE(mesh.has_value());
  return *std::move(mesh);
}

inline double mesh_area(const TriMesh& mesh) {
  double sum = 0;
  for (const lpq::Tri& t : mesh.triangles) {
    const Vec2 a = mesh.points[t[0]];
    sum += 0.5 * cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a);
  }
  return sum;
}

/// Points strictly inside: random barycentric points of triangles chosen by area. `hug` > 1 draws
/// them towards the triangles' sides (weights raised to that power).
inline std::vector<Vec2> scattered(const BoundaryMesh& boundary, int count, std::uint64_t seed,
                                   int hug = 1) {
  const TriMesh mesh = triangulated(boundary, {});
  const double area = mesh_area(mesh);
  lpq::Rng rng(seed);
  std::vector<Vec2> points;
  double due = 0;
  for (const lpq::Tri& t : mesh.triangles) {
    const Vec2 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
    due += 0.5 * cross(b - a, c - a) / area * count;
    while (due > 0 && static_cast<int>(points.size()) < count) {
      due -= 1;
      double w[3], sum = 0;
      for (double& x : w) {
        x = rng.between(0.01, 1);
        const double once = x;
        for (int k = 1; k < hug; ++k) x *= once;
        sum += x;
      }
      const Vec2 p = (1 / sum) * (w[0] * a + w[1] * b + w[2] * c);
      if (orient2d(a, b, p) > 0 && orient2d(b, c, p) > 0 && orient2d(c, a, p) > 0)
        points.push_back(p);
    }
  }
  return points;
}

/// Fields on the bare triangulation of the boundary and some inner points, from formulas.
inline lpq::Fields fields_of(const BoundaryMesh& boundary, std::function<double(Vec2)> theta,
                             std::function<double(Vec2)> size, int inner = 0) {
  lpq::Fields fields;
  fields.background = triangulated(boundary, scattered(boundary, inner, 99));
  for (const Vec2 p : fields.background.points) {
    fields.z.push_back({std::cos(4 * theta(p)), std::sin(4 * theta(p))});
    fields.h.push_back(size(p));
  }
  fields.attach();
  return fields;
}

inline lpq::Fields constant_fields(const BoundaryMesh& boundary, double theta, double h) {
  return fields_of(
      boundary, [=](Vec2) { return theta; }, [=](Vec2) { return h; });
}

}  // namespace lpq_test
