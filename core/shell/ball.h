// The triangles of a face near one of them.
#pragma once

#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace lpq {

struct Ball {
  std::vector<Index> triangles;  // ascending
  std::vector<char> inside;      // #triangles  0: of the margin
};

/// Finds balls again and again on one surface; keeps tables of its size between calls.
class BallFinder {
 public:
  BallFinder(const SurfaceMesh& mesh, std::span<const char> barrier);

  /// Triangles whose centroid is nearer than `radius` to that of `centre` along the dual graph, no
  /// barrier crossed, and those of a margin around them.
  Ball ball(Index centre, double radius, double margin);

 private:
  const SurfaceMesh& mesh_;
  std::span<const char> barrier_;  // #half-edges
  std::vector<Vec3> centroid_;     // #T
  std::vector<double> distance_;   // #T  infinite outside calls
};

}  // namespace lpq
