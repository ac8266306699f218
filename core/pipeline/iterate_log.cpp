// See iterate_log.h.
#include "pipeline/iterate_log.h"

namespace lpq {

void IterateLog::add(int iteration, const TriMesh& mesh) {
  if (iteration % stride_ != 0 || (!kept_.empty() && kept_.back().iteration >= iteration)) return;
  kept_.push_back({iteration, mesh});
  while (kept_.size() > 1 && kept_.size() * mesh.points.size() > most_points_) {
    stride_ *= 2;
    std::erase_if(kept_, [&](const Iterate& one) { return one.iteration % stride_ != 0; });
  }
}

}  // namespace lpq
