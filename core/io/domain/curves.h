// Curves of drawings, and the polylines that stand for them.
#pragma once

#include <span>
#include <vector>

#include "geometry/box.h"

namespace lpq {

/// x' = a x + c y + e, y' = b x + d y + f: the order of SVG's matrix(a b c d e f).
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Vec2 direction(Vec2 p) const { return {a * p.x + c * p.y, b * p.x + d * p.y}; }
  Vec2 operator()(Vec2 p) const { return direction(p) + Vec2{e, f}; }
};
/// First `inner`, then `outer`.
Affine operator*(const Affine& outer, const Affine& inner);

/// Polylines stray from their curves by no more than this, relative to the larger side of the box
/// around all control points. Every corner becomes a mesh vertex, so finer is not better.
inline constexpr double flattening = 2e-4;

/// Lines and curves end to end, as compact as they are written.
class CurvePath {
 public:
  explicit CurvePath(Vec2 start = {}) : points_{start} {}

  Vec2 start() const { return points_.front(); }
  Vec2 current() const { return points_.back(); }
  bool has_edges() const { return !kinds_.empty(); }
  /// Corners of the polyline but for its start, at least.
  std::size_t least_corners() const { return kinds_.size(); }

  void line_to(Vec2 end);
  void quadratic_to(Vec2 control, Vec2 end);
  void cubic_to(Vec2 first_control, Vec2 second_control, Vec2 end);
  /// Along centre + cos(t) (current - centre) + sin(t) axis for t = 0 .. sweep; `end` is where the
  /// arc ends, given because the caller often knows it exactly.
  void arc_to(Vec2 centre, Vec2 axis, double sweep, Vec2 end);

  void transform(const Affine& map);
  /// Grows the box by the path, or by control points around it.
  void extend(Box& box) const;
  /// Appends the polyline, `start` included, and the bow of each of its edges (see bow_of).
  /// Deterministic: only + - * / sqrt and sin_cos.
  void flatten(double tolerance, std::vector<Vec2>& polyline,
               std::vector<double>* bows = nullptr) const;

 private:
  enum class Kind : char { line, cubic, arc };
  static std::size_t point_count(Kind kind);

  std::vector<Kind> kinds_;
  std::vector<Vec2>
      points_;  // start; then per piece: end | two controls, end | centre, axis, (sweep, 0), end
};

/// How far to the left of the edge from a to b its curve passes; `middle` is on it midway.
double bow_of(Vec2 a, Vec2 b, Vec2 middle);

/// The tolerance for curves that fill this box.
double flattening_tolerance(const Box& box);

/// Sine and cosine of an angle in degrees; exact for multiples of 90.
struct Direction {
  double cos, sin;
};
Direction direction_of_degrees(double degrees);

}  // namespace lpq
