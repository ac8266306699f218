// See walk.h.
#include "shell/shape/walk.h"

#include <algorithm>

namespace lpq {
namespace {

constexpr int most_triangles = 2000;
// Twice the area over the longest side's square below which a triangle is not walked through.
constexpr double least_height = 1e-10;

bool has_area(const TriangleLayout& layout) {
  const double longest = std::max({squared_length(layout.side[0]), squared_length(layout.side[1]),
                                   squared_length(layout.side[2])});
  return 2 * layout.area > least_height * longest;
}

/// What a unit of displacement adds to the weight of corner k, times twice the area.
double rate_of(const TriangleLayout& layout, Index k, Vec2 displacement) {
  return cross(layout.side[next_in_triangle(k)], displacement);
}

void advance(const TriangleLayout& layout, Vec2 by, SurfacePlace& place) {
  const double inverse = 1 / (2 * layout.area);
  double sum = 0;
  for (Index k = 0; k < 3; ++k) {
    place.weight[k] = std::max(0.0, place.weight[k] + inverse * rate_of(layout, k, by));
    sum += place.weight[k];
  }
  for (double& weight : place.weight) weight /= sum;
}

}  // namespace

SurfaceWalker::SurfaceWalker(const SurfaceMesh& mesh, std::span<const char> barrier)
    : mesh_(mesh), barrier_(barrier) {
  layout_.reserve(mesh.triangles.size());
  for (Index t = 0; t < mesh.triangle_count(); ++t) layout_.push_back(layout_of(mesh, t));
}

SurfaceWalker::Exit SurfaceWalker::find_exit(const SurfacePlace& at, Vec2 displacement,
                                             Index entered) const {
  const TriangleLayout& layout = layout_[at.triangle];
  Exit exit;
  for (Index k = 0; k < 3; ++k) {
    const double rate = rate_of(layout, k, displacement);
    if (k == entered || !(rate < 0)) continue;
    const double share = at.weight[k] * (2 * layout.area) / -rate;
    if (share < exit.share) exit = {k, share};
  }
  return exit;
}

WalkEnd SurfaceWalker::walk(const SurfacePlace& from, Vec2 displacement) const {
  WalkEnd end{from, {1, 0}, true};
  SurfacePlace& at = end.place;
  Index entered = none;  // corner opposite the edge through which the triangle was entered
  for (int i = 0; i < most_triangles; ++i) {
    const TriangleLayout& layout = layout_[at.triangle];
    if (!has_area(layout)) break;
    const Exit exit = find_exit(at, displacement, entered);
    advance(layout, exit.share * displacement, at);
    if (exit.corner == none) return end;
    at.weight[exit.corner] = 0;
    displacement = (1 - exit.share) * displacement;
    const Index k = next_in_triangle(exit.corner), e = 3 * at.triangle + k;
    const Index twin = mesh_.twins[e];
    if (twin == none || barrier_[e]) break;
    const Index other = triangle_of(twin), j = twin % 3;
    const Vec2 old_side = layout.side[k], new_side = -layout_[other].side[j];
    const Vec2 turned = complex_product(new_side, conjugate(old_side));
    const double size = length(turned);
    if (!(size > 0)) break;
    const Vec2 rotation = (1 / size) * turned;
    displacement = complex_product(rotation, displacement);
    end.turn = complex_product(rotation, end.turn);
    SurfacePlace next{other, {0, 0, 0}};
    const double sum = at.weight[k] + at.weight[next_in_triangle(k)];
    next.weight[next_in_triangle(j)] = at.weight[k] / sum;
    next.weight[j] = at.weight[next_in_triangle(k)] / sum;
    entered = prev_in_triangle(j);
    at = next;
  }
  end.whole = false;
  return end;
}

}  // namespace lpq
