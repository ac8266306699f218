// The background mesh: a constrained Delaunay triangulation of the domain, graded from the spacing
// of the walls up to a multiple of the target size, so that the fields are resolved where they vary
// and cheap elsewhere.
#pragma once

#include <vector>

#include "base/function_ref.h"
#include "base/result.h"
#include "domain/boundary.h"
#include "field/quadtree.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// A place where the background must be no coarser than `side`.
struct Source {
  Vec2 position;
  double side = 0;
};

struct FineBackground {
  TriMesh mesh;
  std::vector<double> interior_values;  // at the vertices behind those of the boundary, in order
};

class BackgroundBuilder {
 public:
  /// `coarsest`: no leaf that meets the domain is larger; 0 for no such bound.
  BackgroundBuilder(const BoundaryMesh& boundary, const std::vector<Source>& sources,
                    double coarsest);

  /// Makes fine() at least as fine at more places.
  void refine(const std::vector<Source>& sources);

  /// Graded by the walls alone: leaves grow with the distance to them. About O(#B log) vertices.
  Result<TriMesh> coarse() const;

  /// Refines so that no leaf is larger than `largest_leaf(t, weights, point)`, a function on the
  /// triangles of the coarse mesh given barycentric weights and the point they describe (always in
  /// the triangle). `interior_value`, same arguments, is then read at each new interior vertex.
  /// Errors: too_many_elements where that needs more than `most_leaves` new ones.
  using OnCoarse = FunctionRef<double(Index t, const double (&weights)[3], Vec2 point)>;
  Result<FineBackground> fine(const TriMesh& coarse, OnCoarse largest_leaf, OnCoarse interior_value,
                              double most_leaves);

 private:
  struct Interior {
    std::vector<Vec2> centres;
    std::vector<double> values;
  };

  void refine_inside(double coarsest);
  Problem split_leaves(const TriMesh& coarse, OnCoarse largest_leaf, double most_leaves);
  Interior leaves_inside(const TriMesh& coarse, OnCoarse value_at) const;
  std::vector<char> blocked_leaves() const;

  const BoundaryMesh& boundary_;
  Quadtree tree_;
};

}  // namespace lpq
