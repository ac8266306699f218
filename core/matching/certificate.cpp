#include "matching/certificate.h"

#include <algorithm>
#include <vector>

#include "base/disjoint_sets.h"

namespace lpq {
namespace {

// Bound on every dual, so that a slack, a sum of a few of them, cannot overflow.
constexpr std::int64_t dual_range = std::int64_t{1} << 60;

/// An exact sum of 64-bit numbers.
class WideSum {
 public:
  void add(std::int64_t x) {
    low_ += static_cast<std::int64_t>(static_cast<std::uint64_t>(x) & 0xFFFFFFFFu);
    high_ += x >> 32;
  }
  bool operator==(const WideSum& other) const {
    return high_ + (low_ >> 32) == other.high_ + (other.low_ >> 32) &&
           (low_ & 0xFFFFFFFF) == (other.low_ & 0xFFFFFFFF);
  }

 private:
  std::int64_t low_ = 0, high_ = 0;
};

std::string at(const char* what, Index i) { return std::string(what) + " " + std::to_string(i); }

bool in_range(std::int64_t dual) { return dual >= -dual_range && dual <= dual_range; }

/// The mates are mutual and joined by the edges named; unmatched nodes are counted.
std::string check_mates(Index node_count, std::span<const CostEdge> edges, const Matching& matching,
                        Index& unmatched) {
  const auto count = static_cast<std::size_t>(node_count);
  if (matching.mate.size() != count || matching.edge.size() != count) {
    return "the arrays of mates and edges have not one entry per node";
  }
  unmatched = 0;
  WideSum claimed, actual;
  claimed.add(matching.cost);
  for (Index v = 0; v < node_count; ++v) {
    const Index mate = matching.mate[v], edge = matching.edge[v];
    if (mate == none && edge == none) {
      ++unmatched;
      continue;
    }
    if (mate < 0 || mate >= node_count || matching.mate[mate] != v) {
      return at("not matched mutually: node", v);
    }
    if (edge < 0 || edge >= static_cast<Index>(edges.size())) {
      return at("matched by an edge that is not there: node", v);
    }
    const CostEdge& e = edges[edge];
    if (!((e.u == v && e.v == mate) || (e.v == v && e.u == mate))) {
      return at("matched by an edge that joins other nodes: node", v);
    }
    if (matching.edge[mate] != edge) return at("matched by two different edges: node", v);
    if (v < mate) actual.add(e.cost);
  }
  if (!(claimed == actual)) return "the cost is not that of the matched edges";
  return {};
}

/// Sums of z from the outside in, and heavy paths for common ancestors in logarithmic time.
struct Laminar {
  std::vector<std::int64_t> around;  // #ids  z of it and of all blossoms around it
  std::vector<Index> top;            // #ids  outermost member of its heavy path
};

/// Parents have greater ids than children, so one sweep up sums sizes and one down everything else.
std::string check_family(Index node_count, const MatchingDuals& duals, Laminar& family) {
  const auto blossom_count = static_cast<Index>(duals.z.size());
  const Index ids = node_count + blossom_count;
  if (static_cast<Index>(duals.y.size()) != node_count ||
      static_cast<Index>(duals.parent.size()) != ids) {
    return "the arrays of duals have the wrong lengths";
  }
  std::vector<Index> size(ids, 0), heavy(ids, none);
  std::fill(size.begin(), size.begin() + node_count, 1);
  for (Index i = 0; i < ids; ++i) {
    if (i >= node_count && size[i] % 2 == 0) return at("not an odd set: blossom", i - node_count);
    const Index parent = duals.parent[i];
    if (parent == none) continue;
    if (parent <= i || parent < node_count || parent >= ids) return at("bad parent of id", i);
    size[parent] += size[i];
    if (heavy[parent] == none || size[i] > size[heavy[parent]]) heavy[parent] = i;
  }
  family.around.assign(ids, 0);
  family.top.resize(ids);
  for (Index i = ids - 1; i >= 0; --i) {
    const Index parent = duals.parent[i];
    const std::int64_t z = i >= node_count ? duals.z[i - node_count] : 0;
    if (z < 0 || !in_range(z)) return at("z is negative or too large: blossom", i - node_count);
    family.around[i] = z + (parent == none ? 0 : family.around[parent]);
    if (!in_range(family.around[i])) return at("duals too large around id", i);
    family.top[i] = parent != none && heavy[parent] == i ? family.top[parent] : i;
  }
  return {};
}

/// Sum of z over the blossoms around both.
std::int64_t around_both(const MatchingDuals& duals, const Laminar& family, Index a, Index b) {
  while (family.top[a] != family.top[b]) {
    Index& inner = family.top[a] < family.top[b] ? a : b;  // its path cannot hold the ancestor
    inner = duals.parent[family.top[inner]];
    if (inner == none) return 0;
  }
  return family.around[std::max(a, b)];
}

std::string check_optimal(Index node_count, std::span<const CostEdge> edges,
                          const Matching& matching) {
  const MatchingDuals& duals = matching.duals;
  Laminar family;
  if (std::string fault = check_family(node_count, duals, family); !fault.empty()) return fault;
  WideSum primal, dual;
  for (int twice = 0; twice < 2; ++twice) primal.add(matching.cost);
  for (Index v = 0; v < node_count; ++v) {
    if (!in_range(duals.y[v])) return at("dual too large: node", v);
    dual.add(duals.y[v]);
  }
  for (const std::int64_t z : duals.z) dual.add(z);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const CostEdge& e = edges[i];
    const std::int64_t cut =
        family.around[e.u] + family.around[e.v] - 2 * around_both(duals, family, e.u, e.v);
    if (2 * e.cost - duals.y[e.u] - duals.y[e.v] - cut < 0) {
      return at("negative slack: edge", static_cast<Index>(i));
    }
  }
  if (!(primal == dual)) return "primal and dual objectives differ";
  return {};
}

/// Tutte and Berge: removing the witness W leaves `deficiency` more odd components than |W|, so any
/// matching leaves that many nodes out.
std::string check_witness(Index node_count, std::span<const CostEdge> edges,
                          const Matching& matching) {
  std::vector<char> removed(node_count, 0);
  for (const Index v : matching.witness) {
    if (v < 0 || v >= node_count || removed[v]) return "the witness names a wrong node";
    removed[v] = 1;
  }
  DisjointSets components(node_count);
  for (const CostEdge& e : edges)
    if (!removed[e.u] && !removed[e.v]) components.unite(e.u, e.v);
  std::vector<Index> size(node_count, 0);
  for (Index v = 0; v < node_count; ++v)
    if (!removed[v]) ++size[components.root(v)];
  const auto odd = static_cast<Index>(
      std::count_if(size.begin(), size.end(), [](Index nodes) { return nodes % 2 == 1; }));
  if (odd - static_cast<Index>(matching.witness.size()) != matching.deficiency) {
    return "the witness does not prove the deficiency";
  }
  return {};
}

}  // namespace

std::string check_certificate(Index node_count, std::span<const CostEdge> edges,
                              const Matching& matching) {
  if (matching.status == MatchingStatus::invalid_input) return "there is no matching";
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const CostEdge& e = edges[i];
    if (e.u < 0 || e.u >= node_count || e.v < 0 || e.v >= node_count || e.u == e.v ||
        e.cost > dual_range / 4 || e.cost < -dual_range / 4) {
      return at("invalid: edge", static_cast<Index>(i));
    }
  }
  Index unmatched = 0;
  std::string fault = check_mates(node_count, edges, matching, unmatched);
  if (!fault.empty()) return fault;
  if (unmatched != matching.deficiency) return "the deficiency is not the number of nodes left out";
  if (matching.status == MatchingStatus::no_perfect) {
    if (matching.deficiency == 0) return "called infeasible without a deficiency";
    return check_witness(node_count, edges, matching);
  }
  if (unmatched != 0) return "called perfect with nodes left out";
  return check_optimal(node_count, edges, matching);
}

}  // namespace lpq
