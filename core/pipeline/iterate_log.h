// The meshes that the iterations of L_p pass through, for who wants to see them one by one.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mesh/tri_mesh.h"
#include "pipeline/trace.h"

namespace lpq {

/// Keeps the mesh after every iteration, or after every 2nd, 4th, ... where all of them would be
/// more than `most_points` points together.
class IterateLog {
 public:
  explicit IterateLog(std::size_t most_points = 1 << 18) : most_points_(most_points) {}

  /// `mesh` is the one after `iteration` of them (ascending from 1; the last may come twice).
  void add(int iteration, const TriMesh& mesh);
  std::vector<Iterate> take() { return std::move(kept_); }

 private:
  std::size_t most_points_;
  int stride_ = 1;
  std::vector<Iterate> kept_;
};

}  // namespace lpq
