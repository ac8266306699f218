// Flattening. A cubic is halved [de Casteljau] until its control points lie within 4/3 of the
// tolerance from the chord, for B(t) strays from it by at most 3 t (1 - t) <= 3/4 of that distance.
// An arc of radius r and angle d strays from its chord by r (1 - cos(d/2)) <= r d^2 / 8; for the
// image of a circle under a linear map, r is the largest stretch.
#include "io/domain/curves.h"

#include <algorithm>
#include <cmath>

#include "numerics/elementary.h"

namespace lpq {
namespace {

constexpr int deepest_halving = 10;
constexpr double widest_step = pi / 8;  // of an arc: 3 % of the area of a circle at most
constexpr double finest_arc = 4096;     // pieces
constexpr double rounding = 1e-9;       // of angles

/// Distance of p from the segment a b, squared.
double squared_distance_to(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 ab = b - a, ap = p - a;
  const double along = dot(ap, ab), length2 = squared_length(ab);
  if (!(along > 0)) return squared_length(ap);
  if (along >= length2) return squared_length(p - b);
  const double across = cross(ab, ap);
  return across * across / length2;
}

/// The polyline that is being made.
struct Flattened {
  std::vector<Vec2>& polyline;
  std::vector<double>* bows;

  /// The edge to p, for a curve that is at `middle` midway.
  void add(Vec2 p, Vec2 middle) {
    if (bows != nullptr) bows->push_back(bow_of(polyline.back(), p, middle));
    polyline.push_back(p);
  }
};

void flatten_cubic(Vec2 a, Vec2 b, Vec2 c, Vec2 d, double limit2, int depth, Flattened& flattened) {
  const bool flat =
      squared_distance_to(b, a, d) <= limit2 && squared_distance_to(c, a, d) <= limit2;
  if (flat || depth == deepest_halving) {
    flattened.add(d, 0.125 * (a + d) + 0.375 * (b + c));
    return;
  }
  const Vec2 ab = midpoint(a, b), bc = midpoint(b, c), cd = midpoint(c, d);
  const Vec2 abc = midpoint(ab, bc), bcd = midpoint(bc, cd), middle = midpoint(abc, bcd);
  flatten_cubic(a, ab, abc, middle, limit2, depth + 1, flattened);
  flatten_cubic(middle, bcd, cd, d, limit2, depth + 1, flattened);
}

/// See CurvePath::arc_to.
struct Arc {
  Vec2 start, centre, axis;
  double sweep;
  Vec2 end;

