#include "matching/node_order.h"

#include <utility>

#include "base/csr.h"

namespace lpq {
namespace {

Csr<Index> neighbour_lists(Index node_count, std::span<const CostEdge> edges) {
  return csr_from<Index>(node_count, [&](auto&& emit) {
    for (std::size_t i = edges.size(); i-- > 0;) {
      emit(edges[i].v, edges[i].u);
      emit(edges[i].u, edges[i].v);
    }
  });
}

/// Breadth first from `start` over unnumbered nodes until the patch is full; the nodes where it had
/// to stop become seeds of further patches.
class PatchOrder {
 public:
  PatchOrder(Index node_count, std::span<const CostEdge> edges)
      : neighbours_(neighbour_lists(node_count, edges)), new_id_(node_count, none) {}

  std::vector<Index> run() {
    std::size_t next_seed = 0;
    for (Index start = 0; start < neighbours_.rows(); ++start) {
      if (new_id_[start] != none) continue;
      grow_patch(start);
      for (; next_seed < seeds_.size(); ++next_seed) {
        if (new_id_[seeds_[next_seed]] == none) grow_patch(seeds_[next_seed]);
      }
    }
    return std::move(new_id_);
  }

 private:
  // Some hundred bytes per node of solver state: a patch fits the second-level cache.
  static constexpr Index patch_size = 8192;

  void grow_patch(Index start) {
    const Index end = count_ + patch_size;
    queue_.clear();
    visit(start);
    for (std::size_t at = 0; at < queue_.size(); ++at) {
      for (const Index to : neighbours_.row(queue_[at])) {
        if (new_id_[to] != none) continue;
        if (count_ < end) {
          visit(to);
        } else {
          seeds_.push_back(to);
        }
      }
    }
  }

  void visit(Index v) {
    new_id_[v] = count_++;
    queue_.push_back(v);
  }

  Csr<Index> neighbours_;
  std::vector<Index> new_id_, queue_, seeds_;
  Index count_ = 0;
};

}  // namespace

std::vector<Index> compact_order(Index node_count, std::span<const CostEdge> edges) {
  return PatchOrder(node_count, edges).run();
}

}  // namespace lpq
