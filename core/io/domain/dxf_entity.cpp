// See dxf_entity.h. Angles of arcs are in degrees, parameters of ellipses in radians. A bulge is
// the tangent of a quarter of the arc's angle, positive to the left turn.
#include "io/domain/dxf_entity.h"

#include <cmath>

#include "numerics/elementary.h"

namespace lpq {
namespace {

constexpr double full_turn = 1e-9;  // an arc this near to 2 pi is closed

class EntityReader : public DxfFields {
 public:
  using DxfFields::DxfFields;

  Result<std::optional<DxfCurve>> read(const std::vector<DxfEntity>& vertices);

 private:
  struct Corner {
    Vec2 point;
    double bulge = 0;
  };

  void read_line();
  void read_arc();
  void read_ellipse();
  std::vector<Corner> light_corners();
  std::vector<Corner> heavy_corners(const std::vector<DxfEntity>& vertices);
  bool read_corners(const std::vector<Corner>& corners);
  bool read_spline();
  bool interpolate(std::vector<Vec2> points);

  DxfCurve curve_;
};

void EntityReader::read_line() {
  curve_.path = CurvePath(point(10));
  curve_.path.line_to(point(11));
}

void EntityReader::read_arc() {
  Vec2 centre = point(10);
  const double radius = number(40);
  const bool whole = entity().type == "CIRCLE";
  const double from = whole ? 0 : number(50), to = whole ? 360 : number(51);
  const double mirror = is_mirrored() ? -1 : 1;
  if (!(radius > 0)) return fail("has a radius that is not positive");
  const double largest_angle = 1e5;
  if (!(std::abs(from) < largest_angle && std::abs(to) < largest_angle))
    return fail("has an angle that is out of range");
  double degrees = to - from;
  degrees -= 360 * std::floor(degrees / 360);
  if (degrees == 0) degrees = 360;
  centre.x *= mirror;
  const auto at = [&](double angle) {
    const Direction t = direction_of_degrees(angle);
    return centre + Vec2{mirror * radius * t.cos, radius * t.sin};
  };
  const Direction t = direction_of_degrees(from);
  curve_.closed = degrees == 360;
  curve_.path = CurvePath(at(from));
  curve_.path.arc_to(centre, {-mirror * radius * t.sin, radius * t.cos}, degrees * (pi / 180),
                     curve_.closed ? at(from) : at(to));
}

void EntityReader::read_ellipse() {
  const Vec2 centre = point(10), major = point(11);
  const double ratio = number(40), from = optional_number(41, 0), to = optional_number(42, 2 * pi);
  const Vec2 minor = (is_mirrored() ? -ratio : ratio) * perpendicular(major);
  if (!(ratio > 0) || major == Vec2{}) return fail("has an axis without length");
  const double largest_angle = 1e4;
  if (!(std::abs(from) < largest_angle && std::abs(to) < largest_angle))
    return fail("has a parameter that is out of range");
  double sweep = to - from;
  sweep -= 2 * pi * std::floor(sweep / (2 * pi));
  if (sweep <= full_turn) sweep = 2 * pi;
  const auto at = [&](double t) {
    const SinCos s = sin_cos(t);
    return centre + s.cos * major + s.sin * minor;
  };
  curve_.closed = std::abs(sweep - 2 * pi) <= full_turn;
  const SinCos s = sin_cos(from);
  curve_.path = CurvePath(at(from));
  curve_.path.arc_to(centre, s.cos * minor - s.sin * major, curve_.closed ? 2 * pi : sweep,
                     curve_.closed ? at(from) : at(to));
}

std::vector<EntityReader::Corner> EntityReader::light_corners() {
  std::vector<Corner> corners;
  for (const DxfGroup& group : entity().groups) {
    if (group.code == 10) corners.push_back({{number(group), 0}, 0});
    if (corners.empty()) continue;
    if (group.code == 20) corners.back().point.y = number(group);
    if (group.code == 42) corners.back().bulge = number(group);
  }
  return corners;
}

std::vector<EntityReader::Corner> EntityReader::heavy_corners(
    const std::vector<DxfEntity>& vertices) {
  constexpr unsigned frame_point = 16;  // of a spline's control polygon: not on the curve
  std::vector<Corner> corners;
  for (const DxfEntity& vertex : vertices) {
    DxfFields fields(vertex);
    const Corner corner{fields.point(10), fields.optional_number(42, 0)};
    if ((fields.flags() & frame_point) == 0) corners.push_back(corner);
    if (fields.failed()) fail(fields.error());
  }
  return corners;
}

bool EntityReader::read_corners(const std::vector<Corner>& corners) {
  curve_.closed = (flags() & 1) != 0;
  const double mirror = is_mirrored() ? -1 : 1;
  const auto at = [&](std::size_t i) {
    const Vec2 p = corners[i % corners.size()].point;
    return Vec2{mirror * p.x, p.y};
  };
  if (corners.size() < 2) return false;
  curve_.path = CurvePath(at(0));
  for (std::size_t i = 0; i + (curve_.closed ? 0 : 1) < corners.size(); ++i) {
    const Vec2 p = at(i), q = at(i + 1);
    const double bulge = mirror * corners[i].bulge;
    if (p == q) continue;
    if (bulge == 0) {
      curve_.path.line_to(q);
      continue;
    }
    const Vec2 centre = midpoint(p, q) + ((1 - bulge * bulge) / (4 * bulge)) * perpendicular(q - p);
    curve_.path.arc_to(centre, perpendicular(p - centre), 4 * arc_tangent(bulge, 1), q);
  }
  return curve_.path.has_edges();
}

bool EntityReader::read_spline() {
  auto spline = std::make_unique<BSpline>();
  std::vector<Vec2> fit;
  const double degree = optional_number(71, 3);
  spline->degree = degree >= 1 && degree <= largest_degree ? static_cast<int>(degree) : 0;
  for (const DxfGroup& group : entity().groups) {
    switch (group.code) {
      case 40: spline->knots.push_back(number(group)); break;
      case 41: spline->weights.push_back(number(group)); break;
      case 10: spline->control.push_back({number(group), 0}); break;
      case 20:
        if (!spline->control.empty()) spline->control.back().y = number(group);
        break;
      case 11: fit.push_back({number(group), 0}); break;
      case 21:
        if (!fit.empty()) fit.back().y = number(group);
        break;
      default: break;
    }
  }
  if (failed()) return false;
  if (spline->control.empty() && fit.size() > 1) return interpolate(std::move(fit));
  if (const char* problem = spline_problem(*spline)) {
    fail(problem);
    return false;
  }
  // "Closed" says that the ends meet, which their places say as well.
  curve_.spline = std::move(spline);
  return true;
}

bool EntityReader::interpolate(std::vector<Vec2> points) {
  curve_.interpolated = true;
  if ((flags() & 1) != 0) points.push_back(points.front());
  std::vector<Vec2> distinct;
  for (const Vec2 p : points)
    if (distinct.empty() || !(distinct.back() == p)) distinct.push_back(p);
  if (distinct.size() < 2) return false;
  std::vector<double> lengths;
  for (std::size_t i = 1; i < distinct.size(); ++i)
    lengths.push_back(distance(distinct[i - 1], distinct[i]));
  const std::vector<Vec2> tangents = natural_spline_tangents(distinct, lengths);
  curve_.path = CurvePath(distinct[0]);
  for (std::size_t i = 1; i < distinct.size(); ++i) {
    const double third = lengths[i - 1] / 3;
    curve_.path.cubic_to(distinct[i - 1] + third * tangents[i - 1],
                         distinct[i] - third * tangents[i], distinct[i]);
  }
  return true;
}

Result<std::optional<DxfCurve>> EntityReader::read(const std::vector<DxfEntity>& vertices) {
  constexpr unsigned surface_flags = 16 | 64;  // a polygon or polyface mesh
  bool draws = true;
  if (entity().type == "LINE") {
    read_line();
  } else if (entity().type == "ARC" || entity().type == "CIRCLE") {
    read_arc();
  } else if (entity().type == "ELLIPSE") {
    read_ellipse();
  } else if (entity().type == "SPLINE") {
    draws = read_spline();
  } else if (entity().type == "LWPOLYLINE") {
    draws = read_corners(light_corners());
  } else {
    draws = (flags() & surface_flags) == 0 && read_corners(heavy_corners(vertices));
  }
  for (const DxfGroup& group : entity().groups)
    if (group.code == 30 || group.code == 31 || group.code == 38)
      curve_.has_height = curve_.has_height || number(group) != 0;
  if (failed()) return error();
  if (!draws) return std::optional<DxfCurve>();
  return std::optional<DxfCurve>(std::move(curve_));
}

}  // namespace

bool is_dxf_curve(std::string_view type) {
  for (const std::string_view known :
       {"LINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "LWPOLYLINE", "POLYLINE"})
    if (type == known) return true;
  return false;
}

Result<std::optional<DxfCurve>> make_dxf_curve(const DxfEntity& entity,
                                               const std::vector<DxfEntity>& vertices) {
  return EntityReader(entity).read(vertices);
}

}  // namespace lpq
