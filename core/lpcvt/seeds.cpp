// The isotropic start: equilateral triangles growing from an interior point, spacing proportional
// to h (an exact lattice where h is constant), scaled until the count fits. [paper Fig. 2 shows
// such a start; its quality matters little, its count does.]
#include "lpcvt/seeds.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/rng.h"
#include "base/sort_numbers.h"
#include "field/inside.h"
#include "lpcvt/packing.h"
#include "lpcvt/phase_field.h"

namespace lpq {
namespace {

// Side of the equilateral lattice with one point per unit area: sqrt(2 / sqrt 3).
constexpr double lattice_side = 1.0745699318235418;
// A neighbour is refused nearer than this share of the local side: fronts that meet out of step
// then leave gaps below two sides.
constexpr double lattice_separation = 0.72;
// Integer points of the phases nearer to each other than this share of h come from a fold.
constexpr double phase_separation = 0.55;
// The caller's points may be as bad a start as he likes, short of being one point.
constexpr double given_separation = 1e-3;
constexpr double half_root_3 = 0.86602540378443865;

// Used vertices, edges (both sides of an inner wall are one) and triangles of the background.
double euler_characteristic(const TriMesh& mesh, double outer_edges) {
  std::vector<char> used(mesh.points.size(), 0);
  for (const Tri& tri : mesh.triangles)
    for (const Index v : tri) used[v] = 1;
  const double vertices = std::accumulate(used.begin(), used.end(), 0.0);
  const double triangles = mesh.triangle_count();
  return vertices - 0.5 * (3 * triangles + outer_edges) + triangles;
}

double outer_edge_count(const BoundaryMesh& boundary) {
  double count = 0;
  for (const Segment& s : boundary.edges) count += s.left == none || s.right == none;
  return count;
}

// One lattice of the given scale over the whole domain.
class LatticeFront {
 public:
  LatticeFront(const BoundaryMesh& boundary, const Fields& fields, const WallDistance& walls,
               const SeedOptions& options, double scale)
      : fields_(fields),
        walls_(walls),
        options_(options),
        side_(scale * lattice_side),
        packing_(boundary, fields),
        direction_(packing_.points.size()) {}

  Packing run() {
    const TriMesh& mesh = fields_.background;
    for (Index t = 0; t < mesh.triangle_count() && !full(); ++t) {
      const auto [a, b, c] = mesh.triangles[t];
      const Vec2 centre = (1.0 / 3) * (mesh.points[a] + mesh.points[b] + mesh.points[c]);
      if (place(centre, {1, 0}, t)) grow();
    }
    return std::move(packing_);
  }

 private:
  bool full() const { return packing_.interior_count() >= options_.max_points; }

  bool place(Vec2 p, Vec2 direction, Index t) {
    const double h = fields_.size(p, t);
    const double least = lattice_separation * side_ * h;
    const auto too_near = [&](Index i, Vec2 q) {
      return i >= packing_.fixed &&
             squared_length(fields_.stretched_at(p, q - p, t)) < least * least;
    };
    if (packing_.grid.any_near(p, h, fields_.longest_step() * least, too_near)) return false;
    if (walls_.nearer_than(p, h, options_.clearance * h)) return false;
    packing_.add(p, h, t);
    direction_.push_back(direction);
    return true;
  }

  void grow() {
    for (Index i = static_cast<Index>(packing_.points.size()) - 1;
         i < static_cast<Index>(packing_.points.size()) && !full(); ++i) {
      const Vec2 x = packing_.points[i];
      Index at = packing_.triangle[i];
      const double h = fields_.size(x, at);
      Vec2 direction = direction_[i];
      for (int k = 0; k < 6; ++k) {
        const Vec2 way = fields_.unstretched_at(x, direction, at);
        Index t = fields_.walk(x + 0.5 * side_ * h * way, at);
        if (t != none) {
          const double middle_h = fields_.size(x + 0.5 * side_ * h * way, t);
          const Vec2 y = x + side_ * middle_h * way;
          t = fields_.walk(y, t);
          if (t != none) place(y, direction, t);
        }
        direction = {0.5 * direction.x - half_root_3 * direction.y,
                     half_root_3 * direction.x + 0.5 * direction.y};
      }
    }
  }

