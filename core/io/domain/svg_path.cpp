// See svg_path.h.
#include "io/domain/svg_path.h"

#include <cmath>

#include "io/domain/svg_scanner.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

bool is_command(char c) {
  return c != '\0' && std::string_view("MmZzLlHhVvCcSsQqTtAa").find(c) != std::string_view::npos;
}

class PathReader {
 public:
  PathReader(std::string_view text, std::vector<Subpath>& subpaths)
      : scan_(text), subpaths_(subpaths) {}

  MaybeProblem read() {
    if (scan_.at_end()) return {};  // an empty path draws nothing
    const char first = scan_.peek();
    if (first != 'M' && first != 'm') return problem("Path data should start with M.");
    while (!scan_.at_end()) {
      const char command = scan_.peek();
      if (!is_command(command)) return problem("A path command was expected.");
      scan_.take();
      if (!run(command)) return problem(std::string("Command ") + command + " is incomplete.");
    }
    finish(false);
    return {};
  }

 private:
  MaybeProblem problem(std::string message) const {
    return AttributeProblem{scan_.at(), std::move(message)};
  }

  void finish(bool closed) {
    if (path_.has_edges()) subpaths_.push_back({std::move(path_), closed});
    path_ = CurvePath(start_);
  }
  void begin(Vec2 start) {
    finish(false);
    path_ = CurvePath(start_ = start);
  }

  bool run(char command) {
    relative_ = command >= 'a';
    const char kind = relative_ ? static_cast<char>(command - 'a' + 'A') : command;
    if (kind == 'Z') {
      finish(true);
      mirror_ = Mirror::none;
      return true;
    }
    bool first = true;
    do {
      // Pairs after a move are lines.
      if (!piece(kind == 'M' && !first ? 'L' : kind)) return false;
      first = false;
    } while (scan_.starts_number());
    return true;
  }

  bool target(Vec2& p) {
    if (!scan_.point(p)) return false;
    if (relative_) p += path_.current();
    return true;
  }

  bool piece(char kind) {
    const Mirror before = mirror_;
    mirror_ = Mirror::none;
    Vec2 a, b, end;
    switch (kind) {
      case 'M':
        if (!target(end)) return false;
        begin(end);
        return true;
      case 'L':
        if (!target(end)) return false;
        path_.line_to(end);
        return true;
      case 'H':
      case 'V': return axis_line(kind == 'H');
      case 'C':
      case 'S':
        a = before == Mirror::cubic ? mirrored() : path_.current();
        if ((kind == 'C' && !target(a)) || !target(b) || !target(end)) return false;
        path_.cubic_to(a, b, end);
        control_ = b;
        mirror_ = Mirror::cubic;
        return true;
      case 'Q':
      case 'T':
        a = before == Mirror::quadratic ? mirrored() : path_.current();
        if ((kind == 'Q' && !target(a)) || !target(end)) return false;
        path_.quadratic_to(a, end);
        control_ = a;
        mirror_ = Mirror::quadratic;
        return true;
      default: return arc();
    }
  }

  bool axis_line(bool horizontal) {
    double value = 0;
    if (!scan_.number(value)) return false;
    Vec2 end = path_.current();
    double& moved = horizontal ? end.x : end.y;
    moved = relative_ ? moved + value : value;
    path_.line_to(end);
    return true;
  }

  bool arc() {
    Vec2 radii, end;
    double rotation = 0;
    bool large = false, sweep = false;
    if (!scan_.point(radii) || !scan_.number(rotation) || !scan_.flag(large) ||
        !scan_.flag(sweep) || !target(end))
      return false;
    append_elliptical_arc(path_, radii, rotation, large, sweep, end);
    return true;
  }

  Vec2 mirrored() const { return path_.current() + (path_.current() - control_); }

  enum class Mirror { none, cubic, quadratic };  // which kind of control point S and T continue
  SvgScanner scan_;
  std::vector<Subpath>& subpaths_;
  CurvePath path_;
  Vec2 start_, control_;
  bool relative_ = false;
  Mirror mirror_ = Mirror::none;
};

}  // namespace

MaybeProblem read_path_data(std::string_view text, std::vector<Subpath>& subpaths) {
  return PathReader(text, subpaths).read();
}

void append_elliptical_arc(CurvePath& path, Vec2 radii, double rotation_degrees, bool large,
                           bool sweep, Vec2 end) {
  const Vec2 start = path.current();
  if (start == end) return;
  const double rx = std::abs(radii.x), ry = std::abs(radii.y);
  if (rx == 0 || ry == 0) return path.line_to(end);
  const Direction t = direction_of_degrees(rotation_degrees);
  const Vec2 along{t.cos, t.sin}, across{-t.sin, t.cos}, half = 0.5 * (start - end);
  // The ellipse as a unit circle: the start is at (x, y) from the middle of the chord.
  double x = dot(half, along) / rx, y = dot(half, across) / ry, scale = 1;
  const double chord = x * x + y * y;
  double height = 0;  // of the centre above the chord, relative to half the chord
  if (chord > 1) {    // the radii are too small to reach: they grow
    scale = std::sqrt(chord);
    x /= scale;
    y /= scale;
  } else {
    height = std::sqrt((1 - chord) / chord) * (large == sweep ? -1 : 1);
  }
  const Vec2 major = scale * rx * along, minor = scale * ry * across;
  const Vec2 centre = midpoint(start, end) + (height * y) * major - (height * x) * minor;
  const Vec2 from{x - height * y, y + height * x}, to{-x - height * y, -y + height * x};
  double angle = arc_tangent(cross(from, to), dot(from, to));
  if (sweep && angle < 0) angle += 2 * pi;
  if (!sweep && angle > 0) angle -= 2 * pi;
  path.arc_to(centre, from.x * minor - from.y * major, angle, end);
}

}  // namespace lpq
