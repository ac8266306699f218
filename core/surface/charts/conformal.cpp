#include "surface/charts/conformal.h"

#include <array>
#include <cmath>
#include <complex>

#include "base/rng.h"
#include "numerics/sparse.h"

namespace lpq {
namespace {

using Complex = std::complex<double>;

constexpr int inverse_iterations = 30;
// Added to the diagonal as a share of its mean: constants are in the kernel.
constexpr double shift = 1e-8;

// z* H z = 2 (Dirichlet energy - area); the area depends on the border alone.
std::vector<ComplexTriplet> conformal_energy(const Intrinsic& surface) {
  const std::vector<double> weights = half_cotangents(surface);
  std::vector<ComplexTriplet> entries;
  entries.reserve(3 * weights.size());
  for (Index e = 0; e < static_cast<Index>(weights.size()); ++e) {
    const Index a = corners_of(surface.corners)[e];
    const Index b = corners_of(surface.corners)[next_in_triangle(e)];
    const double w = weights[e];
    if (a == b) continue;  // an edge from a vertex to itself
    entries.push_back({a, a, w});
    entries.push_back({b, b, w});
    const double area = surface.twins[e] == none ? 0.5 : 0.0;
    if (a > b)
      entries.push_back({a, b, {-w, area}});
    else
      entries.push_back({b, a, {-w, -area}});
  }
  return entries;
}

// The two border vertices that are farthest apart, nearly: from any one to the farthest, twice.
std::array<Index, 2> far_apart(const SurfaceMesh& mesh, const Part& part) {
  const auto loop = part.loops.row(0);
  const auto farthest_from = [&](Index from) {
    Index best = from;
    double most = -1;
    for (const Index e : loop) {
      const Index v = part.origin(e);
      const double d = squared_length(mesh.points[part.vertex[v]] - mesh.points[part.vertex[from]]);
      if (v != from && d > most) most = d, best = v;
    }
    return best;
  };
  const Index first = farthest_from(part.origin(loop[0]));
  return {first, farthest_from(first)};
}

std::vector<Vec2> vectors_of(const std::vector<Complex>& x, std::size_t count) {
  std::vector<Vec2> uv;
  for (std::size_t v = 0; v < count; ++v) uv.push_back({x[v].real(), x[v].imag()});
  return uv;
}

}  // namespace

bool map_lscm(const SurfaceMesh& mesh, const Part& part, const Intrinsic& surface,
              std::vector<Vec2>& uv) {
  const auto [still, moved] = far_apart(mesh, part);
  std::vector<Complex> value(surface.vertices);
  value[moved] = distance(mesh.points[part.vertex[still]], mesh.points[part.vertex[moved]]);
  std::vector<Index> row(surface.vertices, 0);
  row[still] = row[moved] = none;
  Index rows = 0;
  for (Index& r : row)
    if (r != none) r = rows++;
  std::vector<ComplexTriplet> entries;
  std::vector<Complex> rhs(rows);
  for (const auto& [i, j, h] : conformal_energy(surface)) {
    if (row[i] != none && row[j] != none)
      entries.push_back({row[i], row[j], h});
    else if (row[i] != none)
      rhs[row[i]] -= h * value[j];
    else if (row[j] != none)
      rhs[row[j]] -= std::conj(h) * value[i];
  }
  const SparseFactor<Complex> factor(rows, entries);
  if (factor.status() != SparseStatus::ok) return false;
  factor.solve(rhs, rhs);
  for (Index v = 0; v < surface.vertices; ++v)
    if (row[v] != none) value[v] = rhs[row[v]];
  uv = vectors_of(value, part.vertex.size());
  return true;
}

bool map_scp(const Part& part, const Intrinsic& surface, std::vector<Vec2>& uv) {
  std::vector<ComplexTriplet> entries = conformal_energy(surface);
  double trace = 0;
  for (const ComplexTriplet& t : entries)
    if (t.row == t.column) trace += std::abs(t.value.real());
  for (Index v = 0; v < surface.vertices; ++v)
    entries.push_back({v, v, shift * trace / surface.vertices});
  const SparseFactor<Complex> factor(surface.vertices, entries);
  if (factor.status() != SparseStatus::ok) return false;

  std::vector<Index> border;
  for (const Index e : part.loops.values) border.push_back(part.origin(e));
  std::vector<Complex> x(surface.vertices), b(surface.vertices);
  Rng rng(1);
  for (const Index v : border) {
    const double re = rng.between(-1, 1), im = rng.between(-1, 1);
    x[v] = {re, im};
  }
  for (int i = 0; i < inverse_iterations; ++i) {
    Complex mean;
    double norm2 = 0;
    for (const Index v : border) mean += (1.0 / static_cast<double>(border.size())) * x[v];
    for (const Index v : border) {
      b[v] = x[v] - mean;
      norm2 += b[v].real() * b[v].real() + b[v].imag() * b[v].imag();
    }
    if (!(norm2 > 0)) return false;
    for (const Index v : border) b[v] *= 1 / std::sqrt(norm2);
    factor.solve(b, x);
  }
  uv = vectors_of(x, part.vertex.size());
  return true;
}

}  // namespace lpq
