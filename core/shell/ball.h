// The triangles of a face near one of them, as far as they make a disk.
#pragma once

#include <functional>
#include <queue>
#include <span>
#include <utility>
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
  /// barrier crossed, nearest first and only while all together are a disk: round a limb they do
  /// not meet again. The disk hangs together across barriers that end inside it. The margin is what
  /// is nearer than `margin` to the open part of its border.
  Ball ball(Index centre, double radius, double margin);

 private:
  using Entry = std::pair<double, Index>;  // the index breaks ties
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  void grow(Index centre, double radius);
  bool keeps_disk(Index t) const;
  void take(Index t);
  void reach(Index t, double there);
  void measure_from_border();
  double step(Index from, Index to) const;

  const SurfaceMesh& mesh_;
  std::span<const char> barrier_;  // #half-edges
  std::vector<Vec3> centroid_;     // #T
  std::vector<double> distance_;   // #T  infinite outside calls
  std::vector<char> taken_;        // #T  0 outside calls
  std::vector<char> touched_;      // #V  by triangles taken, 0 outside calls
  std::vector<Index> reached_, disk_;
  Queue queue_;
};

}  // namespace lpq