  const Fields& fields_;
  const WallDistance& walls_;
  const SeedOptions& options_;
  double side_;
  Packing packing_;
  std::vector<Vec2> direction_;  // #points of the packing
};

// Removes the points nearest to another one or to a boundary node until `wanted` remain.
std::vector<Vec2> drop_surplus(const Fields& fields, const Packing& packing, Index wanted) {
  const Index fixed = packing.fixed;
  const Index count = packing.interior_count();
  std::vector<std::pair<double, Index>> crowding(count);
  std::vector<Index> nearest(count, none);
  for (Index i = 0; i < count; ++i) {
    const Vec2 p = packing.points[fixed + i];
    Index t = packing.triangle[fixed + i];
    const double h = fields.size(p, t);
    double best = 4 * h * h;
    packing.grid.any_near(p, h, 1.5 * h, [&](Index j, Vec2 q) {
      const double d2 = squared_length(q - p);
      if (j != fixed + i && (d2 < best || (d2 == best && j < nearest[i])))
        best = d2, nearest[i] = j;
      return false;
    });
    crowding[i] = {best / (h * h), i};
  }
  sort_values(crowding);
  std::vector<char> dropped(count, 0);
  Index surplus = count - wanted;
  for (const auto& [ratio, i] : crowding) {
    if (surplus <= 0) break;
    const Index other = nearest[i];
    if (other >= fixed && dropped[other - fixed]) continue;
    dropped[i] = 1;
    --surplus;
  }
  std::vector<Vec2> kept;
  for (Index i = 0; i < count; ++i)
    if (!dropped[i]) kept.push_back(packing.points[fixed + i]);
  return kept;
}

// Small random moves that respect the clearance: an exact lattice is a degenerate start.
void jitter(const Fields& fields, const WallDistance& walls, const SeedOptions& options,
            std::vector<Vec2>& points) {
  if (options.jitter <= 0) return;
  Rng rng(options.seed);
  Index hint = none;
  for (Vec2& p : points) {
    const double h = fields.size(p, hint);
    const Vec2 move{rng.between(-1, 1), rng.between(-1, 1)};
    const Vec2 q = p + options.jitter * h * move;
    if (hint == none || fields.walk(q, hint) == none) continue;
    if (!walls.nearer_than(q, h, options.clearance * h)) p = q;
  }
}

}  // namespace

double expected_interior_points(const BoundaryMesh& boundary, const Fields& fields) {
  // Q quads on a domain with B outer edges have Q + B/2 + chi vertices, the fixed ones among them.
  const double outer = outer_edge_count(boundary);
  const double chi = euler_characteristic(fields.background, outer);
  const double all = cell_capacity(fields) + 0.5 * outer + chi;
  return std::max(all - static_cast<double>(boundary.points.size()), 0.0);
}

std::vector<Vec2> isotropic_seeds(const BoundaryMesh& boundary, const Fields& fields,
                                  const SeedOptions& options) {
  const WallDistance walls(boundary, fields);
  const double expected = std::floor(expected_interior_points(boundary, fields) + 0.5);
  const Index wanted =
      static_cast<Index>(std::min(expected, static_cast<double>(options.max_points)));
  if (wanted <= 0) return {};
  constexpr int attempts = 6;
  constexpr double surplus_allowed = 1.015;  // dropped afterwards without visible gaps
  double scale = 1;
  Packing best(boundary, fields);
  Index best_count = 0;
  for (int i = 0; i < attempts; ++i) {
    Packing packing = LatticeFront(boundary, fields, walls, options, scale).run();
    const Index count = packing.interior_count();
    const bool enough = count >= wanted, best_enough = best_count >= wanted;
    if (i == 0 || (enough && (!best_enough || count < best_count)) ||
        (!enough && !best_enough && count > best_count)) {
      best = std::move(packing);
      best_count = count;
    }
    if (enough && count <= std::floor(surplus_allowed * wanted) + 1) break;
    const double aim = (0.5 * (1 + surplus_allowed)) * wanted + 0.5;
    scale = std::clamp(scale * std::sqrt((count + 1.0) / (aim + 1.0)), 0.75, 1.5);
  }
  std::vector<Vec2> points = drop_surplus(fields, best, wanted);
  jitter(fields, walls, options, points);
  return points;
}

std::vector<Vec2> aligned_seeds(const BoundaryMesh& boundary, const Fields& fields,
                                const SeedOptions& options) {
  const WallDistance walls(boundary, fields);
  Packing packing(boundary, fields);
  for (const PhasePoint& point : phase_points(boundary, fields)) {
    Index t = point.triangle;
    const double h = fields.size(point.position, t);
    const double least = phase_separation * h;
    if (walls.nearer_than(point.position, h, options.clearance * h)) continue;
    const auto too_near = [&](Index, Vec2 q) {
      return squared_length(q - point.position) < least * least;
    };
    if (packing.grid.any_near(point.position, h, least, too_near)) continue;
    if (packing.interior_count() >= options.max_points) break;
    packing.add(point.position, h, t);
  }
  PackingRule rule;
  rule.max_points = options.max_points;
  pack_inward(boundary, fields, walls, rule, packing);
  return packing.interior();
}

std::vector<Vec2> given_seeds(const BoundaryMesh& boundary, const Fields& fields,
                              std::span<const Vec2> points) {
  const WallDistance walls(boundary, fields);
  const std::vector<Index> region = regions_of(boundary, points);
  Packing packing(boundary, fields);
  Index hint = none;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (region[i] == none) continue;
    const Vec2 p = points[i];
    const double h = fields.size(p, hint), least = given_separation * h;
    const auto too_near = [&](Index, Vec2 q) { return squared_length(q - p) < least * least; };
    if (walls.nearer_than(p, h, least) || packing.grid.any_near(p, h, least, too_near)) continue;
    packing.add(p, h, hint);
  }
  return packing.interior();
}

}  // namespace lpq
