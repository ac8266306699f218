// See hole_places.h.
#include "grids/hole_places.h"

#include <algorithm>
#include <cmath>

#include "grids/polar.h"
#include "grids/springs.h"

namespace lpq {
namespace {

LatticePlace nearest_place(Vec2 p) {
  return {static_cast<Index>(std::floor(p.x + 0.5)), static_cast<Index>(std::floor(p.y + 0.5))};
}

Vec2 point_at(LatticePlace p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

double off_lattice(Vec2 p) {
  const Vec2 off = p - point_at(nearest_place(p));
  return std::max(std::fabs(off.x), std::fabs(off.y));
}

// So many times at most the map is made.
constexpr std::size_t most_maps = 12;

/// Shifts of the loops that are not placed yet, in the map that leaves them free; in their order.
std::vector<Vec2> harmonic_shifts(const TriMesh& triangles, const LaidLoops& laid,
                                  const std::vector<char>& placed) {
  const std::vector<LatticeLoop>& loops = laid.loops;
  std::vector<Index> body(triangles.points.size(), none);
  std::vector<Vec2> place(body.size());
  Index bodies = 0;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const Index shifted = placed[k] ? none : bodies++;
    for (std::size_t i = 0; i < loops[k].nodes.size(); ++i) {
      body[loops[k].nodes[i]] = shifted;
      place[loops[k].nodes[i]] = point_at(loops[k].places[i]);
    }
  }
  for (std::size_t v = static_cast<std::size_t>(triangles.fixed); v < body.size(); ++v)
    body[v] = bodies++;
  Springs springs(std::move(body), std::move(place), bodies);
  for (Index e = 0; e < 3 * triangles.triangle_count(); ++e) {
    const Index v = triangles.origin(e), w = triangles.target(e);
    Vec2 jump;
    if (laid.round > 0)
      jump.y = laid.round * sheets_between(triangles.points[v], triangles.points[w], laid.centre);
    springs.add(v, w, jump);
  }
  return springs.rest();
}

/// The loop that is nearest to a place of the lattice goes there.
void place_nearest(const std::vector<Vec2>& shifts, const std::vector<char>& was_placed,
                   std::vector<LatticeLoop>& loops, std::vector<char>& placed) {
  std::size_t nearest = 0, at = 0;
  Vec2 shift{0.5, 0.5};
  double least = 1;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (was_placed[k]) continue;
    const Vec2 s = shifts[at++];
    if (placed[k] || !(off_lattice(s) < least)) continue;
    least = off_lattice(s);
    nearest = k;
    shift = s;
  }
  placed[nearest] = 1;
  for (LatticePlace& p : loops[nearest].places) p = p + nearest_place(shift);
}

}  // namespace

bool place_holes(const TriMesh& triangles, std::size_t count, LaidLoops& laid) {
  const std::size_t all = laid.loops.size();
  std::vector<char> placed(all, 0);
  std::fill_n(placed.begin(), count, 1);
  const std::size_t at_once = (all - count + most_maps - 1) / most_maps;
  while (count < all) {
    const std::vector<char> was_placed = placed;
    const std::vector<Vec2> shifts = harmonic_shifts(triangles, laid, was_placed);
    if (shifts.empty()) return false;
    for (std::size_t k = 0; k < at_once && count < all; ++k, ++count)
      place_nearest(shifts, was_placed, laid.loops, placed);
  }
  return true;
}

}  // namespace lpq
