// Every segment is divided so that its pieces follow the spacing s: with N the integral of 1/s
// along the segment, it gets the nearest whole number of pieces, each holding the same share of N.
// A segment whose rounded nodes would touch anything stays whole.
#include "domain/refine.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/check.h"
#include "domain/conflicts.h"
#include "domain/division.h"
#include "domain/parts.h"
#include "domain/simplify.h"
#include "domain/spacing.h"

namespace lpq {
namespace {

/// The integral of 1/s from a, at increasing parameters t of the segment a + t (b - a).
struct Ruler {
  std::vector<double> t, sum;
};

// An edge much shorter than the spacing in its middle stays whole without measuring it.
constexpr double surely_whole = 0.75;
constexpr int deepest = 40;  // halvings: beyond, the pieces of a unit segment are at rounding level

class Refinement {
 public:
  Refinement(const Domain& domain, const BoundaryOptions& options)
      : domain_(domain), options_(options) {
    SimplifiedBoundary simplified = simplify_boundary(domain, options.simplify_tolerance);
    segments_ = std::move(simplified.segments);
    used_ = std::move(simplified.used);
    deviation_ = simplified.deviation;
    if (options.require_even) parts_ = find_parts(domain.points, segments_);
  }
  Result<BoundaryMesh> run();

 private:
  Problem count(const BoundarySpacing& spacing);
  Result<std::vector<Index>> choose_pieces() const;
  Result<BoundaryMesh> divide(const BoundarySpacing& spacing, bool& again);
  bool keep_meeting_whole(const BoundaryMesh& mesh, const Division& division);
  Vec2 node_at(Vec2 a, Vec2 b, double t, double leeway) const;
  bool place(Index segment, Index pieces, const BoundarySpacing& spacing, Division& division) const;
  Ruler measure(Index segment, const BoundarySpacing& spacing) const;
  Error too_many(double estimate) const;
  Warning narrow_gap(double floor) const;
  Vec2 start(Index s) const { return domain_.points[segments_[s].a]; }
  Vec2 end(Index s) const { return domain_.points[segments_[s].b]; }

