// See svg_path.h.
#include "io/domain/svg_path.h"

#include <array>
#include <cmath>

#include "io/number.h"
#include "io/plain_text.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

bool is_command(char c) {
  return c != '\0' && std::string_view("MmZzLlHhVvCcSsQqTtAa").find(c) != std::string_view::npos;
}

/// Numbers as SVG packs them: "1-2.5.5e3" is 1, -2.5, .5e3.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  bool at_end() { return peek() == '\0' && at_ >= text_.size(); }
  /// The next character that is not a separator, '\0' at the end.
  char peek() {
    while (at_ < text_.size() && is_separator(text_[at_])) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  char take() {
    const char c = peek();
    if (at_ < text_.size()) ++at_;
    return c;
  }
  bool starts_number() {
    const char c = peek();
    return is_digit(c) || c == '.' || c == '-' || c == '+';
  }
  bool number(double& value) {
    peek();
    const std::size_t start = at_;
    if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
    digits();
    if (at_ < text_.size() && text_[at_] == '.') {
      ++at_;
      digits();
    }
    exponent();
    if (parse_number(text_.substr(start, at_ - start), value)) return true;
    at_ = start;
    return false;
  }
  bool point(Vec2& p) { return number(p.x) && number(p.y); }
  /// Flags of arcs are one character and need no separator.
  bool flag(bool& value) {
    const char c = peek();
    if (c != '0' && c != '1') return false;
    ++at_;
    value = c == '1';
    return true;
  }
  std::string_view word() {
    peek();
    const std::size_t start = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }

 private:
  static bool is_separator(char c) {
    return c == ' ' || c == ',' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
  }
  void digits() {
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
  }
  void exponent() {
    if (at_ >= text_.size() || (text_[at_] != 'e' && text_[at_] != 'E')) return;
    std::size_t next = at_ + 1;
    if (next < text_.size() && (text_[next] == '-' || text_[next] == '+')) ++next;
    if (next >= text_.size() || !is_digit(text_[next])) return;  // "1em", "1e"
    at_ = next;
    digits();
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

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
  Scanner scan_;
  std::vector<Subpath>& subpaths_;
  CurvePath path_;
  Vec2 start_, control_;
  bool relative_ = false;
  Mirror mirror_ = Mirror::none;
};

/// The map of one transform function, or nothing if name and arguments do not fit.
std::optional<Affine> transform_function(std::string_view name, const std::array<double, 6>& v,
                                         std::size_t count) {
  if (name == "matrix" && count == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (count == 1 || count == 2))
    return Affine{1, 0, 0, 1, v[0], count == 2 ? v[1] : 0};
  if (name == "scale" && (count == 1 || count == 2))
    return Affine{v[0], 0, 0, count == 2 ? v[1] : v[0], 0, 0};
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

}  // namespace

MaybeProblem read_path_data(std::string_view text, std::vector<Subpath>& subpaths) {
  return PathReader(text, subpaths).read();
}

MaybeProblem read_transform(std::string_view text, Affine& map) {
  Scanner scan(text);
  while (!scan.at_end()) {
    const std::size_t start = scan.at();
    const std::string_view name = scan.word();
    std::array<double, 6> values{};
    std::size_t count = 0;
    bool good = scan.take() == '(';
    while (good && scan.starts_number())
      good = count < values.size() && scan.number(values[count++]);
    const auto function =
        good && scan.take() == ')' ? transform_function(name, values, count) : std::nullopt;
    if (!function) return AttributeProblem{start, "This is not a transform that can be read."};
    map = map * *function;
  }
  return {};
}

MaybeProblem read_points(std::string_view text, std::vector<Vec2>& points) {
  Scanner scan(text);
  while (!scan.at_end()) {
    Vec2 p;
    const std::size_t start = scan.at();
    if (!scan.point(p)) return AttributeProblem{start, "A point is two numbers."};
    points.push_back(p);
  }
  return {};
}

MaybeProblem read_length(std::string_view text, double& value) {
  struct Unit {
    std::string_view name;
    double pixels;
  };
  constexpr Unit units[] = {{"", 1},    {"px", 1},         {"mm", 96 / 25.4}, {"cm", 96 / 2.54},
                            {"in", 96}, {"pt", 96.0 / 72}, {"pc", 16}};
  Scanner scan(text);
  if (scan.number(value)) {
    const std::string_view name = scan.word();
    for (const Unit& unit : units) {
      if (name != unit.name || !scan.at_end()) continue;
      value *= unit.pixels;
      return {};
    }
  }
  return AttributeProblem{
      scan.at(), "A length is a number, alone or with px, mm, cm, in, pt, pc; no percentage."};
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
