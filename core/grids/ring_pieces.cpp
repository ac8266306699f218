// See ring_pieces.h.
#include "grids/ring_pieces.h"

#include <algorithm>
#include <cmath>

namespace lpq {
namespace {

// Where one border has at most so many times as many edges, all are within a quarter of their size
// in the end, but for rounding.
constexpr double widest_ring = 1.5;
// No ring grid is laid on more.
constexpr double most_edges = 4000;

class Border {
 public:
  Border(const SegmentPieces& pieces, std::span<const Index> segments)
      : pieces_(pieces), segments_(segments) {
    for (const Index s : segments) {
      wanted_ += pieces.wanted[s];
      edges_ += std::max(1.0, pieces.wanted[s]);
    }
  }

  double edges() const { return edges_; }
  bool has_whole() const {
    return std::any_of(segments_.begin(), segments_.end(),
                       [&](Index s) { return pieces_.is_whole[s] != 0; });
  }

  /// So many edges shared out; empty if that is not possible.
  std::vector<Index> shared(Index edges) const {
    std::vector<Index> shares;
    double passed = 0;
    Index given = 0;
    for (const Index s : segments_) {
      passed += pieces_.wanted[s];
      const auto until = static_cast<Index>(std::floor(edges * (passed / wanted_) + 0.5));
      shares.push_back(std::max<Index>(1, until - given));
      given += shares.back();
    }
    if (given != edges) return {};
    return shares;
  }

  double misfit(const std::vector<Index>& shares) const {
    double sum = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const double wanted = pieces_.wanted[segments_[k]], off = shares[k] - wanted;
      sum += off * off / std::max(wanted, 0.5);
    }
    return sum;
  }

 private:
  const SegmentPieces& pieces_;
  std::span<const Index> segments_;
  double wanted_ = 0, edges_ = 0;
};

}  // namespace

RingPieces ring_pieces(const SegmentPieces& pieces, std::span<const Index> outer,
                       std::span<const Index> inner) {
  const Border a(pieces, outer), b(pieces, inner);
  if (a.has_whole() || b.has_whole()) return {};
  const double least = std::min(a.edges(), b.edges()), most = std::max(a.edges(), b.edges());
  if (most > widest_ring * least || most > most_edges) return {};
  RingPieces best;
  double lowest = 0;
  for (auto edges = static_cast<Index>(least); edges <= static_cast<Index>(most); ++edges) {
    RingPieces ring{a.shared(edges), b.shared(edges)};
    if (ring.outer.empty() || ring.inner.empty()) continue;
    const double misfit = a.misfit(ring.outer) + b.misfit(ring.inner);
    if (!best.outer.empty() && !(misfit < lowest)) continue;
    lowest = misfit;
    best = std::move(ring);
  }
  return best;
}

}  // namespace lpq
