#include "cleanup/disk_patterns.h"

#include <algorithm>
#include <bitset>
#include <utility>

#include "base/sort_numbers.h"
#include "cleanup/ideal_valence.h"

namespace lpq {
namespace {

using Vertex = std::uint8_t;
using Cycle = std::vector<Vertex>;

struct Limit {
  Index loop, interior;
  double irregularity;
};
// Interior vertices tried per loop length, and the irregularity inside that is still of use: for
// regularity a repair trades a boundary defect of weight 3 for less than that inside.
constexpr Limit regular_limits[] = {{6, 3, 2}, {8, 3, 2}, {10, 2, 2}};
// For validity anything goes, down to one quad in five: an inner one and a frame of four.
constexpr Limit repair_limits[] = {{4, 4, 4}, {6, 4, 4}, {8, 4, 4}, {10, 3, 3}};

constexpr std::size_t most_vertices = 2 * largest_loop;

// Fills one polygon in all ways. The quad on the first edge (a, b) of an open cycle has two further
// corners x (beside b) and y (beside a), each a vertex of the cycle or a new interior one; what is
// left between them are shorter cycles. A fixed choice of edge makes every filling appear once.
class Filling {
 public:
  explicit Filling(const Limit& limit) : limit_(limit) {
    Cycle loop;
    for (Index i = 0; i < limit.loop; ++i) loop.push_back(static_cast<Vertex>(i));
    open_.push_back(std::move(loop));
    next_vertex_ = limit.loop;
    fill();
  }
  std::vector<DiskPattern> take() { return std::move(found_); }

 private:
  void fill() {
    if (open_.empty()) {
      keep();
      return;
    }
    const Cycle cycle = std::move(open_.back());
    open_.pop_back();
    const Index n = static_cast<Index>(cycle.size());
    const bool one_more = next_vertex_ < limit_.loop + limit_.interior;
    const bool two_more = next_vertex_ + 1 < limit_.loop + limit_.interior;
    for (Index j = 2; j < n; j += 2) {
      for (Index k = j + 1; k < n; k += 2) place(cycle, j, k);
      if (one_more) place(cycle, j, none);
    }
    if (one_more)
      for (Index k = 3; k < n; k += 2) place(cycle, none, k);
    if (two_more) place(cycle, none, none);
    open_.push_back(cycle);
  }

  // x = cycle[j], y = cycle[k], none = a new vertex.
  void place(const Cycle& cycle, Index j, Index k) {
    const Index vertices = next_vertex_;
    const std::size_t cycles = open_.size();
    const Vertex x = j == none ? new_vertex() : cycle[j];
    const Vertex y = k == none ? new_vertex() : cycle[k];
    quads_.push_back({cycle[0], cycle[1], x, y});
    const Index n = static_cast<Index>(cycle.size());
    // Along the cycle from b round to a, cut at x and y where these lie on it.
    Cycle rest(cycle.begin() + 1, cycle.end());
    rest.push_back(cycle[0]);
    const auto piece = [&](Index from, Index to, std::initializer_list<Vertex> closing) {
      Cycle part(rest.begin() + from, rest.begin() + to + 1);
      part.insert(part.end(), closing);
      if (part.size() > 2) open_.push_back(std::move(part));
    };
    if (j != none && k != none) {
      piece(0, j - 1, {});
      piece(j - 1, k - 1, {});
      piece(k - 1, n - 1, {});
    } else if (j != none) {
      piece(0, j - 1, {});
      piece(j - 1, n - 1, {y});
    } else if (k != none) {
      piece(0, k - 1, {x});
      piece(k - 1, n - 1, {});
    } else {
      piece(0, n - 1, {y, x});
    }
    fill();
    open_.resize(cycles);
    quads_.pop_back();
    next_vertex_ = vertices;
  }

  Vertex new_vertex() { return static_cast<Vertex>(next_vertex_++); }

  void keep() {
    DiskPattern pattern;
    std::array<Vertex, most_vertices> valence{};
    for (const auto& quad : quads_)
      for (const Vertex v : quad) ++valence[v];
    for (Index v = limit_.loop; v < next_vertex_; ++v) {
      if (valence[v] < 3) return;
      pattern.irregularity += irregularity(valence[v], 4, false);
    }
    if (pattern.irregularity > limit_.irregularity || has_double_edge()) return;
    pattern.interior = next_vertex_ - limit_.loop;
    std::copy_n(valence.begin(), limit_.loop, pattern.quads_at.begin());
    pattern.quads = quads_;
    found_.push_back(std::move(pattern));
  }

  bool has_double_edge() const {
    std::array<std::bitset<most_vertices>, most_vertices> edges;
    for (const auto& quad : quads_)
      for (int k = 0; k < 4; ++k) {
        auto edge = edges[quad[k]][quad[(k + 1) % 4]];
        if (edge) return true;
        edge = true;
      }
    return false;
  }

  const Limit& limit_;
  std::vector<Cycle> open_;
  Index next_vertex_ = 0;
  std::vector<std::array<Vertex, 4>> quads_;
  std::vector<DiskPattern> found_;
};

}  // namespace

std::span<const DiskPattern> DiskPatterns::of_loop(Index length) {
  if (length < 0 || length > largest_loop) return {};
  std::vector<DiskPattern>& patterns = by_loop_[length];
  if (made_[length]) return patterns;
  made_[length] = true;
  const std::span<const Limit> limits = set_ == PatternSet::regular
                                            ? std::span<const Limit>(regular_limits)
                                            : std::span<const Limit>(repair_limits);
  std::vector<DiskPattern> found;
  for (const Limit& limit : limits)
    if (limit.loop == length) found = Filling(limit).take();
  const std::vector<Index> order = sorted_numbers(found.size(), [&](Index i, Index j) {
    const double a = found[i].irregularity, b = found[j].irregularity;
    return a != b ? a < b : i < j;
  });
  patterns.reserve(found.size());
  for (const Index i : order) patterns.push_back(std::move(found[i]));
  return patterns;
}

}  // namespace lpq
