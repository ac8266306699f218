#include "matching/blossom.h"

#include <algorithm>

#include "matching/node_order.h"
#include "matching/solver_blossoms.h"
#include "matching/solver_result.h"
#include "matching/solver_rounds.h"
#include "matching/solver_search.h"

namespace lpq {
namespace {

// Up to this cost 32 bits are tried first: potentials rarely exceed some hundred costs, and half
// the memory traffic saves about a fifth of the time. Beyond their range the work is redone in 64
// bits.
#ifndef LPQ_WIDE_POTENTIALS_ONLY
constexpr std::int64_t narrow_cost = std::int64_t{1} << 20;
#endif

bool valid(Index node_count, std::span<const CostEdge> edges, std::int64_t& largest) {
  const std::int64_t bound = max_matching_cost(node_count);
  for (const CostEdge& e : edges) {
    if (e.u < 0 || e.u >= node_count || e.v < 0 || e.v >= node_count || e.u == e.v) return false;
    if (e.cost > bound || e.cost < -bound) return false;
    largest = std::max(largest, e.cost < 0 ? -e.cost : e.cost);
  }
  return node_count >= 0;
}

template <class Int>
bool solve_with(Index node_count, std::span<const CostEdge> edges, std::span<const Index> new_id,
                const MatchingOptions& options, Matching& result) {
  BlossomSolver<Int> solver(node_count, edges, new_id);
  solver.solve();
  if (solver.range_exceeded()) return false;
  solver.write_result(edges, new_id, options.duals, result);
  return true;
}

}  // namespace

std::int64_t max_matching_cost(Index node_count) {
  std::int64_t bound = std::int64_t{1} << 40;
  for (std::int64_t nodes = std::int64_t{1} << 18; nodes < node_count; nodes *= 2) bound /= 2;
  return bound;
}

Matching min_cost_perfect_matching(Index node_count, std::span<const CostEdge> edges,
                                   const MatchingOptions& options) {
  Matching result;
  std::int64_t largest = 0;
  if (!valid(node_count, edges, largest)) {
    result.status = MatchingStatus::invalid_input;
    return result;
  }
  const std::vector<Index> new_id = compact_order(node_count, edges);
#ifndef LPQ_WIDE_POTENTIALS_ONLY
  if (largest <= narrow_cost &&
      solve_with<std::int32_t>(node_count, edges, new_id, options, result)) {
    return result;
  }
#endif
  const bool done = solve_with<std::int64_t>(node_count, edges, new_id, options, result);
  LPQ_ASSERT(done);
  static_cast<void>(done);
  return result;
}

std::vector<OddSet> blossom_sets(const MatchingDuals& duals) {
  const auto node_count = static_cast<Index>(duals.y.size());
  std::vector<OddSet> sets(duals.z.size());
  for (std::size_t b = 0; b < sets.size(); ++b) sets[b].z = duals.z[b];
  for (Index v = 0; v < node_count; ++v) {
    for (Index b = duals.parent[v]; b != none; b = duals.parent[b]) {
      sets[b - node_count].nodes.push_back(v);
    }
  }
  return sets;
}

std::string half_units_to_decimal(std::int64_t half_units) {
  const bool negative = half_units < 0;
  const std::uint64_t size = negative ? 0 - static_cast<std::uint64_t>(half_units)
                                      : static_cast<std::uint64_t>(half_units);
  std::string text = negative ? "-" : "";
  text += std::to_string(size / 2);
  if (size % 2 == 1) text += ".5";
  return text;
}

}  // namespace lpq
