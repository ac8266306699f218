// Random graphs and mesh duals to match, and the truth for small ones by enumeration.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/rng.h"
#include "matching/blossom.h"

namespace lpq::test {

struct MatchingInstance {
  Index node_count = 0;
  std::vector<CostEdge> edges;
};

struct EnumeratedMatching {
  Index deficiency = 0;
  std::int64_t cost = 0;  // least one, when the deficiency is 0
};

/// Dynamic programme over all node subsets: O(2^n n).
inline EnumeratedMatching enumerate_matchings(const MatchingInstance& instance) {
  const Index n = instance.node_count;
  constexpr std::int64_t unreachable = std::numeric_limits<std::int64_t>::max() / 2;
  std::vector<std::int64_t> pair_cost(n * n, unreachable);
  for (const CostEdge& e : instance.edges) {
    std::int64_t& least = pair_cost[std::min(e.u, e.v) * n + std::max(e.u, e.v)];
    least = std::min(least, e.cost);
  }
  const std::size_t subsets = std::size_t{1} << n;
  std::vector<std::int64_t> least(subsets, unreachable);
  std::vector<Index> left_out(subsets, 0);
  least[0] = 0;
  for (std::size_t set = 1; set < subsets; ++set) {
    Index first = 0;
    while ((set >> first & 1) == 0) ++first;
    const std::size_t rest = set & ~(std::size_t{1} << first);
    left_out[set] = left_out[rest] + 1;
    for (Index other = first + 1; other < n; ++other) {
      const std::int64_t cost = pair_cost[first * n + other];
      if ((rest >> other & 1) == 0 || cost == unreachable) continue;
      const std::size_t without = rest & ~(std::size_t{1} << other);
      left_out[set] = std::min(left_out[set], left_out[without]);
      if (least[without] < unreachable) least[set] = std::min(least[set], least[without] + cost);
    }
  }
  return {left_out[subsets - 1], least[subsets - 1]};
}

/// `edge_count` random edges, parallel ones included, costs in lo .. hi.
inline MatchingInstance random_graph(Rng& rng, Index node_count, Index edge_count, std::int64_t lo,
                                     std::int64_t hi) {
  MatchingInstance instance{node_count, {}};
  if (node_count < 2) return instance;
  for (Index i = 0; i < edge_count; ++i) {
    const auto u = static_cast<Index>(rng.below(node_count));
    auto v = static_cast<Index>(rng.below(node_count - 1));
    if (v >= u) ++v;
    const auto span = static_cast<double>(hi - lo + 1);
    instance.edges.push_back({u, v, lo + static_cast<std::int64_t>(rng.unit() * span)});
  }
  return instance;
}

enum class DualCosts { shape, uniform, ties, heavy_tailed };

/// The dual graph of a jittered grid of side x side cells, each cut along a random diagonal: a node
/// per triangle, an edge per inner edge, and an extra edge between the triangles of neighbouring
/// boundary edges, as in Blossom-Quad. Shape cost: 10^4 (1 - smallest sine of the quad's corners).
class DualOfGrid {
 public:
  DualOfGrid(Rng& rng, Index side, DualCosts costs, double jitter = 0.4) : side_(side) {
    for (Index j = 0; j <= side; ++j) {
      for (Index i = 0; i <= side; ++i) {
        const bool inner = i > 0 && i < side && j > 0 && j < side;
        const double reach = inner ? jitter : 0;
        points_.push_back({i + rng.between(-reach, reach), j + rng.between(-reach, reach)});
      }
    }
    add_triangles(rng);
    connect(rng, costs);
  }
  MatchingInstance take() { return std::move(instance_); }

 private:
  using Point = std::array<double, 2>;
  using Triangle = std::array<Index, 3>;

  Index at(Index i, Index j) const { return j * (side_ + 1) + i; }

  void add_triangles(Rng& rng) {
    for (Index j = 0; j < side_; ++j) {
      for (Index i = 0; i < side_; ++i) {
        const Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
        if (rng.below(2) == 0) {
          triangles_.insert(triangles_.end(), {Triangle{a, b, c}, Triangle{a, c, d}});
        } else {
          triangles_.insert(triangles_.end(), {Triangle{a, b, d}, Triangle{b, c, d}});
        }
      }
    }
    instance_.node_count = static_cast<Index>(triangles_.size());
  }

  void connect(Rng& rng, DualCosts costs) {
    std::map<std::pair<Index, Index>, Index> open;  // directed edge -> triangle
    for (Index t = 0; t < instance_.node_count; ++t) {
      for (int k = 0; k < 3; ++k) {
        const Index a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
        const auto twin = open.find({b, a});
        if (twin == open.end()) {
          open[{a, b}] = t;
          continue;
        }
        instance_.edges.push_back({t, twin->second, cost(rng, costs, a, b, t, twin->second)});
        open.erase(twin);
      }
    }
    std::map<Index, Index> starting_at;
    for (const auto& [edge, t] : open) starting_at[edge.first] = t;
    for (const auto& [edge, t] : open) {
      const Index next = starting_at[edge.second];
      if (t != next) instance_.edges.push_back({t, next, 15000});
    }
  }

  std::int64_t cost(Rng& rng, DualCosts costs, Index a, Index b, Index t, Index other) const {
    if (costs == DualCosts::uniform) return static_cast<std::int64_t>(rng.below(10001));
    if (costs == DualCosts::ties) return static_cast<std::int64_t>(rng.below(4));
    if (costs == DualCosts::heavy_tailed) {
      const double u = rng.unit() + 1e-6;
      return static_cast<std::int64_t>(std::min(1e6, 50 / (u * std::sqrt(u))));
    }
    const auto apex = [&](Index s) {
      for (const Index v : triangles_[s]) {
        if (v != a && v != b) return v;
      }
      return none;
    };
    const std::array<Index, 4> quad{a, apex(other), b, apex(t)};
    double worst = 1;
    for (int k = 0; k < 4; ++k) {
      const Point &p = points_[quad[k]], &q = points_[quad[(k + 1) % 4]],
                  &r = points_[quad[(k + 3) % 4]];
      const double ux = q[0] - p[0], uy = q[1] - p[1], vx = r[0] - p[0], vy = r[1] - p[1];
      const double sine =
          (ux * vy - uy * vx) / std::sqrt((ux * ux + uy * uy) * (vx * vx + vy * vy));
      worst = std::min(worst, std::max(0.0, sine));
    }
    return static_cast<std::int64_t>(1e4 * (1 - worst));
  }

  Index side_;
  std::vector<Point> points_;
  std::vector<Triangle> triangles_;
  MatchingInstance instance_;
};

inline MatchingInstance dual_of_grid(std::uint64_t seed, Index side, DualCosts costs,
                                     double jitter = 0.4) {
  Rng rng(seed);
  return DualOfGrid(rng, side, costs, jitter).take();
}

}  // namespace lpq::test
