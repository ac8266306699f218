// See hole_places.h.
#include "shell/grids/hole_places.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shell/grids/springs.h"

namespace lpq {
namespace {

constexpr std::size_t most_maps = 12;

LatticePlace nearest_place(Vec2 p) {
  return {static_cast<Index>(std::floor(p.x + 0.5)), static_cast<Index>(std::floor(p.y + 0.5))};
}

Vec2 point_at(LatticePlace p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

double off_lattice(Vec2 p) {
  const Vec2 off = p - point_at(nearest_place(p));
  return std::max(std::fabs(off.x), std::fabs(off.y));
}

/// Shifts of the loops from the `placed`-th on, in the map that leaves them free.
std::vector<Vec2> harmonic_shifts(const TriMesh& triangles, const std::vector<LatticeLoop>& loops,
                                  std::size_t placed) {
  std::vector<Index> body(triangles.points.size(), none);
  std::vector<Vec2> place(body.size());
  Index bodies = 0;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const Index shifted = k < placed ? none : bodies++;
    for (std::size_t i = 0; i < loops[k].nodes.size(); ++i) {
      body[loops[k].nodes[i]] = shifted;
      place[loops[k].nodes[i]] = point_at(loops[k].places[i]);
    }
  }
  for (std::size_t v = static_cast<std::size_t>(triangles.fixed); v < body.size(); ++v)
    body[v] = bodies++;
  Springs springs(std::move(body), std::move(place), bodies);
  for (Index e = 0; e < 3 * triangles.triangle_count(); ++e)
    springs.add(triangles.origin(e), triangles.target(e));
  std::vector<Vec2> shifts = springs.rest();
  if (!shifts.empty()) shifts.resize(loops.size() - placed);
  return shifts;
}

}  // namespace

bool place_holes(const TriMesh& triangles, std::vector<LatticeLoop>& loops) {
  const std::size_t at_once = (loops.size() - 1 + most_maps - 1) / most_maps;
  for (std::size_t placed = 1; placed < loops.size();) {
    const std::vector<Vec2> shifts = harmonic_shifts(triangles, loops, placed);
    if (shifts.empty()) return false;
    std::vector<std::size_t> order(shifts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return off_lattice(shifts[a]) < off_lattice(shifts[b]);
    });
    std::vector<LatticeLoop> sorted;
    for (const std::size_t k : order) sorted.push_back(std::move(loops[placed + k]));
    std::move(sorted.begin(), sorted.end(), loops.begin() + static_cast<std::ptrdiff_t>(placed));
    for (std::size_t k = 0; k < std::min(at_once, order.size()); ++k, ++placed)
      for (LatticePlace& p : loops[placed].places) p = p + nearest_place(shifts[order[k]]);
  }
  return true;
}

}  // namespace lpq
