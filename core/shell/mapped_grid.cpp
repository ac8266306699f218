// See mapped_grid.h.
#include "shell/mapped_grid.h"

#include <algorithm>
#include <array>

#include "cleanup/ideal_valence.h"
#include "cleanup/untangle.h"
#include "mesh/ideal_quads.h"

namespace lpq {
namespace {

/// The nodes once around, the domain on the left; empty unless one loop has them all, once each.
std::vector<Index> loop_of(const BoundaryMesh& boundary) {
  std::vector<Index> next(boundary.points.size(), none);
  for (const Segment& edge : boundary.edges) {
    const bool inside = edge.left != none && edge.right != none;
    const Index from = edge.left != none ? edge.a : edge.b;
    if (inside || next[from] != none) return {};
    next[from] = edge.left != none ? edge.b : edge.a;
  }
  std::vector<Index> loop;
  for (Index v = 0; loop.size() < next.size(); v = next[v]) {
    if (v == none || (v == 0 && !loop.empty())) return {};
    loop.push_back(v);
  }
  return loop;
}

/// Where in the loop the four corners are; empty if it has others or too few.
std::vector<Index> corners_of(const BoundaryMesh& boundary, const std::vector<Index>& loop) {
  std::vector<Index> corners;
  const std::size_t count = loop.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2 before = boundary.points[loop[(k + count - 1) % count]];
    const Vec2 after = boundary.points[loop[(k + 1) % count]];
    const Index quads = ideal_quads(sector_angle(boundary.points[loop[k]], after, before));
    if (quads == 1) corners.push_back(static_cast<Index>(k));
    if (quads > 2) return {};
  }
  if (corners.size() != 4) corners.clear();
  return corners;
}

constexpr double most_off = 1.5;

/// But for some quads, and half a one at every edge of the border: counts are whole.
bool is_near(double quads, double wanted, double border_edges) {
  const double rounding = 4 + 0.5 * border_edges;
  return quads < most_off * (wanted + rounding) && wanted < most_off * (quads + rounding);
}

class GridMaker {
 public:
  /// `loop` begins at a corner; `across` and `along` edges on its first two sides.
  GridMaker(const BoundaryMesh& boundary, std::vector<Index> loop, Index across, Index along)
      : loop_(std::move(loop)), across_(across), along_(along) {
    grid_.points = boundary.points;
    grid_.fixed = static_cast<Index>(grid_.points.size());
    const Segment& edge = boundary.edges[0];
    region_ = edge.left != none ? edge.left : edge.right;
  }

  QuadMesh run() {
    for (Index j = 1; j < along_; ++j)
      for (Index i = 1; i < across_; ++i) grid_.points.push_back(between_sides(i, j));
    for (Index j = 0; j < along_; ++j)
      for (Index i = 0; i < across_; ++i)
        grid_.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    grid_.region.assign(grid_.faces.size(), region_);
    return std::move(grid_);
  }

 private:
  Index at(Index i, Index j) const {
    if (j == 0) return loop_[i];
    if (i == across_) return loop_[across_ + j];
    if (j == along_) return loop_[across_ + along_ + (across_ - i)];
    if (i == 0) return loop_[2 * across_ + along_ + (along_ - j)];
    return grid_.fixed + (j - 1) * (across_ - 1) + (i - 1);
  }

  Vec2 point(Index i, Index j) const { return grid_.points[at(i, j)]; }

  Vec2 between_sides(Index i, Index j) const {
    const double s = static_cast<double>(i) / across_, t = static_cast<double>(j) / along_;
    const Vec2 lower = (1 - s) * point(0, 0) + s * point(across_, 0);
    const Vec2 upper = (1 - s) * point(0, along_) + s * point(across_, along_);
    return (1 - t) * point(i, 0) + t * point(i, along_) + (1 - s) * point(0, j) +
           s * point(across_, j) - ((1 - t) * lower + t * upper);
  }

  QuadMesh grid_;
  std::vector<Index> loop_;
  Index across_, along_, region_ = 0;
};

}  // namespace

std::optional<QuadMesh> mapped_grid(const BoundaryMesh& boundary, double wanted) {
  std::vector<Index> loop = loop_of(boundary);
  const std::vector<Index> corners = corners_of(boundary, loop);
  if (corners.empty()) return std::nullopt;
  const Index across = corners[1] - corners[0], along = corners[2] - corners[1];
  const bool balanced =
      corners[3] - corners[2] == across && 2 * (across + along) == static_cast<Index>(loop.size());
  if (!balanced || !is_near(1.0 * across * along, wanted, 2.0 * (across + along)))
    return std::nullopt;
  std::rotate(loop.begin(), loop.begin() + corners[0], loop.end());
  loop.push_back(Index{loop[0]});
  QuadMesh grid = GridMaker(boundary, std::move(loop), across, along).run();
  if (!invalid_faces(grid).empty()) return std::nullopt;
  return grid;
}

}  // namespace lpq
