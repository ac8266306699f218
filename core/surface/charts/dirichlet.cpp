#include "surface/charts/dirichlet.h"

#include <algorithm>
#include <cmath>

#include "numerics/elementary.h"
#include "numerics/lbfgs.h"
#include "numerics/sparse.h"
#include "surface/charts/checks.h"
#include "surface/charts/intrinsic.h"
#include "surface/frames.h"

namespace lpq {
namespace {

constexpr int iterations = 300;
constexpr double drop = 1e-4;  // relative, over the optimiser's window: good enough to be judged

// Border on a circle by length, every inner vertex at the mean of its neighbours (holes filled).
bool tutte(const Part& part, const Intrinsic& disk, std::vector<Vec2>& uv) {
  std::vector<Vec2> at(disk.vertices);
  std::vector<Index> row(disk.vertices, 0);
  const double total = loop_length(part, 0), radius = total / (2 * pi);
  double length = 0;
  for (const Index e : part.loops.row(0)) {
    const SinCos t = sin_cos(2 * pi * length / total);
    at[part.origin(e)] = {radius * t.cos, radius * t.sin};
    row[part.origin(e)] = none;
    length += part.length[e];
  }
  Index rows = 0;
  for (Index& r : row)
    if (r != none) r = rows++;
  std::vector<Triplet> entries;
  std::vector<double> b(2 * static_cast<std::size_t>(rows), 0.0), x;
  for (Index e = 0; e < static_cast<Index>(disk.twins.size()); ++e) {
    const Index v = corners_of(disk.corners)[e];
    const Index w = corners_of(disk.corners)[next_in_triangle(e)];
    // Both half-edges of an inner edge come by; each stands for its origin.
    if (row[v] == none) continue;
    entries.push_back({row[v], row[v], 1});
    if (row[w] == none) {
      b[row[v]] += at[w].x;
      b[rows + row[v]] += at[w].y;
    } else if (row[w] < row[v]) {
      entries.push_back({row[v], row[w], -1});
    }
  }
  if (solve_spd(rows, entries, b, 2, x) != SparseStatus::ok) return false;
  for (Index v = 0; v < disk.vertices; ++v)
    if (row[v] != none) at[v] = {x[row[v]], x[rows + row[v]]};
  uv.assign(at.begin(), at.begin() + part.vertex_count());
  return true;
}

// |J|^2 (1 + 1 / det^2) per unit of area, over the triangles of a part.
class SymmetricDirichlet {
 public:
  SymmetricDirichlet(const SurfaceMesh& mesh, const Part& part) : part_(part) {
    for (const Index t : part.triangles) {
      const TriangleLayout layout = layout_of(mesh, t);
      total_ += layout.area;
      layouts_.push_back(layout);
    }
    // Triangles without height would make the energy infinite whatever the map.
    least_ = 1e-12 * total_ / static_cast<double>(layouts_.size());
  }
  double total_area() const { return total_; }

  Evaluation operator()(std::span<const double> x, std::span<double> gradient) const {
    std::fill(gradient.begin(), gradient.end(), 0.0);
    Evaluation result;
    const auto point = [&](Index v) { return Vec2{x[2 * v], x[2 * v + 1]}; };
    for (std::size_t t = 0; t < layouts_.size(); ++t) {
      const auto [a, b, c] = part_.corners[t];
      const Vec2 ab = point(b) - point(a), ac = point(c) - point(a);
      const double det_uv = cross(ab, ac);
      if (!(det_uv > 0)) return {0, EvalStatus::outside_domain};
      if (layouts_[t].area > least_) add(layouts_[t], ab, ac, {a, b, c}, result.value, gradient);
    }
    result.value /= total_;
    for (double& g : gradient) g /= total_;
    return result;
  }

 private:
  void add(const TriangleLayout& layout, Vec2 ab, Vec2 ac, const Tri& tri, double& value,
           std::span<double> gradient) const {
    const double l = layout.side[0].x, qx = -layout.side[2].x, qy = -layout.side[2].y;
    const double inverse = 1 / (l * qy);
    const Vec2 jx = (1 / l) * ab, jy = inverse * (l * ac - qx * ab);
    const double det = cross(jx, jy), norm2 = squared_length(jx) + squared_length(jy);
    const double inverse2 = 1 / (det * det);
    value += layout.area * norm2 * (1 + inverse2);
    // d/dJ: 2 (1 + 1/det^2) J - 2 norm2 / det^3 cof J
    const double s = 2 * layout.area * (1 + inverse2);
    const double k = 2 * layout.area * norm2 * inverse2 / det;
    const Vec2 gx = s * jx - k * Vec2{jy.y, -jy.x}, gy = s * jy - k * Vec2{-jx.y, jx.x};
    const Vec2 to_c = (inverse * l) * gy, to_b = (1 / l) * gx - (inverse * qx) * gy;
    const Vec2 force[3] = {-(to_b + to_c), to_b, to_c};
    for (int i = 0; i < 3; ++i) {
      gradient[2 * tri[i]] += force[i].x;
      gradient[2 * tri[i] + 1] += force[i].y;
    }
  }

  const Part& part_;
  std::vector<TriangleLayout> layouts_;
  double total_ = 0, least_ = 0;
};

}  // namespace

bool map_symmetric_dirichlet(const SurfaceMesh& mesh, const Part& part, std::vector<Vec2>& uv) {
  const Intrinsic disk = intrinsic_of(mesh, part);
  if (!tutte(part, disk, uv) || count_flipped(part, uv) > 0) return false;
  const SymmetricDirichlet energy(mesh, part);
  double area = 0;
  for (const auto& [a, b, c] : part.corners) area += 0.5 * cross(uv[b] - uv[a], uv[c] - uv[a]);
  const double grow = std::sqrt(energy.total_area() / area);
  std::vector<double> x;
  for (const Vec2 p : uv) {
    x.push_back(grow * p.x);
    x.push_back(grow * p.y);
  }
  LbfgsOptions options;
  options.value_tolerance = drop;
  const double side = std::sqrt(energy.total_area() / part.triangle_count());
  const std::size_t unknowns = x.size();
  Lbfgs optimiser(std::move(x), options, std::vector<double>(unknowns, side));
  optimiser.step(iterations, energy);
  for (std::size_t v = 0; v < uv.size(); ++v)
    uv[v] = {optimiser.x()[2 * v], optimiser.x()[2 * v + 1]};
  return true;
}

}  // namespace lpq
