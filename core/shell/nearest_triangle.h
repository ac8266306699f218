// The point of a heap of triangles that is nearest to a given one.
#pragma once

#include <span>

#include "mesh/tri_mesh.h"
#include "shell/space_tree.h"

namespace lpq {

/// The point of a triangle that is nearest to p; triangles without area are edges or points.
Vec3 nearest_in_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c);

class NearestTriangle {
 public:
  /// Points and triangles (at least one) must outlive the tree. Cost O(#T log #T).
  NearestTriangle(std::span<const Vec3> points, std::span<const Tri> triangles);

  struct Hit {
    Index triangle = none;
    Vec3 point;
    double squared_distance = 0;
  };
  /// The nearest triangle, of equally near ones the first. Searches are short where `hint`, any
  /// triangle, is near already. Cost O(log #T) for surfaces.
  Hit find(Vec3 p, Index hint = 0) const;
  double distance(Vec3 p, Index& hint) const;

 private:
  void look_at(Vec3 p, Index triangle, Hit& best) const;

  std::span<const Vec3> points_;
  std::span<const Tri> triangles_;
  SpaceTree tree_;
};

}  // namespace lpq
