// Sampling of the fields: one triangle found by a short walk, one linear interpolation, two half
// angles. theta = arg(z) / 4 gives grad theta = (a grad b - b grad a) / (4 |z|^2) for z = a + i b.
#include "field/field.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace lpq {
namespace {

// Barycentric coordinates down to minus this still count as inside: one rounding error of the
// coordinate differences, so that points on shared edges stop the walk.
constexpr double rim = 1e-12;
// A walk longer than this is a bad hint; the locator's grid is cheaper.
constexpr int longest_walk = 48;

// Sine of an angle at a corner: a triangle of collinear corners, or a flatter one than rounding can
// tell from that, is taken to be a little higher than it is, so that its values stay numbers.
constexpr double flattest = 1e-15;

double clamped(double value, double low, double high) {
  return std::min(std::max(value, low), high);
}

}  // namespace

Fields::Fields(const Fields& other)
    : background(other.background),
      z(other.z),
      h(other.h),
      pull(other.pull),
      stretch(other.stretch),
      singularities(other.singularities),
      has_spots(other.has_spots),
      locator(background),
      cells_(other.cells_) {}

Fields::Fields(Fields&& other) noexcept
    : background(std::move(other.background)),
      z(std::move(other.z)),
      h(std::move(other.h)),
      pull(std::move(other.pull)),
      stretch(std::move(other.stretch)),
      singularities(std::move(other.singularities)),
      has_spots(other.has_spots),
      locator(background),
      cells_(std::move(other.cells_)) {}

Fields& Fields::operator=(Fields other) noexcept {
  background = std::move(other.background);
  z = std::move(other.z);
  h = std::move(other.h);
  pull = std::move(other.pull);
  stretch = std::move(other.stretch);
  singularities = std::move(other.singularities);
  has_spots = other.has_spots;
  cells_ = std::move(other.cells_);
  locator = Locator(background);
  return *this;
}

void Fields::attach() {
  locator = Locator(background);
  cells_.resize(background.triangles.size());
  for (Index t = 0; t < background.triangle_count(); ++t) {
    const auto [a, b, c] = background.triangles[t];
    const Vec2 o = background.points[a];
    const Vec2 e1 = background.points[b] - o, e2 = background.points[c] - o;
    const double inverse = 1 / std::max(cross(e1, e2), flattest * length(e1) * length(e2));
    Cell& cell = cells_[t];
    cell.origin = o;
    cell.lambda_1 = {inverse * e2.y, -inverse * e2.x};
    cell.lambda_2 = {-inverse * e1.y, inverse * e1.x};
    const Vec2 z1 = z[b] - z[a], z2 = z[c] - z[a];
    cell.z = z[a];
    cell.z_dx = cell.lambda_1.x * z1 + cell.lambda_2.x * z2;
    cell.z_dy = cell.lambda_1.y * z1 + cell.lambda_2.y * z2;
    cell.h = h[a];
    cell.h_gradient = (h[b] - h[a]) * cell.lambda_1 + (h[c] - h[a]) * cell.lambda_2;
  }
}

// The neighbour towards p across the edge that p is farthest beyond and that is no wall; t itself
// when p is inside; none when only walls separate them.
Index Fields::step(Vec2 p, Index t) const {
  const Cell& cell = cells_[t];
  const Vec2 d = p - cell.origin;
  const double l1 = dot(cell.lambda_1, d), l2 = dot(cell.lambda_2, d), l0 = 1 - l1 - l2;
  if (l0 >= -rim && l1 >= -rim && l2 >= -rim) return t;
  const double beyond[3] = {-l2, -l0, -l1};  // edge k runs from corner k to k + 1
  Index best = none;
  double farthest = rim;
  for (Index k = 0; k < 3; ++k)
    if (beyond[k] > farthest && background.twins[3 * t + k] != none) {
      farthest = beyond[k];
      best = triangle_of(background.twins[3 * t + k]);
    }
  return best;
}

Index Fields::walk(Vec2 p, Index from) const {
  Index t = from;
  for (int i = 0; i < longest_walk && t != none; ++i) {
    const Index next = step(p, t);
    if (next == t) return t;
    t = next;
  }
  return none;
}

// Moves p into the triangle found when it lies outside the domain, so that nothing is extrapolated.
const Fields::Cell& Fields::cell_at(Vec2& p, Index& hint) const {
  LPQ_ASSERT(cells_.size() == background.triangles.size() && !cells_.empty());
  if (hint >= 0 && hint < background.triangle_count()) {
    const Index found = walk(p, hint);
    if (found != none) {
      hint = found;
      return cells_[found];
    }
  }
  hint = none;
  hint = locator.find_nearest(p, hint);
  if (hint == none) hint = 0;
  const Cell& cell = cells_[hint];
  const Vec2 d = p - cell.origin;
  const double l1 = dot(cell.lambda_1, d), l2 = dot(cell.lambda_2, d), l0 = 1 - l1 - l2;
  if (l0 < -rim || l1 < -rim || l2 < -rim) {
    const double w0 = clamped(l0, 0, 1), w1 = clamped(l1, 0, 1), w2 = clamped(l2, 0, 1);
    const auto [a, b, c] = background.triangles[hint];
    p = (1 / (w0 + w1 + w2)) *
        (w0 * background.points[a] + w1 * background.points[b] + w2 * background.points[c]);
  }
  return cell;
}

