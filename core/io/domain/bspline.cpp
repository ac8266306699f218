// De Boor's algorithm [Piegl and Tiller 1997, 4.2 for rational curves: on (w x, w y, w)].
#include "io/domain/bspline.h"

#include <algorithm>
#include <array>

#include "geometry/segment.h"
#include "io/domain/curves.h"

namespace lpq {
namespace {

constexpr int deepest_halving = 10;

struct Homogeneous {
  Vec2 p;  // times w
  double w;
};

/// The span k with knots[k] <= u < knots[k + 1], the last one that is not empty for the end.
std::size_t span_of(const BSpline& spline, double u) {
  const auto degree = static_cast<std::size_t>(spline.degree);
  const auto first = spline.knots.begin() + spline.degree;
  const auto last = spline.knots.begin() + static_cast<std::ptrdiff_t>(spline.control.size());
  const auto above =
      u < *last ? std::upper_bound(first, last + 1, u) : std::lower_bound(first, last + 1, *last);
  return std::max(degree, static_cast<std::size_t>(above - spline.knots.begin()) - 1);
}

class Flattener {
 public:
  Flattener(const BSpline& spline, double tolerance, std::vector<Vec2>& polyline,
            std::vector<double>* bows)
      : spline_(spline), tolerance_(tolerance), polyline_(polyline), bows_(bows) {}

  void span(double u, Vec2 p, double v, Vec2 q, int depth) {
    const double middle = 0.5 * (u + v);
    const Vec2 m = spline_point(spline_, middle);
    const bool flat = depth > 0 && near(m, p, q) &&
                      near(spline_point(spline_, 0.5 * (u + middle)), p, q) &&
                      near(spline_point(spline_, 0.5 * (middle + v)), p, q);
    if (flat || depth == deepest_halving || !(u < middle && middle < v)) {
      if (bows_ != nullptr) bows_->push_back(bow_of(p, q, m));
      polyline_.push_back(q);
      return;
    }
    span(u, p, middle, m, depth + 1);
    span(middle, m, v, q, depth + 1);
  }

 private:
  bool near(Vec2 p, Vec2 a, Vec2 b) const {
    return squared_length(p - closest_point(p, a, b)) <= tolerance_ * tolerance_;
  }

  const BSpline& spline_;
  double tolerance_;
  std::vector<Vec2>& polyline_;
  std::vector<double>* bows_;
};

}  // namespace

const char* spline_problem(const BSpline& spline) {
  if (spline.degree < 1 || spline.degree > largest_degree) return "has a degree outside 1 .. 15";
  const std::size_t order = static_cast<std::size_t>(spline.degree) + 1;
  if (spline.control.size() < order) return "has fewer control points than its degree asks for";
  if (spline.knots.size() != spline.control.size() + order)
    return "does not have as many knots as control points + degree + 1";
  if (!std::is_sorted(spline.knots.begin(), spline.knots.end())) return "has knots that decrease";
  if (!(spline.knots[order - 1] < spline.knots[spline.control.size()]))
    return "has no knot interval";
  if (!spline.weights.empty() && spline.weights.size() != spline.control.size())
    return "does not have one weight per control point";
  for (const double w : spline.weights)
    if (!(w > 0)) return "has a weight that is not positive";
  return nullptr;
}

Vec2 spline_point(const BSpline& spline, double u) {
  const std::size_t k = span_of(spline, u), degree = static_cast<std::size_t>(spline.degree);
  std::array<Homogeneous, largest_degree + 1> d;
  for (std::size_t j = 0; j <= degree; ++j) {
    const std::size_t i = k - degree + j;
    const double w = spline.weights.empty() ? 1 : spline.weights[i];
    d[j] = {w * spline.control[i], w};
  }
  for (std::size_t r = 1; r <= degree; ++r) {
    for (std::size_t j = degree; j >= r; --j) {
      const double lo = spline.knots[k - degree + j], hi = spline.knots[k + 1 + j - r];
      const double t = hi > lo ? (u - lo) / (hi - lo) : 0;
      d[j] = {(1 - t) * d[j - 1].p + t * d[j].p, (1 - t) * d[j - 1].w + t * d[j].w};
    }
  }
  return (1 / d[degree].w) * d[degree].p;
}

void extend(Box& box, const BSpline& spline) {
  for (const Vec2 p : spline.control) extend(box, p);
}

void flatten(const BSpline& spline, double tolerance, std::vector<Vec2>& polyline,
             std::vector<double>* bows) {
  const auto degree = static_cast<std::size_t>(spline.degree);
  Flattener flattener(spline, tolerance, polyline, bows);
  Vec2 p = spline_point(spline, spline.knots[degree]);
  polyline.push_back(p);
  for (std::size_t k = degree; k < spline.control.size(); ++k) {
    const double u = spline.knots[k], v = spline.knots[k + 1];
    if (!(u < v)) continue;
    const Vec2 q = spline_point(spline, v);
    flattener.span(u, p, v, q, 0);
    p = q;
  }
}

std::vector<Vec2> natural_spline_tangents(const std::vector<Vec2>& points,
                                          const std::vector<double>& lengths) {
  // Second derivatives agree at inner points and vanish at the ends: a tridiagonal system with
  // rows (2, 1), (1/h, 2/h + 2/h', 1/h'), (1, 2) [de Boor 2001, chapter IV].
  const std::size_t n = points.size();
  const auto slope = [&](std::size_t i) { return (1 / lengths[i]) * (points[i + 1] - points[i]); };
  std::vector<double> factor(n, 0);
  std::vector<Vec2> tangent(n);
  factor[0] = 0.5;
  tangent[0] = 1.5 * slope(0);
  for (std::size_t i = 1; i < n; ++i) {
    const bool last = i + 1 == n;
    const double before = last ? 1 : 1 / lengths[i - 1], after = last ? 0 : 1 / lengths[i];
    const double diagonal = last ? 2 : 2 * (before + after);
    const Vec2 right =
        last ? 3 * slope(i - 1) : (3 * before) * slope(i - 1) + (3 * after) * slope(i);
    const double pivot = diagonal - before * factor[i - 1];
    factor[i] = after / pivot;
    tangent[i] = (1 / pivot) * (right - before * tangent[i - 1]);
  }
  for (std::size_t i = n - 1; i-- > 0;) tangent[i] -= factor[i] * tangent[i + 1];
  return tangent;
}

}  // namespace lpq
