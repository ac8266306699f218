// See svg_shapes.h.
#include "io/domain/svg_shapes.h"

#include <algorithm>

#include "io/text_place.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

class ShapeReader {
 public:
  ShapeReader(std::string_view text, const XmlReader& xml, const StyleSheet& sheet,
              const LengthUnits& units)
      : text_(text), xml_(xml), sheet_(sheet), units_(units) {}

  Problem read(std::vector<Subpath>& subpaths);

 private:
  void fail(std::size_t byte, std::string message) {
    if (!error_) error_ = error_at(text_, byte, std::move(message));
  }
  bool accept(const XmlAttribute& attribute, const MaybeProblem& problem) {
    if (!problem) return true;
    if (!error_) error_ = attribute_error(text_, xml_, attribute, *problem);
    return false;
  }
  bool length(const char* name, double& value);
  void draw_rectangle(std::vector<Subpath>& subpaths);
  void draw_ellipse(std::vector<Subpath>& subpaths);
  void draw_points(std::vector<Subpath>& subpaths);
  void draw_line(std::vector<Subpath>& subpaths);
  void draw_path(std::vector<Subpath>& subpaths);

  std::string_view text_;
  const XmlReader& xml_;
  const StyleSheet& sheet_;
  const LengthUnits& units_;
  Problem error_;
};

/// False where it is absent or wrong.
bool ShapeReader::length(const char* name, double& value) {
  MaybeProblem problem;
  const auto found = find_svg_length(xml_, sheet_, units_, name, problem);
  if (problem && !error_) error_ = svg_length_error(text_, xml_, sheet_, name, *problem);
  if (found) value = *found;
  return found.has_value();
}

void ShapeReader::draw_path(std::vector<Subpath>& subpaths) {
  const XmlAttribute* data = xml_.find("d");
  if (data == nullptr || data->raw == "none") return;
  if (data->raw.find('&') == std::string_view::npos) {
    accept(*data, read_path_data(data->raw, subpaths));
  } else {
    accept(*data, read_path_data(xml_value(data->raw), subpaths));
  }
}

void ShapeReader::draw_rectangle(std::vector<Subpath>& subpaths) {
  double x = 0, y = 0, w = 0, h = 0, rx = 0, ry = 0;
  length("x", x);
  length("y", y);
  length("width", w);
  length("height", h);
  const bool has_rx = length("rx", rx), has_ry = length("ry", ry);
  if (error_) return;
  if (w < 0 || h < 0 || rx < 0 || ry < 0) return fail(xml_.byte(), "A <rect> has a negative size.");
  if (w == 0 || h == 0) return;  // drawn as nothing (SVG 1.1, 9.2)
  if (!has_rx) rx = ry;
  if (!has_ry) ry = rx;
  rx = std::min(rx, w / 2);
  ry = std::min(ry, h / 2);
  CurvePath path({x + rx, y});
  const auto side = [&path](Vec2 end) {
    if (!(path.current() == end)) path.line_to(end);
  };
  const auto corner = [&path, rx, ry](Vec2 end) {
    if (rx > 0 && ry > 0) append_elliptical_arc(path, {rx, ry}, 0, false, true, end);
  };
  side({x + w - rx, y});
  corner({x + w, y + ry});
  side({x + w, y + h - ry});
  corner({x + w - rx, y + h});
  side({x + rx, y + h});
  corner({x, y + h - ry});
  side({x, y + ry});
  corner({x + rx, y});
  subpaths.push_back({std::move(path), true});
}

void ShapeReader::draw_ellipse(std::vector<Subpath>& subpaths) {
  double x = 0, y = 0, rx = 0, ry = 0;
  length("cx", x);
  length("cy", y);
  if (xml_.name() == "circle") {
    length("r", rx);
    ry = rx;
  } else {
    const bool has_rx = length("rx", rx), has_ry = length("ry", ry);
    if (!has_rx) rx = ry;  // SVG 2: auto
    if (!has_ry) ry = rx;
  }
  if (error_) return;
  if (rx < 0 || ry < 0) return fail(xml_.byte(), "A circle or ellipse has a negative radius.");
  if (rx == 0 || ry == 0) return;
  CurvePath path({x + rx, y});
  path.arc_to({x, y}, {0, ry}, 2 * pi, path.start());
  subpaths.push_back({std::move(path), true});
}

void ShapeReader::draw_points(std::vector<Subpath>& subpaths) {
  std::vector<Vec2> points;
  const XmlAttribute* list = xml_.find("points");
  if (list == nullptr || !accept(*list, read_points(xml_value(list->raw), points))) return;
  if (points.size() < 2) return;
  CurvePath path(points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) path.line_to(points[i]);
  subpaths.push_back({std::move(path), xml_.name() == "polygon"});
}

void ShapeReader::draw_line(std::vector<Subpath>& subpaths) {
  Vec2 a, b;
  length("x1", a.x);
  length("y1", a.y);
  length("x2", b.x);
  length("y2", b.y);
  if (error_ || a == b) return;
  CurvePath path(a);
  path.line_to(b);
  subpaths.push_back({std::move(path), false});
}

Problem ShapeReader::read(std::vector<Subpath>& subpaths) {
  const std::string_view name = xml_.name();
  if (name == "path") {
    draw_path(subpaths);
  } else if (name == "rect") {
    draw_rectangle(subpaths);
  } else if (name == "circle" || name == "ellipse") {
    draw_ellipse(subpaths);
  } else if (name == "polygon" || name == "polyline") {
    draw_points(subpaths);
  } else if (name == "line") {
    draw_line(subpaths);
  }
  return error_;
}

}  // namespace

Error attribute_error(std::string_view text, const XmlReader& xml, const XmlAttribute& attribute,
                      const AttributeProblem& problem) {
  // Where entities are replaced, characters of the value and bytes of the text part ways.
  const bool plain = attribute.raw.find('&') == std::string_view::npos;
  return error_at(
      text, attribute.byte + (plain ? problem.at : 0),
      std::string(attribute.name) + " of <" + std::string(xml.name()) + ">: " + problem.message);
}

std::optional<double> find_svg_length(const XmlReader& xml, const StyleSheet& sheet,
                                      const LengthUnits& units, std::string_view name,
                                      MaybeProblem& problem) {
  const bool is_x = name == "width" || name[0] == 'x' || name.back() == 'x';
  const bool is_y = name == "height" || name[0] == 'y' || name.back() == 'y';
  const LengthAxis axis = is_x ? LengthAxis::x : is_y ? LengthAxis::y : LengthAxis::other;
  std::string said = styled_property(xml, sheet, name);
  const XmlAttribute* attribute = xml.find(name);
  if (said.empty() && attribute == nullptr) return std::nullopt;
  if (said.empty()) said = xml_value(attribute->raw);  // "" is wrong
  if (said == "auto") return std::nullopt;
  double value = 0;
  problem = read_length(said, value, units, axis);
  return problem ? std::nullopt : std::optional(value);
}

Error svg_length_error(std::string_view text, const XmlReader& xml, const StyleSheet& sheet,
                       std::string_view name, const AttributeProblem& problem) {
  if (styled_property(xml, sheet, name).empty())
    return attribute_error(text, xml, *xml.find(name), problem);
  return error_at(
      text, xml.byte(),
      std::string(name) + " in the style of <" + std::string(xml.name()) + ">: " + problem.message);
}

Problem read_svg_shape(std::string_view text, const XmlReader& xml, const StyleSheet& sheet,
                       const LengthUnits& units, std::vector<Subpath>& subpaths) {
  return ShapeReader(text, xml, sheet, units).read(subpaths);
}

}  // namespace lpq
