// See balanced_pieces.h.
#include "grids/balanced_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "cleanup/ideal_valence.h"
#include "grids/border_loops.h"
#include "grids/lattice.h"
#include "grids/loop_turns.h"
#include "grids/polar.h"
#include "grids/ring_pieces.h"
#include "mesh/ideal_quads.h"

namespace lpq {
namespace {

// Quads by which a corner may be off what fits its angle.
constexpr double most_unfit = 0.45;
// Of what is wanted on both sides. In skew outlines they differ more, and angles are better with
// irregular vertices between them.
constexpr double most_difference = 0.03;
// The finest size on a ring and the coarsest.
constexpr double most_uneven = 1.2;

/// Do the quads that the way has at every node fit its angle?
bool fits(const std::vector<Vec2>& points, const std::vector<Index>& directions) {
  const std::size_t n = points.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t before = (k + n - 1) % n;
    const Vec2 back = points[before] - points[k], ahead = points[(k + 1) % n] - points[k];
    // Where the way begins it has turned four times in all.
    const Index turn = ((directions[k] - directions[before] + 1) & 3) - 1;
    if (std::fabs(2 - turn - fitting_quads(sector_angle({}, ahead, back))) > most_unfit)
      return false;
  }
  return true;
}

/// A segment whose edges go one way or back along an axis, 1 or -1.
struct Run {
  Index segment = none, way = 0;
};

class PieceBalance {
 public:
  explicit PieceBalance(const BoundaryMesh& boundary)
      : boundary_(boundary), pieces_(boundary.pieces), axis_(axis_of(boundary)) {
    leaving_.assign(boundary.points.size(), none);
    length_.assign(pieces_.count.size(), 0);
    std::size_t e = 0;
    for (Index s = 0; s < static_cast<Index>(pieces_.count.size()); ++s) {
      for (Index k = 0; k < pieces_.count[s]; ++k, ++e) {
        const Segment& edge = boundary.edges[e];
        leaving_[edge.left != none ? edge.a : edge.b] = s;
        length_[s] += distance(boundary.points[edge.a], boundary.points[edge.b]);
      }
      const double nearest = std::max(1.0, std::floor(pieces_.wanted[s] + 0.5));
      counts_.push_back(pieces_.is_whole[s] ? 1 : static_cast<Index>(nearest));
    }
  }

  std::vector<Index> run(const std::vector<std::vector<Index>>& loops) {
    std::size_t of_ring = 0;
    if (!balance_sides(loops[0])) {
      if (loops.size() < 2) return {};
      of_ring = largest_hole(boundary_, loops);
      if (!set_ring(loops[0], loops[of_ring])) return {};
    }
    for (std::size_t k = 1; k < loops.size(); ++k)
      if (k != of_ring && !balance_sides(loops[k])) make_even(loops[k]);
    return counts_ == pieces_.count ? std::vector<Index>{} : std::move(counts_);
  }

 private:
  /// As many edges one way as back; false where the loop's way does not fit.
  bool balance_sides(const std::vector<Index>& loop) {
    const std::vector<Vec2> points = points_of(boundary_, loop);
    const std::vector<Index> directions = open_turns(points, axis_);
    if (directions.empty() || !fits(points, directions)) return false;
    std::vector<Run> along_x, along_y;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index segment = leaving_[loop[k]];
      if (k > 0 && segment == leaving_[loop[k - 1]]) continue;
      const LatticePlace step = lattice_step(directions[k]);
      if (step.x != 0) along_x.push_back({segment, step.x});
      if (step.y != 0) along_y.push_back({segment, step.y});
    }
    balance(along_x);
    balance(along_y);
    return true;
  }

  void make_even(const std::vector<Index>& loop) {
    std::vector<Run> all;
    Index edges = 0;
    for (const Index segment : segments_along(loop)) {
      all.push_back({segment, 1});
      edges += counts_[segment];
    }
    if (edges % 2 != 0 && !change_cheapest(all, 1)) change_cheapest(all, -1);
  }

  /// As many edges round the outline as round a hole; false if that is no ring of quads of one
  /// size.
  bool set_ring(const std::vector<Index>& outline, const std::vector<Index>& hole) {
    const Vec2 centre = centre_of(points_of(boundary_, hole));
    if (line_about(centre, points_of(boundary_, outline)).rounds != 1) return false;
    if (line_about(centre, points_of(boundary_, hole)).rounds != -1) return false;
    const std::vector<Index> outer = segments_along(outline), inner = segments_along(hole);
    if (!is_of_one_size(outer, inner)) return false;
    const RingPieces ring = ring_pieces(pieces_, outer, inner);
    if (ring.outer.empty()) return false;
    for (std::size_t k = 0; k < outer.size(); ++k) counts_[outer[k]] = ring.outer[k];
    for (std::size_t k = 0; k < inner.size(); ++k) counts_[inner[k]] = ring.inner[k];
    return true;
  }

  /// Where sizes vary along it, each border keeps its own.
  bool is_of_one_size(const std::vector<Index>& outer, const std::vector<Index>& inner) const {
    double finest = 0, coarsest = 0;
    for (const auto* border : {&outer, &inner})
      for (const Index s : *border) {
        const double density = pieces_.wanted[s] / length_[s];
        if (finest == 0) finest = coarsest = density;
        finest = std::max(finest, density);
        coarsest = std::min(coarsest, density);
      }
    return finest < most_uneven * coarsest;
  }

  /// The loop begins at the start of one.
  std::vector<Index> segments_along(const std::vector<Index>& loop) const {
    std::vector<Index> segments;
    for (const Index v : loop)
      if (segments.empty() || segments.back() != leaving_[v]) segments.push_back(leaving_[v]);
    return segments;
  }

  void balance(const std::vector<Run>& runs) {
    Index sum = 0;
    double difference = 0, total = 0;
    for (const Run& run : runs) {
      sum += run.way * counts_[run.segment];
      const double wanted = pieces_.is_whole[run.segment] ? 1 : pieces_.wanted[run.segment];
      difference += run.way * wanted;
      total += wanted;
    }
    if (std::fabs(difference) > most_difference * total + 1) return;
    for (; sum > 0 && change_cheapest(runs, -1); --sum) {
    }
    for (; sum < 0 && change_cheapest(runs, 1); ++sum) {
    }
  }

  /// Takes the sum of runs up or down by one, where (n - wanted)^2 / wanted rises least.
  bool change_cheapest(const std::vector<Run>& runs, Index by) {
    Run best;
    double least = 0;
    for (const Run& run : runs) {
      const Index change = by * run.way;
      if (pieces_.is_whole[run.segment] || counts_[run.segment] + change < 1) continue;
      const double wanted = pieces_.wanted[run.segment];
      const double rise = (2 * change * (counts_[run.segment] - wanted) + 1) / wanted;
      if (best.segment != none && !(rise < least)) continue;
      best = run;
      least = rise;
    }
    if (best.segment == none) return false;
    counts_[best.segment] += by * best.way;
    return true;
  }

  const BoundaryMesh& boundary_;
  const SegmentPieces& pieces_;
  double axis_;
  std::vector<Index> leaving_;  // #B  the segment that leaves the node, the domain on its left
  std::vector<double> length_;  // #S
  std::vector<Index> counts_;   // #S
};

}  // namespace

std::vector<Index> balanced_pieces(const BoundaryMesh& boundary) {
  if (boundary.pieces.count.empty()) return {};
  const auto loops = border_loops(boundary);
  if (loops.empty()) return {};
  return PieceBalance(boundary).run(loops);
}

}  // namespace lpq
