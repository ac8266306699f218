// A remembering visibility walk [Devillers, Pion, Teillaud 2002]: cross any edge that has p
// strictly beyond it, except the one just crossed; the edge tried first alternates. With walls the
// walk may run into a dead end or, rarely, in circles: it is cut short and the grid takes over.
// Cost: O(1) with a near hint; the grid adds at most a scan of one cell, a few triangles when they
// are well shaped, many when they are long and thin.
#include "delaunay/locate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/segment.h"

namespace lpq {
namespace {

// The triangle that contains p, or none if the walk was blocked or took more than `limit` steps.
Index walk(const TriMesh& mesh, Vec2 p, Index start, Index limit) {
  Index t = start, entry = none;
  for (Index step = 0; step < limit; ++step) {
    bool blocked = false, moved = false;
    for (Index i = 0; i < 3 && !moved; ++i) {
      const Index e = 3 * t + (i + step) % 3;
      if (e == entry ||
          orient2d_inline(mesh.points[mesh.origin(e)], mesh.points[mesh.target(e)], p) >= 0) {
        continue;
      }
      if (mesh.twins[e] == none) {
        blocked = true;
      } else {
        entry = mesh.twins[e];
        moved = true;
      }
    }
    if (!moved) return blocked ? none : t;
    t = triangle_of(entry);
  }
  return none;
}

double squared_distance(const TriMesh& mesh, Index t, Vec2 p) {
  if (contains(mesh, t, p)) return 0;
  double best = std::numeric_limits<double>::infinity();
  for (Index e = 3 * t; e < 3 * t + 3; ++e) {
    const Vec2 a = mesh.points[mesh.origin(e)], b = mesh.points[mesh.target(e)];
    best = std::min(best, squared_distance_to_segment(p, a, b));
  }
  return best;
}

}  // namespace

Index locate(const TriMesh& mesh, Vec2 p, Index hint) {
  const Index count = mesh.triangle_count();
  if (count == 0) return none;
  const Index limit = 64 + 8 * static_cast<Index>(std::sqrt(static_cast<double>(count)));
  const Index t = walk(mesh, p, hint == none ? 0 : hint, limit);
  if (t != none) return t;
  for (Index s = 0; s < count; ++s) {
    if (contains(mesh, s, p)) return s;
  }
  return none;
}

// Cells about as large as two triangles, but larger if triangles are so long that they would meet
// many cells (a coarse grid), or the domain fills so little of its box that most would be empty.
Locator::Locator(const TriMesh& mesh) : mesh_(&mesh) {
  if (mesh.triangles.empty()) return;
  const double count = mesh.triangle_count();
  double area = 0, perimeter = 0;
  origin_ = corner_ = mesh.points[mesh.triangles[0][0]];
  for (const Tri& t : mesh.triangles) {
    const Vec2 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
    area += 0.5 * cross(b - a, c - a);
    perimeter += distance(a, b) + distance(b, c) + distance(c, a);
    for (const Vec2 p : {a, b, c}) {
      origin_ = {std::min(origin_.x, p.x), std::min(origin_.y, p.y)};
      corner_ = {std::max(corner_.x, p.x), std::max(corner_.y, p.y)};
    }
  }
  const Vec2 extent = corner_ - origin_;
  cell_ = std::max({std::sqrt(2 * area / count), perimeter / (6 * count),
                    std::sqrt(extent.x * extent.y / (2 * count)),
                    std::max(extent.x, extent.y) / (2 * count)});
  columns_ = static_cast<Index>(extent.x / cell_) + 1;
  rows_ = static_cast<Index>(extent.y / cell_) + 1;

  fill_csr(near_, static_cast<std::size_t>(columns_) * rows_, [&](auto&& emit) {
    for (Index t = 0; t < mesh.triangle_count(); ++t)
      for_cells_of(t, [&](Index cell) { emit(cell, t); });
  });
  find_border();
}

void Locator::find_border() {
  std::vector<Box> boxes;
  for (Index t = 0; t < mesh_->triangle_count(); ++t) {
    const auto& twins = mesh_->twins;
    if (twins[3 * t] != none && twins[3 * t + 1] != none && twins[3 * t + 2] != none) continue;
    border_.push_back(t);
    Box box = empty_box();
    for (const Index v : mesh_->triangles[t]) extend(box, mesh_->points[v]);
    boxes.push_back(box);
  }
  border_boxes_ = BoxTree(boxes);
}

Index Locator::column_of(double x) const {
  return static_cast<Index>(std::clamp((x - origin_.x) / cell_, 0.0, columns_ - 1.0));
}

Index Locator::row_of(double y) const {
  return static_cast<Index>(std::clamp((y - origin_.y) / cell_, 0.0, rows_ - 1.0));
}

template <class Visit>
void Locator::for_cells_of(Index t, const Visit& visit) const {
  // Widened by far more than the rounding of the cell of a point, far less than a cell.
  const double rim = 1e-6 * cell_;
  const Tri& c = mesh_->triangles[t];
  const Vec2 p[3] = {mesh_->points[c[0]], mesh_->points[c[1]], mesh_->points[c[2]]};
  const double y_lo = std::min({p[0].y, p[1].y, p[2].y}) - rim;
  const double y_hi = std::max({p[0].y, p[1].y, p[2].y}) + rim;
  for (Index row = row_of(y_lo); row <= row_of(y_hi); ++row) {
    // The x-range of the triangle within the row: of its corners inside, and where edges cross.
    const double bottom = origin_.y + row * cell_ - rim, top = bottom + cell_ + 2 * rim;
    double x_lo = std::numeric_limits<double>::infinity(), x_hi = -x_lo;
    const auto cover = [&](double x) {
      x_lo = std::min(x_lo, x);
      x_hi = std::max(x_hi, x);
    };
    for (int k = 0; k < 3; ++k) {
      const Vec2 a = p[k], b = p[(k + 1) % 3];
      if (a.y >= bottom && a.y <= top) cover(a.x);
      for (const double y : {bottom, top}) {
        if ((a.y < y) != (b.y < y)) cover(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    }
    if (x_lo > x_hi) continue;
    const Index last = column_of(x_hi + rim);
    for (Index column = column_of(x_lo - rim); column <= last; ++column) {
      visit(row * columns_ + column);
    }
  }
}

Index Locator::find_elsewhere(Vec2 p, Index& hint) const {
  constexpr Index few = 32;  // a longer walk costs more than asking the grid
  if (columns_ == 0) return none;
  if (hint != none) {
    if (const Index t = walk(*mesh_, p, hint, few); t != none) return hint = t;
  }
  const bool in_box = p.x >= origin_.x && p.x <= corner_.x && p.y >= origin_.y && p.y <= corner_.y;
  if (!in_box) return none;
  const auto candidates = near_.row(row_of(p.y) * columns_ + column_of(p.x));
  if (candidates.empty()) return none;
  const Index cheaper_than_scan = few + static_cast<Index>(candidates.size());
  if (const Index t = walk(*mesh_, p, candidates[0], cheaper_than_scan); t != none) {
    return hint = t;
  }
  for (const Index t : candidates) {
    if (contains(*mesh_, t, p)) return hint = t;
  }
  return none;
}

// Nearest to what lies outside are triangles at the border.
Index Locator::nearest(Vec2 p, Index& hint) const {
  constexpr double rounding = 1e-9;
  double reach = std::numeric_limits<double>::infinity();
  if (hint != none) reach = (1 + rounding) * squared_distance(*mesh_, hint, p);
  Index best = none;
  border_boxes_.walk(
      [&](Index, const Box& box) {
        return squared_distance(box, {p, p}) <= reach;
      },
      [&](Index i) {
        const double d = squared_distance(*mesh_, border_[i], p);
        if (!(d < reach || (d == reach && (best == none || border_[i] < best)))) return;
        reach = d;
        best = border_[i];
      });
  if (best != none) hint = best;
  return best;
}

}  // namespace lpq
