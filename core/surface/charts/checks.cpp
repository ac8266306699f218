#include "surface/charts/checks.h"

#include <algorithm>
#include <cmath>

#include "base/sort_numbers.h"
#include "domain/box_tree.h"
#include "geometry/predicates_inline.h"
#include "geometry/segment.h"
#include "surface/frames.h"

namespace lpq {
namespace {

constexpr double tail = 0.005;         // of the area, left out at either end of the scales
constexpr double judged_share = 0.95;  // of the area, whose anisotropy counts
// Triangles below this share of the mean area say nothing about the map.
constexpr double least_area_share = 1e-12;
// Of the plane's extent. Borders nearer to each other, across the outside, meet once nodes between
// their corners are rounded: the two sides of a cut through a flat ring lie on each other.
constexpr double least_gap_share = 1e-9;

struct Weighted {
  double value, area;
};

// The value below which `share` of the area lies.
double quantile(std::vector<Weighted>& values, double share) {
  sort_values(values, [](const Weighted& a, const Weighted& b) {
    return a.value != b.value ? a.value < b.value : a.area < b.area;
  });
  double total = 0, sum = 0;
  for (const Weighted& w : values) total += w.area;
  for (const Weighted& w : values)
    if ((sum += w.area) >= share * total) return w.value;
  return values.empty() ? 1 : values.back().value;
}

struct Stretch {
  double scale = 1, anisotropy = 1;
};

// Singular values of the map from the triangle's plane, by the parts of the Jacobian that turn
// with and against it.
Stretch stretch_of(const TriangleLayout& layout, const Vec2 (&p)[3]) {
  const Vec2 ab = p[1] - p[0], ac = p[2] - p[0];
  const Vec2 q = -layout.side[2];
  const double inverse = 1 / (layout.side[0].x * q.y);
  const Vec2 jx = (inverse * q.y) * ab;
  const Vec2 jy = inverse * (layout.side[0].x * ac - q.x * ab);
  const double with = length(Vec2{jx.x + jy.y, jx.y - jy.x});
  const double against = length(Vec2{jx.x - jy.y, jx.y + jy.x});
  const double small = std::max(with - against, 1e-300);
  return {std::sqrt(std::max(cross(jx, jy), 0.0)), (with + against) / small};
}

bool share_a_vertex(const Part& part, Index e, Index f) {
  return part.origin(e) == part.origin(f) || part.target(e) == part.origin(f) ||
         part.origin(e) == part.target(f) || part.target(e) == part.target(f);
}

// Border edges from one vertex may meet there, but not lie on each other.
bool meet_wrongly(const Part& part, std::span<const Vec2> uv, Index e, Index f) {
  const Vec2 a = uv[part.origin(e)], b = uv[part.target(e)];
  const Vec2 c = uv[part.origin(f)], d = uv[part.target(f)];
  const Meeting meeting = meet(a, b, c, d);
  if (share_a_vertex(part, e, f))
    return meeting == Meeting::overlapping || meeting == Meeting::crossing;
  return meeting != Meeting::apart;
}

/// Whether an end or the middle of border edge f lies beside e, outside and nearer than `gap`.
bool lies_along(const Part& part, std::span<const Vec2> uv, Index e, Index f, double gap) {
  const Vec2 a = uv[part.origin(e)], b = uv[part.target(e)];
  const Vec2 c = uv[part.origin(f)], d = uv[part.target(f)];
  const double along = distance(a, b);
  for (const Vec2 q : {c, midpoint(c, d), d}) {
    const double foot = dot(q - a, b - a) / along;  // from a
    if (!(foot > 2 * gap && foot < along - 2 * gap)) continue;
    // The part lies to the left of its border.
    if (std::abs(cross(b - a, q - a)) < gap * along && orient2d_inline(a, b, q) <= 0) return true;
  }
  return false;
}

/// Whether the border comes back to a vertex of the surface that it has passed, and to its place.
bool is_pinched(const Part& part, std::span<const Vec2> uv, double gap) {
  std::vector<Index> corners;
  for (const Index e : part.loops.values) corners.push_back(part.origin(e));
  sort_numbers(corners, [&](Index v, Index w) {
    if (part.vertex[v] != part.vertex[w]) return part.vertex[v] < part.vertex[w];
    return uv[v].x < uv[w].x;
  });
  const auto may_meet = [&](Index v, Index w) {
    return part.vertex[v] == part.vertex[w] && uv[w].x - uv[v].x <= gap;
  };
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size() && may_meet(corners[i], corners[j]); ++j)
      if (distance(uv[corners[i]], uv[corners[j]]) <= gap) return true;
  return false;
}

bool borders_meet(const Part& part, std::span<const Vec2> uv) {
  const auto& border = part.loops.values;
  const Box extent = box_of(uv);
  const double gap = least_gap_share * distance(extent.lo, extent.hi);
  if (is_pinched(part, uv, gap)) return true;
  const Vec2 margin{gap, gap};
  std::vector<Box> boxes;
  boxes.reserve(border.size());
  for (const Index e : border) {
    if (uv[part.origin(e)] == uv[part.target(e)]) return true;
    boxes.push_back(box_of(uv[part.origin(e)], uv[part.target(e)]));
  }
  const BoxTree tree(boxes);
  const auto touch = [&](Index e, Index f) {
    return meet_wrongly(part, uv, e, f) || lies_along(part, uv, e, f, gap) ||
           lies_along(part, uv, f, e, gap);
  };
  bool found = false;
  for (Index i = 0; i < static_cast<Index>(border.size()) && !found; ++i) {
    const Box reach{boxes[i].lo - margin, boxes[i].hi + margin};
    tree.walk([&](Index, const Box& box) { return !found && overlap(reach, box); },
              [&](Index j) { found = found || (j > i && touch(border[i], border[j])); });
  }
  return found;
}

/// Where no triangle is turned over and no border edges meet, points are covered as often as the
/// border winds round them: at most once if one loop alone winds to the left.
bool covers_twice(const Part& part, std::span<const Vec2> uv) {
  Index left = 0;
  for (Index loop = 0; loop < part.loops.rows(); ++loop) {
    const auto row = part.loops.row(loop);
    const Vec2 first = uv[part.origin(row[0])];
    double twice = 0;
    for (const Index e : row)
      twice += cross(uv[part.origin(e)] - first, uv[part.target(e)] - first);
    left += twice > 0;
  }
  return left != 1;
}

/// Of all triangles; adds their areas to `total`.
std::vector<TriangleLayout> layouts_of(const SurfaceMesh& mesh, const Part& part, double& total) {
  std::vector<TriangleLayout> layouts;
  for (const Index t : part.triangles) {
    layouts.push_back(layout_of(mesh, t));
    total += layouts.back().area;
  }
  return layouts;
}

}  // namespace

