#include "surface/curve_counts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/disjoint_sets.h"
#include "base/sort_numbers.h"
#include "surface/balance_counts.h"

namespace lpq {
namespace {

constexpr Index fewest_of_closed = 4;
constexpr Index fewest_in_ring = 6;  // a square's sides would be off by more than narrow quads bear
// Of the steps on both sides; a third more on one than on the other.
constexpr double most_difference = 0.15;
constexpr double most_in_ring = 0.35;  // twice as many

Index rounded(double x) { return static_cast<Index>(std::floor(x + 0.5)); }

bool is_closed(const SurfaceCurves& curves, Index c) {
  return curves.vertices.row(c).front() == curves.vertices.row(c).back();
}

/// Curves with the same two ends: two single edges there would be one edge.
std::vector<Index> fewest_edges(const SurfaceCurves& curves, std::span<const double> steps) {
  struct Span {
    Index a, b;
    double steps;
    Index curve;
  };
  std::vector<Index> fewest(curves.is_loop.size(), 1);
  std::vector<Span> open;
  for (Index c = 0; c < curves.count(); ++c) {
    const Index a = curves.vertices.row(c).front(), b = curves.vertices.row(c).back();
    if (a == b) {
      fewest[c] = fewest_of_closed;
    } else {
      open.push_back({std::min(a, b), std::max(a, b), steps[c], c});
    }
  }
  sort_values(open, [](const Span& s, const Span& t) {
    if (s.a != t.a) return s.a < t.a;
    if (s.b != t.b) return s.b < t.b;
    return s.steps != t.steps ? s.steps < t.steps : s.curve < t.curve;
  });
  for (std::size_t k = 1; k < open.size(); ++k)
    if (open[k].a == open[k - 1].a && open[k].b == open[k - 1].b) fewest[open[k].curve] = 2;
  return fewest;
}

/// Of a small face with three sides four edges would make one quad, flat at a node between corners:
/// it gets two edges on each.
void divide_small_triangles(const SurfaceCurves& curves, Index face_count,
                            std::span<const double> steps, std::vector<Index>& fewest) {
  std::vector<std::vector<Index>> around(static_cast<std::size_t>(face_count));
  for (Index c = 0; c < curves.count(); ++c)
    for (const Index face : curves.faces.row(c)) around[face].push_back(c);
  for (const auto& sides : around) {
    Index most = 0;
    for (const Index c : sides) most = std::max({most, fewest[c], rounded(steps[c])});
    if (sides.size() != 3 || most > 2) continue;
    for (const Index c : sides) fewest[c] = std::max<Index>(fewest[c], 2);
  }
}

void divide_narrow_rings(const CountSums& sums, std::vector<Index>& fewest) {
  for (Index s = 0; s < sums.terms.rows(); ++s) {
    if (!sums.between_circles[s]) continue;
    for (const CountTerm& term : sums.terms.row(s))
      if (fewest[term.curve] == fewest_of_closed) fewest[term.curve] = fewest_in_ring;
  }
}

Index wanted_count(double steps, bool closed) {
  return closed ? 2 * rounded(0.5 * steps) : rounded(steps);
}

/// How far a count is from the steps that the size asks for, as a ratio >= 1.
double misfit(Index count, double steps) {
  const double n = static_cast<double>(count);
  return n > steps ? n / steps : steps / n;
}

/// The better count of the other parity.
Index other_parity(Index count, Index fewest, double steps) {
  if (count - 1 >= fewest && misfit(count - 1, steps) < misfit(count + 1, steps)) return count - 1;
  return count + 1;
}

/// Faces with an odd number of sides on the curve: those whose parity it changes.
std::vector<Index> changed_faces(std::span<const Index> faces) {
  std::vector<Index> odd;
  for (const Index face : faces) {
    if (!odd.empty() && odd.back() == face) {
      odd.pop_back();
    } else {
      odd.push_back(face);
    }
  }
  return odd;
}

/// The smallest set of changes in the sense of its worst one: a minimum spanning forest of the
/// faces (and the outside, behind free borders), pruned from its leaves [Edmonds, Johnson 1973:
/// T-joins].
class EvenMaker {
 public:
  EvenMaker(const SurfaceCurves& curves, Index face_count, std::span<const double> steps,
            std::span<const Index> fewest, std::vector<Index>& counts)
      : curves_(curves),
        steps_(steps),
        fewest_(fewest),
        counts_(counts),
        outside_(face_count),
        tree_at_(static_cast<std::size_t>(face_count) + 1) {}

  void run() {
    settle_meeting_sheets();
    odd_ = face_counts(curves_, outside_, counts_);
    odd_.push_back(0);
    for (Index& n : odd_) n %= 2;
    if (std::count(odd_.begin(), odd_.end(), 1) == 0) return;
    plant();
    prune();
  }

