// Minimum-cost perfect matching in a general graph: Edmonds' blossoms, primal-dual, integer costs.
// Knows no geometry. Exact: the result comes with duals that matching/certificate.h verifies.
// [Edmonds 1965], [Gabow 1990], [Kolmogorov 2009].
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/index.h"

namespace lpq {

struct CostEdge {
  Index u = none, v = none;  // distinct nodes; parallel edges are allowed
  std::int64_t cost = 0;     // |cost| <= max_matching_cost(node_count)
};

/// The checked range: 2^40, and less beyond 2^18 nodes so that duals and sums stay below 2^60.
std::int64_t max_matching_cost(Index node_count);

enum class MatchingStatus {
  perfect,        // every node is matched at minimum total cost
  no_perfect,     // none exists; `witness` proves it (Tutte-Berge)
  invalid_input,  // an edge joins a node to itself or to no node, or a cost is out of range
};

/// Duals of the linear program min c.x, x(delta(v)) = 1, x(delta(B)) >= 1 for odd sets B, x >= 0,
/// in half units: for every edge  2 c - y_u - y_v - sum of z_B over blossoms that cut it >= 0.
/// The blossoms are a laminar family, only those with z > 0, kept as a forest because their node
/// lists together can be quadratically long: id i < #nodes is node i, id #nodes + b is blossom b.
struct MatchingDuals {
  std::vector<std::int64_t> y;  // #nodes               half units
  std::vector<std::int64_t> z;  // #blossoms            half units, > 0
  std::vector<Index> parent;    // #nodes + #blossoms   id of the smallest blossom strictly around
                                //                      it, greater than its own id; none outside
};

struct Matching {
  MatchingStatus status = MatchingStatus::perfect;
  std::vector<Index> mate;     // #nodes  partner, none if unmatched
  std::vector<Index> edge;     // #nodes  edge used, none if unmatched
  std::int64_t cost = 0;       // of the matched edges
  MatchingDuals duals;         // filled when perfect and asked for
  std::vector<Index> witness;  // when none exists: nodes whose removal leaves `deficiency` more odd
                               // components than there are nodes removed
  Index deficiency = 0;        // nodes left unmatched in a maximum-cardinality matching
};

struct MatchingOptions {
  bool duals = true;
};

/// When no perfect matching exists, `mate` is a matching of maximum cardinality (of no particular
/// cost). Cost on planar dual graphs: about linear in practice; worst case O(n m log n).
Matching min_cost_perfect_matching(Index node_count, std::span<const CostEdge> edges,
                                   const MatchingOptions& options = {});

/// A blossom written out. Total size O(nodes x nesting depth): for dumps of small graphs only.
struct OddSet {
  std::vector<Index> nodes;  // ascending
  std::int64_t z = 0;        // half units
};
std::vector<OddSet> blossom_sets(const MatchingDuals& duals);

/// Half units as the decimal number of cost units they are, exactly: 3 -> "1.5", -4 -> "-2".
std::string half_units_to_decimal(std::int64_t half_units);

}  // namespace lpq