Index count_flipped(const Part& part, std::span<const Vec2> uv) {
  Index flipped = 0;
  for (const auto& [a, b, c] : part.corners)
    flipped += !(is_finite(uv[a]) && is_finite(uv[b]) && is_finite(uv[c])) ||
               orient2d_inline(uv[a], uv[b], uv[c]) <= 0;
  return flipped;
}

MapCheck check_map(const SurfaceMesh& mesh, const Part& part, std::span<const Vec2> uv) {
  MapCheck check;
  check.flipped = count_flipped(part, uv);
  if (check.flipped > 0) return check;
  std::vector<Weighted> scales, anisotropies;
  double total = 0;
  const std::vector<TriangleLayout> layouts = layouts_of(mesh, part, total);
  const double least = least_area_share * total / static_cast<double>(layouts.size());
  for (Index t = 0; t < part.triangle_count(); ++t) {
    const double area = layouts[t].area;
    if (!(area > least)) continue;
    const auto [a, b, c] = part.corners[t];
    const Stretch stretch = stretch_of(layouts[t], {uv[a], uv[b], uv[c]});
    scales.push_back({stretch.scale, area});
    anisotropies.push_back({stretch.anisotropy, area});
  }
  check.anisotropy = quantile(anisotropies, judged_share);
  const double high = quantile(scales, 1 - tail), low = quantile(scales, tail);
  check.scale_range = high / std::max(low, 1e-300);
  check.crossing = covers_twice(part, uv) || borders_meet(part, uv);
  return check;
}

void scale_to_surface(const SurfaceMesh& mesh, const Part& part, std::span<Vec2> uv) {
  double total = 0, plane = 0;
  layouts_of(mesh, part, total);
  for (const auto& [a, b, c] : part.corners) plane += 0.5 * cross(uv[b] - uv[a], uv[c] - uv[a]);
  if (!(total > 0)) return;
  double factor = 1;
  while (factor * factor * plane > 2 * total) factor *= 0.5;
  while (factor * factor * plane < 0.5 * total) factor *= 2;
  for (Vec2& p : uv) p = factor * p;
}

std::vector<double> scales_of(const SurfaceMesh& mesh, const Part& part, std::span<const Vec2> uv) {
  std::vector<double> scales;
  double total = 0, plane = 0;
  const std::vector<TriangleLayout> layouts = layouts_of(mesh, part, total);
  const double least = least_area_share * total / static_cast<double>(layouts.size());
  for (Index t = 0; t < part.triangle_count(); ++t) {
    const auto [a, b, c] = part.corners[t];
    const double area = 0.5 * cross(uv[b] - uv[a], uv[c] - uv[a]);
    plane += area;
    scales.push_back(layouts[t].area > least ? std::sqrt(area / layouts[t].area) : 0);
  }
  for (double& scale : scales)
    if (!(scale > 0)) scale = std::sqrt(plane / total);
  return scales;
}

}  // namespace lpq
