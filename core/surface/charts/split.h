// Where to cut a part that has no good map: along the shortest way between two of its borders, or
// between triangles that are nearest to different ones of a few that lie far apart.
#pragma once

#include <span>
#include <vector>

#include "surface/charts/part.h"

namespace lpq {

class Splitter {
 public:
  explicit Splitter(const SurfaceMesh& mesh);

  /// The shortest way from the first loop to another, inside the part: half-edges of the surface,
  /// one side each; none if there is no other loop.
  std::vector<Index> way_to_next_loop(const Part& part) const;

  /// Labels 0 .. pieces-1 of the part's triangles: nearest seed along the dual graph, seeds far
  /// apart and centred in their pieces; borders between pieces smoothed. Distances across edges
  /// count more where the surface bends by `bending`.
  std::vector<Index> far_pieces(const Part& part, Index pieces, double bending) const;

 private:
  struct Search;
  std::vector<double> steps_of(const Part& part, double bending) const;
  void spread(const Part& part, std::span<const double> steps, Search& search) const;
  std::vector<Index> centres(const Part& part, std::span<const double> steps,
                             const std::vector<Index>& owner, std::size_t pieces) const;

  std::vector<Vec3> centroid_, normal_;  // #T of the surface
};

/// Marks the edges between triangles of different labels (both sides).
void cut_between(const Part& part, std::span<const Index> labels, std::span<char> cut);

}  // namespace lpq