  const Domain& domain_;
  const BoundaryOptions& options_;
  std::vector<Segment> segments_;
  Parts parts_;             // where even numbers are required
  std::vector<char> used_;  // #P
  double deviation_ = 0;
  std::vector<double> ideal_;  // #S  N
  std::vector<char> whole_;    // #S  dividing it was found unsafe
};

Error Refinement::too_many(double estimate) const {
  return {ErrorCode::too_many_elements,
          "With this mesh size the boundary alone would have about " +
              std::to_string(static_cast<long long>(estimate)) + " nodes; the limit is " +
              std::to_string(options_.max_nodes) + ". Choose a larger size.",
          {}};
}

Warning Refinement::narrow_gap(double floor) const {
  char length[32];
  std::snprintf(length, sizeof length, "%.3g", domain_.frame.length_to_world(floor));
  return {ErrorCode::too_narrow,
          std::string(
              "A gap of the domain is very long for its width; its walls have edges of about ") +
              length + " instead of its width, to keep their number in bounds.",
          {}};
}

// Halving until the spacing changes little over a piece; then the trapezoidal rule.
Ruler Refinement::measure(Index segment, const BoundarySpacing& spacing) const {
  struct Piece {
    double t0, t1, s0, s1;
    int depth;
  };
  const Vec2 a = start(segment), d = end(segment) - a;
  const double l = length(d);
  Ruler ruler{{0.0}, {0.0}};
  const double s_a = spacing.at(a, spacing.bound(segments_[segment].a));
  const double s_b = spacing.at(a + d, spacing.bound(segments_[segment].b));
  std::vector<Piece> waiting{{0, 1, s_a, s_b, 0}};
  while (!waiting.empty()) {
    const Piece piece = waiting.back();
    waiting.pop_back();
    const double step = (piece.t1 - piece.t0) * l;
    if (step <= 0.5 * std::min(piece.s0, piece.s1) || piece.depth >= deepest) {
      ruler.t.push_back(piece.t1);
      ruler.sum.push_back(ruler.sum.back() + 0.5 * step * (1 / piece.s0 + 1 / piece.s1));
      continue;
    }
    const double t = 0.5 * (piece.t0 + piece.t1);
    const double highest = std::min(piece.s0, piece.s1) + 0.5 * options_.growth * step;
    const double s = spacing.at(a + t * d, highest);
    waiting.push_back({t, piece.t1, s, piece.s1, piece.depth + 1});
    waiting.push_back({piece.t0, t, piece.s0, s, piece.depth + 1});
  }
  return ruler;
}

Problem Refinement::count(const BoundarySpacing& spacing) {
  double total = 0;
  for (Index i = 0; i < static_cast<Index>(segments_.size()); ++i) {
    const double l = distance(start(i), end(i));
    const double at_ends = std::min(spacing.bound(segments_[i].a), spacing.bound(segments_[i].b));
    const double bound = at_ends + 0.5 * options_.growth * l;
    const double s = spacing.at(midpoint(start(i), end(i)), bound);
    ideal_.push_back(l <= surely_whole * s ? l / s : measure(i, spacing).sum.back());
    total += ideal_.back();
    if (total > options_.max_nodes)
      return too_many(total * static_cast<double>(segments_.size()) / (i + 1));
  }
  return {};
}

/// A point near a + t (b - a) that the caller's coordinates can hold. Far from the origin these are
/// coarse, and rounding to the nearest would leave the segment: then neighbouring places within
/// `leeway` of t are tried, too, and the one nearest to the segment is taken.
Vec2 Refinement::node_at(Vec2 a, Vec2 b, double t, double leeway) const {
  constexpr double on_segment = 0x1p-43;  // far below the 10^-12 that outside checks allow
  constexpr int tries = 64;
  const auto off = [&](Vec2 p) { return std::abs(cross(p - a, b - a)) / distance(a, b); };
  Vec2 best = domain_.frame.snap(a + t * (b - a));
  double least = off(best);
  for (int i = 1; i <= tries && least > on_segment; ++i) {
    const double shift = (i % 2 == 0 ? leeway : -leeway) * i / tries;
    const Vec2 p = domain_.frame.snap(a + (t + shift) * (b - a));
    if (off(p) >= least) continue;
    best = p;
    least = off(p);
  }
  return best;
}

/// Appends the nodes of a segment; false if rounding put them out of order.
bool Refinement::place(Index segment, Index pieces, const BoundarySpacing& spacing,
                       Division& division) const {
  if (pieces < 2) return true;
  const Ruler ruler = measure(segment, spacing);
  const Vec2 a = start(segment), b = end(segment);
  // Order is judged along the longer side: across it, rounding moves nodes to and fro.
  const bool along_x = std::abs(b.x - a.x) > std::abs(b.y - a.y);
  const auto position = [along_x](Vec2 p) { return along_x ? p.x : p.y; };
  const double direction = position(b) > position(a) ? 1 : -1;
  const auto before = [&](Vec2 p, Vec2 q) {
    return direction * position(p) < direction * position(q);
  };
  Vec2 last = a;
  std::size_t k = 1;
  for (Index i = 1; i < pieces; ++i) {
    const double wanted = ruler.sum.back() * i / pieces;
    while (k + 1 < ruler.sum.size() && ruler.sum[k] < wanted) ++k;
    const double share = (wanted - ruler.sum[k - 1]) / (ruler.sum[k] - ruler.sum[k - 1]);
    const double t = ruler.t[k - 1] + share * (ruler.t[k] - ruler.t[k - 1]);
    const double step = ruler.sum.back() / pieces * (ruler.t[k] - ruler.t[k - 1]) /
                        (ruler.sum[k] - ruler.sum[k - 1]);  // in t, to the next node
    const Vec2 p = node_at(a, b, t, 0.01 * step);
    if (!before(last, p) || !before(p, b)) return false;
    division.values.push_back(p);
    last = p;
  }
  return true;
}

/// As many as their ideal says, and an even number around every part.
Result<std::vector<Index>> Refinement::choose_pieces() const {
  const std::size_t count = segments_.size();
  LPQ_ASSERT(options_.pieces.empty() || options_.pieces.size() == count);
  std::vector<Index> pieces(count, 1);
  std::vector<double> preference(count, -1.0);
  for (std::size_t i = 0; i < count; ++i) {
    if (whole_[i]) continue;
    pieces[i] = options_.pieces.empty()
                    ? static_cast<Index>(std::max(1.0, std::floor(ideal_[i] + 0.5)))
                    : options_.pieces[i];
    preference[i] = ideal_[i] / (pieces[i] + 1);
  }
  if (!options_.require_even) return pieces;
  for (const Index i : segments_to_even(parts_.segments, parts_.count(), pieces, preference)) {
    if (whole_[i])
      return Error{ErrorCode::lost_precision,
                   "No boundary edge of region " + std::to_string(segments_[i].left) +
                       " is long enough to be divided in double precision.",
                   {}};
    ++pieces[i];
  }
  return pieces;
}

Result<BoundaryMesh> Refinement::divide(const BoundarySpacing& spacing, bool& again) {
  Result<std::vector<Index>> pieces = choose_pieces();
  if (!pieces) return pieces.error();
  Division division;
  for (Index i = 0; i < static_cast<Index>(segments_.size()); ++i) {
    if (!place(i, (*pieces)[i], spacing, division)) {
      division.values.resize(division.offsets.back());
      whole_[i] = 1;
      again = true;
    }
    division.end_row();
  }
  BoundaryMesh mesh = assemble(domain_, segments_, used_, division);
  mesh.simplify_deviation = deviation_;
  mesh.pieces = {ideal_, std::move(*pieces), whole_};
  if (!again && !division.values.empty()) again = keep_meeting_whole(mesh, division);
  return mesh;
}

/// Segments whose nodes touch others stay whole from now on; true if there are any.
bool Refinement::keep_meeting_whole(const BoundaryMesh& mesh, const Division& division) {
  std::vector<Index> origin;
  for (Index i = 0; i < static_cast<Index>(segments_.size()); ++i)
    origin.insert(origin.end(), division.row(i).size() + 1, i);
  bool found = false;
  for (const Index e : meeting_edges(mesh.points, mesh.edges)) {
    if (division.row(origin[e]).empty()) continue;
    whole_[origin[e]] = 1;
    found = true;
  }
  return found;
}

Result<BoundaryMesh> Refinement::run() {
  double total = 0;
  for (Index i = 0; i < static_cast<Index>(segments_.size()); ++i)
    total += distance(start(i), end(i));
  if (total / options_.size > options_.max_nodes) return too_many(total / options_.size);
  const BoundarySpacing spacing(domain_, segments_,
                                {.size = options_.size, .growth = options_.growth}, options_.sizes);
  whole_.assign(segments_.size(), 0);
  if (Problem problem = count(spacing)) return *problem;
  // Every round makes another segment whole, and the given segments do not meet.
  for (;;) {
    bool again = false;
    Result<BoundaryMesh> mesh = divide(spacing, again);
    if (mesh && again) continue;
    if (mesh && spacing.gap_floor() > 0) mesh->warnings.push_back(narrow_gap(spacing.gap_floor()));
    return mesh;
  }
}

}  // namespace

Result<BoundaryMesh> refine_boundary(const Domain& domain, const BoundaryOptions& options) {
  if (!(options.size > 0) || !std::isfinite(options.size))
    return Error{ErrorCode::bad_size, "The mesh size must be a positive number.", {}};
  if (!(options.growth > 0) || !std::isfinite(options.growth))
    return Error{ErrorCode::bad_option, "The growth of the spacing must be a positive number.", {}};
  return Refinement(domain, options).run();
}

}  // namespace lpq
