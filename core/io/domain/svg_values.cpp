// See svg_values.h.
#include "io/domain/svg_values.h"

#include <array>
#include <cmath>
#include <span>

#include "io/domain/svg_scanner.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

struct Unit {
  std::string_view name;
  double size;
};

// In pixels and in degrees.
constexpr Unit length_units[] = {{"", 1},           {"px", 1},         {"mm", 96 / 25.4},
                                 {"cm", 96 / 2.54}, {"Q", 96 / 101.6}, {"in", 96},
                                 {"pt", 96.0 / 72}, {"pc", 16}};
constexpr Unit angle_units[] = {
    {"", 1}, {"deg", 1}, {"grad", 0.9}, {"rad", 180 / pi}, {"turn", 360}};
constexpr Unit no_units[] = {{"", 1}};

std::optional<double> unit_size(std::span<const Unit> units, std::string_view name) {
  for (const Unit& unit : units)
    if (same_letters(name, unit.name)) return unit.size;
  return std::nullopt;
}

std::span<const Unit> units_of(std::string_view function) {
  if (function.substr(0, 9) == "translate") return length_units;
  if (function == "rotate" || function.substr(0, 4) == "skew") return angle_units;
  return no_units;
}

/// The map of one transform function, or nothing if name and arguments do not fit.
std::optional<Affine> transform_function(std::string_view name, const std::array<double, 6>& v,
                                         std::size_t count) {
  if (name == "matrix" && count == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (count == 1 || count == 2))
    return Affine{1, 0, 0, 1, v[0], count == 2 ? v[1] : 0};
  if ((name == "translateX" || name == "translateY") && count == 1)
    return Affine{1, 0, 0, 1, name == "translateX" ? v[0] : 0, name == "translateX" ? 0 : v[0]};
  if (name == "scale" && (count == 1 || count == 2))
    return Affine{v[0], 0, 0, count == 2 ? v[1] : v[0], 0, 0};
  if ((name == "scaleX" || name == "scaleY") && count == 1)
    return Affine{name == "scaleX" ? v[0] : 1, 0, 0, name == "scaleX" ? 1 : v[0], 0, 0};
  if (name == "rotate" && (count == 1 || count == 3)) {
    const Direction t = direction_of_degrees(v[0]);
    const Affine turn{t.cos, t.sin, -t.sin, t.cos, 0, 0};
    if (count == 1) return turn;
    return Affine{1, 0, 0, 1, v[1], v[2]} * turn * Affine{1, 0, 0, 1, -v[1], -v[2]};
  }
  if ((name == "skewX" || name == "skewY") && count == 1) {
    const Direction t = direction_of_degrees(v[0]);
    if (t.cos == 0) return std::nullopt;
    const double tangent = t.sin / t.cos;
    return name == "skewX" ? Affine{1, 0, tangent, 1, 0, 0} : Affine{1, tangent, 0, 1, 0, 0};
  }
  return std::nullopt;
}

/// "name(arguments)"; nothing if it is none that can be read.
std::optional<Affine> read_function(SvgScanner& scan) {
  const std::string_view name = scan.word();
  std::array<double, 6> values{};
  std::size_t count = 0;
  if (scan.take() != '(') return std::nullopt;
  while (scan.starts_number()) {
    if (count == values.size() || !scan.number(values[count])) return std::nullopt;
    const auto size = unit_size(units_of(name), scan.word());
    if (!size) return std::nullopt;
    values[count++] *= *size;
  }
  if (scan.take() != ')') return std::nullopt;
  return transform_function(name, values, count);
}

double part_of(Vec2 view, LengthAxis axis) {
  if (axis == LengthAxis::other) return std::sqrt(squared_length(view) / 2);
  return axis == LengthAxis::x ? view.x : view.y;
}

}  // namespace

MaybeProblem read_transform(std::string_view text, Affine& map) {
  SvgScanner scan(text);
  if (trimmed(text, " \t\r\n") == "none") return {};
  while (!scan.at_end()) {
    const std::size_t start = scan.at();
    const auto function = read_function(scan);
    if (!function) return AttributeProblem{start, "This is not a transform that can be read."};
    map = map * *function;
  }
  return {};
}

MaybeProblem read_points(std::string_view text, std::vector<Vec2>& points) {
  SvgScanner scan(text);
  while (!scan.at_end()) {
    Vec2 p;
    const std::size_t start = scan.at();
    if (!scan.point(p)) return AttributeProblem{start, "A point is two numbers."};
    points.push_back(p);
  }
  return {};
}

MaybeProblem read_length(std::string_view text, double& value, const LengthUnits& units,
                         LengthAxis axis) {
  SvgScanner scan(text);
  double number = 0;
  if (scan.number(number)) {
    const bool is_share = scan.peek() == '%' && scan.take() == '%';
    if (is_share && !units.view)
      return AttributeProblem{
          scan.at(), "A percentage needs a viewBox, or a width and a height, of the <svg> around."};
    const std::string_view name = scan.word();
    std::optional<double> size = unit_size(length_units, name);
    if (same_letters(name, "em")) size = units.em;
    if (is_share) size = part_of(*units.view, axis);
    if (size && scan.at_end() && !(is_share && !name.empty())) {
      value = is_share ? number * *size / 100 : number * *size;
      return {};
    }
  }
  return AttributeProblem{
      scan.at(), "A length is a number, alone or with px, mm, cm, Q, in, pt, pc, em or %."};
}

}  // namespace lpq
