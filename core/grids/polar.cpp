// See polar.h.
#include "grids/polar.h"

#include "numerics/elementary.h"

namespace lpq {

Vec2 logarithm_about(Vec2 centre, Vec2 p) {
  const Vec2 d = p - centre;
  return {0.5 * logarithm(squared_length(d)), arc_tangent(d.y, d.x)};
}

Index sheets_between(Vec2 v, Vec2 w, Vec2 centre) {
  const Vec2 a = v - centre, b = w - centre;
  const double leap = arc_tangent(b.y, b.x) - arc_tangent(a.y, a.x);
  return leap < -pi ? 1 : leap > pi ? -1 : 0;
}

LineAbout line_about(Vec2 centre, const std::vector<Vec2>& points) {
  LineAbout line;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (points[k] == centre) return {};
    line.sheets.push_back(line.rounds);
    line.points.push_back(logarithm_about(centre, points[k]) + Vec2{0, 2 * pi * line.rounds});
    line.rounds += sheets_between(points[k], points[(k + 1) % points.size()], centre);
  }
  return line;
}

}  // namespace lpq