  Vec2 radius() const { return start - centre; }
};

/// The largest stretch of the map (1, 0) -> u, (0, 1) -> v.
double largest_stretch(Vec2 u, Vec2 v) {
  const double p = squared_length(u), q = squared_length(v), r = dot(u, v);
  const double half = 0.5 * (p - q);
  return std::sqrt(0.5 * (p + q) + std::sqrt(half * half + r * r));
}

/// By the corners of tangents around the arc, at most a quarter turn each, and its end.
void extend_by_arc(const Arc& arc, Box& box) {
  const Vec2 u = arc.radius();
  const double quarters = std::min(std::ceil(std::abs(arc.sweep) / (pi / 2)), 4.0);
  const double stretch = 1 / sin_cos(arc.sweep / (2 * quarters)).cos;
  for (double i = 0; i < quarters; ++i) {
    const SinCos t = sin_cos(arc.sweep * ((i + 0.5) / quarters));
    extend(box, arc.centre + stretch * (t.cos * u + t.sin * arc.axis));
  }
  extend(box, arc.end);
}

/// Appends its corners, without its start and with its end.
void flatten_arc(const Arc& arc, double tolerance, Flattened& flattened) {
  const Vec2 u = arc.radius();
  const double step = std::sqrt(8 * tolerance / largest_stretch(u, arc.axis));
  double pieces = std::ceil(std::abs(arc.sweep) / std::min(widest_step, step));
  // The same corners in every quarter turn keep the symmetry of circles, and make circles drawn in
  // halves and quarters the same as whole ones.
  const double quarters = std::round(std::abs(arc.sweep) / (pi / 2));
  const bool whole_quarters = std::abs(std::abs(arc.sweep) - quarters * (pi / 2)) <= rounding;
  if (quarters > 0 && whole_quarters) pieces = quarters * std::ceil(pieces / quarters);
  if (!(pieces <= finest_arc)) pieces = finest_arc;  // also NaN
  // The middle of a chord is nearer to the centre than that of its arc.
  const double stretch = 1 / sin_cos(arc.sweep / (2 * pieces)).cos;
  const auto add = [&](Vec2 p) {
    const Vec2 chord = midpoint(flattened.polyline.back(), p);
    flattened.add(p, arc.centre + stretch * (chord - arc.centre));
  };
  for (double i = 1; i < pieces; ++i) {
    const SinCos t = sin_cos(arc.sweep * (i / pieces));
    add(arc.centre + t.cos * u + t.sin * arc.axis);
  }
  add(arc.end);
}

}  // namespace

Affine operator*(const Affine& outer, const Affine& inner) {
  const Vec2 x = outer.direction({inner.a, inner.b}), y = outer.direction({inner.c, inner.d});
  const Vec2 shift = outer({inner.e, inner.f});
  return {x.x, x.y, y.x, y.y, shift.x, shift.y};
}

void CurvePath::line_to(Vec2 end) {
  kinds_.push_back(Kind::line);
  points_.push_back(end);
}

void CurvePath::quadratic_to(Vec2 control, Vec2 end) {
  const Vec2 a = current();  // the same curve as a cubic
  cubic_to(a + (2.0 / 3) * (control - a), end + (2.0 / 3) * (control - end), end);
}

void CurvePath::cubic_to(Vec2 first_control, Vec2 second_control, Vec2 end) {
  kinds_.push_back(Kind::cubic);
  points_.insert(points_.end(), {first_control, second_control, end});
}

void CurvePath::arc_to(Vec2 centre, Vec2 axis, double sweep, Vec2 end) {
  kinds_.push_back(Kind::arc);
  points_.insert(points_.end(), {centre, axis, {sweep, 0}, end});
}

std::size_t CurvePath::point_count(Kind kind) {
  switch (kind) {
    case Kind::line: return 1;
    case Kind::cubic: return 3;
    case Kind::arc: return 4;
  }
  return 0;
}

void CurvePath::transform(const Affine& map) {
  points_[0] = map(points_[0]);
  std::size_t at = 1;
  for (const Kind kind : kinds_) {
    for (std::size_t i = 0; i < point_count(kind); ++i, ++at) {
      if (kind == Kind::arc && i == 2) continue;
      points_[at] = kind == Kind::arc && i == 1 ? map.direction(points_[at]) : map(points_[at]);
    }
  }
}

void CurvePath::extend(Box& box) const {
  lpq::extend(box, points_[0]);
  std::size_t at = 1;
  for (const Kind kind : kinds_) {
    const Vec2* p = points_.data() + at;
    if (kind == Kind::arc) {
      extend_by_arc({p[-1], p[0], p[1], p[2].x, p[3]}, box);
    } else {
      for (std::size_t i = 0; i < point_count(kind); ++i) lpq::extend(box, p[i]);
    }
    at += point_count(kind);
  }
}

double bow_of(Vec2 a, Vec2 b, Vec2 middle) {
  return a == b ? 0 : cross(b - a, middle - a) / distance(a, b);
}

void CurvePath::flatten(double tolerance, std::vector<Vec2>& polyline,
                        std::vector<double>* bows) const {
  Flattened flattened{polyline, bows};
  polyline.push_back(points_[0]);
  const double limit = tolerance * (4.0 / 3);
  std::size_t at = 1;
  for (const Kind kind : kinds_) {
    const Vec2* p = points_.data() + at;
    switch (kind) {
      case Kind::line: flattened.add(p[0], p[0]); break;
      case Kind::cubic: flatten_cubic(p[-1], p[0], p[1], p[2], limit * limit, 0, flattened); break;
      case Kind::arc: flatten_arc({p[-1], p[0], p[1], p[2].x, p[3]}, tolerance, flattened); break;
    }
    at += point_count(kind);
  }
}

double flattening_tolerance(const Box& box) {
  const double size = longer_side(box);
  return size > 0 && std::isfinite(size) ? flattening * size : 0;
}

Direction direction_of_degrees(double degrees) {
  const double turned = degrees - 360 * std::floor(degrees / 360);
  if (turned == 0 || turned == 360) return {1, 0};
  if (turned == 90) return {0, 1};
  if (turned == 180) return {-1, 0};
  if (turned == 270) return {0, -1};
  const SinCos t = sin_cos(turned * (pi / 180));
  return {t.cos, t.sin};
}

}  // namespace lpq
