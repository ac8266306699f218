#include "recombine/prepare_corners.h"

#include <algorithm>

#include "mesh/walk.h"
#include "recombine/edit.h"
#include "recombine/fans.h"

namespace lpq {
namespace {

// A vertex at a wall cannot move, so a missing quad there weighs more than one inside.
constexpr Index wall_weight = 2;
// Flips at one vertex make others ready; a few sweeps settle it.
constexpr int max_sweeps = 4;

Index missing(const Fan& fan, Index triangles) {
  return std::max<Index>(0, fan.ideal - triangles) * (fan.closed ? 1 : wall_weight);
}

/// Smallest sine of the two triangles that a flip of e creates, a cheap measure of their shape.
double shape_after_flip(const TriMesh& mesh, Index e) {
  const Vec2 v = mesh.points[mesh.apex(e)], w = mesh.points[mesh.apex(mesh.twins[e])];
  const Vec2 a = mesh.points[mesh.origin(e)], b = mesh.points[mesh.target(e)];
  const auto smallest = [](Vec2 p, Vec2 q, Vec2 r) {
    const double pq = distance(p, q), qr = distance(q, r), rp = distance(r, p);
    return cross(q - p, r - p) / std::max({pq * qr, qr * rp, rp * pq});
  };
  return std::min(smallest(v, a, w), smallest(v, w, b));
}

class Sweep {
 public:
  explicit Sweep(TriMesh& mesh) : mesh_(mesh), fans_(find_fans(mesh)) {
    touched_.assign(mesh.triangles.size(), 0);
  }

  Index run() {
    Index flips = 0;
    for (const Fan& fan : fans_.list) {
      if (fan.closed || fan.triangles >= fan.ideal) continue;
      const Index e = best_flip(fan);
      if (e == none) continue;
      touch_stars(e);
      flip_edge(mesh_, e);
      ++flips;
    }
    return flips;
  }

 private:
  /// Of the edges opposite the fan's vertex, the flip that leaves least missing, then best shape.
  Index best_flip(const Fan& fan) const {
    Index best = none, best_gain = 0;
    double best_shape = 0;
    bool stale = false;
    for_each_in_fan(mesh_, fan.first, [&](Index leaving) {
      stale = stale || touched_[triangle_of(leaving)];
      const Index e = next_in_triangle(leaving);
      if (stale || !is_flippable(mesh_, e) || touched_[triangle_of(mesh_.twins[e])]) return;
      const Index gain = missing(fan, fan.triangles) - missing(fan, fan.triangles + 1) - loss(e) -
                         loss(next_in_triangle(e));
      const double shape = gain > 0 ? shape_after_flip(mesh_, e) : 0;
      if (gain > best_gain || (gain == best_gain && gain > 0 && shape > best_shape))
        best = e, best_gain = gain, best_shape = shape;
    });
    return stale ? none : best;
  }

  /// What the vertex at this corner would newly miss with one triangle fewer.
  Index loss(Index corner) const {
    const Fan& fan = fans_.list[fans_.of_corner[corner]];
    return missing(fan, fan.triangles - 1) - missing(fan, fan.triangles);
  }

  /// Fans through these triangles are out of date until the next sweep.
  void touch_stars(Index e) {
    const Index twin = mesh_.twins[e];
    for (Index corner : {e, next_in_triangle(e), prev_in_triangle(e), prev_in_triangle(twin)})
      for_each_in_fan(mesh_, fans_.list[fans_.of_corner[corner]].first,
                      [&](Index leaving) { touched_[triangle_of(leaving)] = 1; });
  }

  TriMesh& mesh_;
  Fans fans_;
  std::vector<char> touched_;
};

}  // namespace

Index prepare_corners(TriMesh& mesh) {
  Index total = 0;
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    const Index flips = Sweep(mesh).run();
    total += flips;
    if (flips == 0) break;
  }
  return total;
}

}  // namespace lpq