 private:
  /// A curve of three or more faces is no edge between two of them. With even counts they matter to
  /// no face, and the odd faces of a part without free borders come in pairs.
  void settle_meeting_sheets() {
    for (Index c = 0; c < curves_.count(); ++c)
      if (counts_[c] % 2 == 1 && changed_faces(curves_.faces.row(c)).size() > 2) change(c);
  }

  void change(Index c) { counts_[c] = other_parity(counts_[c], fewest_[c], steps_[c]); }

  struct Link {
    double cost;
    Index curve;
    std::array<Index, 2> faces;
  };

  void plant() {
    std::vector<Link> links;
    for (Index c = 0; c < curves_.count(); ++c) {
      const std::vector<Index> faces = changed_faces(curves_.faces.row(c));
      if (faces.empty() || faces.size() > 2) continue;
      const Index count = other_parity(counts_[c], fewest_[c], steps_[c]);
      links.push_back(
          {misfit(count, steps_[c]), c, {faces[0], faces.size() == 2 ? faces[1] : outside_}});
    }
    sort_values(links, [](const Link& a, const Link& b) {
      return a.cost != b.cost ? a.cost < b.cost : a.curve < b.curve;
    });
    DisjointSets trees(outside_ + 1);
    for (const Link& link : links) {
      if (!trees.unite(link.faces[0], link.faces[1])) continue;
      tree_at_[link.faces[0]].push_back({link.curve, link.faces[1]});
      tree_at_[link.faces[1]].push_back({link.curve, link.faces[0]});
    }
  }

  struct Branch {
    Index curve = none, to = none;
  };

  /// From the leaves inward: an odd face passes its oddness on to its parent.
  void prune() {
    std::vector<Branch> parent(tree_at_.size());
    std::vector<char> reached(tree_at_.size(), 0);
    std::vector<Index> order;
    for (Index root = outside_; root >= 0; --root) {  // the outside can take any oddness
      if (reached[root]) continue;
      reached[root] = 1;
      order.push_back(root);
      for (std::size_t head = order.size() - 1; head < order.size(); ++head) {
        const Index face = order[head];
        for (const Branch branch : tree_at_[face]) {
          if (reached[branch.to]) continue;
          reached[branch.to] = 1;
          parent[branch.to] = {branch.curve, face};
          order.push_back(branch.to);
        }
      }
    }
    for (auto face = order.rbegin(); face != order.rend(); ++face) {
      if (odd_[*face] == 0 || parent[*face].curve == none) continue;
      change(parent[*face].curve);
      odd_[*face] = 0;
      odd_[parent[*face].to] ^= 1;
    }
  }

  const SurfaceCurves& curves_;
  std::span<const double> steps_;
  std::span<const Index> fewest_;
  std::vector<Index>& counts_;
  Index outside_;
  std::vector<std::vector<Branch>> tree_at_;  // #faces + 1
  std::vector<Index> odd_;                    // #faces + 1
};

/// Sides whose lengths in steps differ too much want irregular vertices between them.
CountSums possible_sums(CountSums sums, std::span<const double> steps) {
  for (Index s = 0; s < sums.terms.rows(); ++s) {
    double difference = sums.constant[s], total = std::abs(difference);
    for (const CountTerm& term : sums.terms.row(s)) {
      difference += term.factor * steps[term.curve];
      total += std::abs(term.factor) * steps[term.curve];
    }
    const double most =
        sums.across_ring[s] ? most_in_ring * total + 2 : most_difference * total + 1;
    if (std::abs(difference) > most) sums.only_parity[s] = 1;
  }
  return sums;
}

}  // namespace

std::vector<Index> face_counts(const SurfaceCurves& curves, Index face_count,
                               std::span<const Index> counts) {
  std::vector<Index> sums(static_cast<std::size_t>(face_count), 0);
  for (Index c = 0; c < curves.count(); ++c)
    for (const Index face : curves.faces.row(c)) sums[face] += counts[c];
  return sums;
}

std::vector<Index> curve_counts(const SurfaceCurves& curves, Index face_count,
                                std::span<const double> steps, const CountSums& sums) {
  std::vector<Index> fewest = fewest_edges(curves, steps);
  divide_small_triangles(curves, face_count, steps, fewest);
  divide_narrow_rings(sums, fewest);
  std::vector<Index> counts(fewest.size());
  std::vector<CountWish> wishes(fewest.size());
  for (Index c = 0; c < curves.count(); ++c) {
    const bool closed = is_closed(curves, c), bent = sums.bent[c] > 0;
    counts[c] = std::max(fewest[c], bent ? sums.bent[c] : wanted_count(steps[c], closed));
    wishes[c] = {bent ? counts[c] : steps[c], fewest[c], closed ? 2 : 1};
  }
  balance_counts(possible_sums(sums, steps), wishes, counts);
  EvenMaker(curves, face_count, steps, fewest, counts).run();
  return counts;
}

}  // namespace lpq