FieldSample Fields::sample(Vec2 p, Index& hint) const {
  const Cell& cell = cell_at(p, hint);
  const Vec2 d = p - cell.origin;
  FieldSample s;
  s.h = cell.h + dot(cell.h_gradient, d);
  const double inverse_h = 1 / s.h;
  s.grad_log_h = inverse_h * cell.h_gradient;
  const Vec2 zp = cell.z + d.x * cell.z_dx + d.y * cell.z_dy;
  const double norm2 = squared_length(zp);
  if (norm2 == 0) return s;
  const double inverse_norm = 1 / std::sqrt(norm2);
  s.axis = unit_root(unit_root(inverse_norm * zp));
  const double w = 0.25 * inverse_norm * inverse_norm;
  s.grad_theta = {w * cross(zp, cell.z_dx), w * cross(zp, cell.z_dy)};
  const double steep2 = squared_length(s.grad_theta) * s.h * s.h;
  if (steep2 > 1) s.grad_theta = (1 / std::sqrt(steep2)) * s.grad_theta;
  return s;
}

double Fields::size(Vec2 p, Index& hint) const {
  const Cell& cell = cell_at(p, hint);
  return cell.h + dot(cell.h_gradient, p - cell.origin);
}

Vec2 Fields::interpolate(const std::vector<Vec2>& values, Vec2 p, Index& hint) const {
  if (values.empty()) return {0, 0};
  const Cell& cell = cell_at(p, hint);
  const Vec2 d = p - cell.origin;
  const double l1 = dot(cell.lambda_1, d), l2 = dot(cell.lambda_2, d);
  const auto [a, b, c] = background.triangles[hint];
  return (1 - l1 - l2) * values[a] + l1 * values[b] + l2 * values[c];
}

StretchSample Fields::sample_stretch(Vec2 p, Index& hint) const {
  StretchSample s{stretch_at(p, hint), {}, {}};
  const auto [a, b, c] = background.triangles[hint];
  const Vec2 mu_1 = stretch[b] - stretch[a], mu_2 = stretch[c] - stretch[a];
  const Cell& cell = cells_[hint];
  s.dx = cell.lambda_1.x * mu_1 + cell.lambda_2.x * mu_2;
  s.dy = cell.lambda_1.y * mu_1 + cell.lambda_2.y * mu_2;
  return s;
}

// Without the cancellation of 1 +- x.
Vec2 unit_root(Vec2 z) {
  if (z.x >= 0) {
    const double c = std::sqrt(0.5 * (1 + z.x));
    return {c, 0.5 * z.y / c};
  }
  const double s = std::sqrt(0.5 * (1 - z.x));
  return {0.5 * std::abs(z.y) / s, z.y < 0 ? -s : s};
}

double Fields::slope(Vec2 p, Index& hint) const { return length(cell_at(p, hint).h_gradient); }

Vec2 axis_of(Vec2 z) {
  const double norm2 = squared_length(z);
  if (norm2 == 0) return {1, 0};
  return unit_root(unit_root((1 / std::sqrt(norm2)) * z));
}

Vec2 cross_of(Vec2 direction) {
  const double largest = std::max(std::abs(direction.x), std::abs(direction.y));
  if (largest == 0) return {1, 0};
  const Vec2 d = (1 / largest) * direction;  // no underflow for tiny edges
  const Vec2 u = (1 / length(d)) * d;
  const Vec2 squared = complex_product(u, u);
  return complex_product(squared, squared);
}

double cell_capacity(const Fields& fields) {
  // Midpoint rule (degree 2) on four subtriangles: h is linear and graded, so 1/h^2 is smooth.
  double total = 0;
  for (const auto& [a, b, c] : fields.background.triangles) {
    const auto& p = fields.background.points;
    const double area = 0.5 * cross(p[b] - p[a], p[c] - p[a]);
    const double v[3] = {fields.h[a], fields.h[b], fields.h[c]};
    double sum = 0;
    const auto add = [&](double w0, double w1, double w2) {
      const double size = w0 * v[0] + w1 * v[1] + w2 * v[2];
      sum += 1 / (size * size);
    };
    for (int k = 0; k < 3; ++k) {
      const auto turned = [&](double x, double y, double w) {
        const double weights[3] = {x, y, w};
        add(weights[k], weights[(k + 1) % 3], weights[(k + 2) % 3]);
      };
      turned(0.75, 0.25, 0), turned(0.25, 0.75, 0);      // outer edges of the corner pieces
      turned(0.5, 0.25, 0.25), turned(0.5, 0.25, 0.25);  // inner edges, shared by two pieces
    }
    total += area * sum / 12;
  }
  return total;
}

}  // namespace lpq
