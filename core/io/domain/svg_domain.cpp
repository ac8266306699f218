// See svg_domain.h.
#include "io/domain/svg_domain.h"

#include <algorithm>

#include "io/domain/drawing.h"
#include "io/domain/svg_path.h"
#include "io/domain/xml_reader.h"
#include "io/text_place.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

/// What an element hands down to those in it.
struct Inherited {
  Affine map;
  bool drawn = true;
  bool filled = true;  // SVG's initial fill is black
};

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\f";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The value of a property in "fill: none; stroke: #000"; the last one counts.
std::string_view style_value(std::string_view style, std::string_view property) {
  std::string_view value;
  while (!style.empty()) {
    const std::string_view one = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(one.size() + 1, style.size()));
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos || trimmed(one.substr(0, colon)) != property) continue;
    value = trimmed(one.substr(colon + 1));
    const std::size_t important = value.find('!');
    if (important != std::string_view::npos) value = trimmed(value.substr(0, important));
  }
  return value;
}

struct Outline {
  Subpath path;
  bool filled = true;
  Index source = none;
};

class SvgReader {
 public:
  explicit SvgReader(std::string_view text) : text_(text), xml_(text) {
    around_.push_back({{1, 0, 0, -1, 0, 0}, true, true});
  }

  Result<DomainFile> read() {
    while (!failed_) {
      const XmlReader::Event event = xml_.next();
      if (event == XmlReader::Event::error) return xml_.error();
      if (event == XmlReader::Event::end) break;
      if (event == XmlReader::Event::open) {
        open_element();
      } else {
        around_.pop_back();
      }
    }
    if (failed_) return error_;
    flatten();
    return finish();
  }

 private:
  void fail(std::size_t byte, std::string message) {
    if (!failed_) error_ = error_at(text_, byte, std::move(message));
    failed_ = true;
  }
  bool accept(const XmlAttribute& attribute, const MaybeProblem& problem) {
    if (!problem) return true;
    // Where entities are replaced, characters of the value and bytes of the text part ways.
    const bool plain = attribute.raw.find('&') == std::string_view::npos;
    fail(attribute.byte + (plain ? problem->at : 0), std::string(attribute.name) + " of <" +
                                                         std::string(xml_.name()) +
                                                         ">: " + problem->message);
    return false;
  }

  /// Lines are counted once, from shape to shape.
  std::int64_t line_of(std::size_t byte) {
    const auto at = [&](std::size_t i) { return text_.begin() + static_cast<std::ptrdiff_t>(i); };
    line_ += std::count(at(counted_), at(byte), '\n');
    counted_ = byte;
    return line_;
  }

  std::string property(std::string_view name) const {
    if (const XmlAttribute* style = xml_.find("style")) {
      const std::string text = xml_value(style->raw);
      const std::string_view value = style_value(text, name);
      if (!value.empty()) return std::string(value);
    }
    const XmlAttribute* attribute = xml_.find(name);
    return attribute == nullptr ? "" : std::string(trimmed(xml_value(attribute->raw)));
  }

  void open_element();
  void draw_shape(const Inherited& own);
  bool length(const char* name, double& value);
  void draw_rectangle(std::vector<Subpath>& subpaths);
  void draw_ellipse(std::vector<Subpath>& subpaths);
  void draw_points(std::vector<Subpath>& subpaths);
  void draw_line(std::vector<Subpath>& subpaths);
  void draw_path(std::vector<Subpath>& subpaths);
  void flatten();
  Result<DomainFile> finish();

  std::string_view text_;
  XmlReader xml_;
  std::vector<Inherited> around_;
  std::vector<Outline> outlines_;
  Drawing drawing_;
  Counter left_out_;
  Index closed_by_fill_ = 0;
  std::size_t counted_ = 0;  // bytes whose lines are counted
  std::int64_t line_ = 1;
  DomainFile file_;
  bool failed_ = false;
  Error error_;
};

void SvgReader::open_element() {
  if (around_.size() == 1 && xml_.name() != "svg")
    return fail(xml_.byte(), "This is not SVG: the outermost element is <" +
                                 std::string(xml_.name().substr(0, 40)) + ">.");
  Inherited own = around_.back();
  if (own.drawn) {
    own.drawn = property("display") != "none" &&
                !is_one_of(xml_.name(), {"defs", "symbol", "clipPath", "mask", "pattern", "marker",
                                         "metadata", "foreignObject", "style", "script"});
    if (is_one_of(xml_.name(), {"use", "text", "image", "foreignObject"}))
      left_out_.add(xml_.name());
  }
  if (own.drawn) {
    const std::string fill = property("fill");
    if (!fill.empty() && fill != "inherit") own.filled = fill != "none" && fill != "transparent";
    if (const XmlAttribute* transform = xml_.find("transform"))
      accept(*transform, read_transform(xml_value(transform->raw), own.map));
    if (!failed_) draw_shape(own);
  }
  around_.push_back(own);
}

void SvgReader::draw_shape(const Inherited& own) {
  const std::string_view name = xml_.name();
  std::vector<Subpath> subpaths;
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
  if (failed_ || subpaths.empty()) return;
  const XmlAttribute* id = xml_.find("id");
  const XmlAttribute* data = xml_.find("d");
  const std::size_t byte = data != nullptr ? data->byte : xml_.byte();
  const Index source = drawing_.add_source(id == nullptr ? std::string() : xml_value(id->raw),
                                           line_of(byte), static_cast<std::int64_t>(byte));
  for (Subpath& path : subpaths) {
    path.curve.transform(own.map);
    outlines_.push_back({std::move(path), own.filled && name != "line", source});
  }
}

/// False where the attribute is absent or wrong.
bool SvgReader::length(const char* name, double& value) {
  const XmlAttribute* attribute = xml_.find(name);
  return attribute != nullptr && accept(*attribute, read_length(xml_value(attribute->raw), value));
}

void SvgReader::draw_path(std::vector<Subpath>& subpaths) {
  const XmlAttribute* data = xml_.find("d");
  if (data == nullptr) return;
  if (data->raw.find('&') == std::string_view::npos) {
    accept(*data, read_path_data(data->raw, subpaths));
  } else {
    accept(*data, read_path_data(xml_value(data->raw), subpaths));
  }
}

void SvgReader::draw_rectangle(std::vector<Subpath>& subpaths) {
  double x = 0, y = 0, w = 0, h = 0, rx = 0, ry = 0;
  length("x", x);
  length("y", y);
  length("width", w);
  length("height", h);
  const bool has_rx = length("rx", rx), has_ry = length("ry", ry);
  if (failed_) return;
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

void SvgReader::draw_ellipse(std::vector<Subpath>& subpaths) {
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
  if (failed_) return;
  if (rx < 0 || ry < 0) return fail(xml_.byte(), "A circle or ellipse has a negative radius.");
  if (rx == 0 || ry == 0) return;
  CurvePath path({x + rx, y});
  path.arc_to({x, y}, {0, ry}, 2 * pi, path.start());
  subpaths.push_back({std::move(path), true});
}

void SvgReader::draw_points(std::vector<Subpath>& subpaths) {
  std::vector<Vec2> points;
  const XmlAttribute* list = xml_.find("points");
  if (list == nullptr || !accept(*list, read_points(xml_value(list->raw), points))) return;
  if (points.size() < 2) return;
  CurvePath path(points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) path.line_to(points[i]);
  subpaths.push_back({std::move(path), xml_.name() == "polygon"});
}

void SvgReader::draw_line(std::vector<Subpath>& subpaths) {
  Vec2 a, b;
  length("x1", a.x);
  length("y1", a.y);
  length("x2", b.x);
  length("y2", b.y);
  if (failed_ || a == b) return;
  CurvePath path(a);
  path.line_to(b);
  subpaths.push_back({std::move(path), false});
}

void SvgReader::flatten() {
  Box box = empty_box();
  for (const Outline& outline : outlines_) outline.path.curve.extend(box);
  const double tolerance = flattening_tolerance(box);
  std::vector<Vec2> points;
  for (Outline& outline : outlines_) {
    if (is_too_many(drawing_.lines, text_.size())) return;  // join_drawing says so
    points.clear();
    outline.path.curve.flatten(tolerance, points);
    bool closed = outline.path.closed;
    if (!closed && outline.filled && points.size() > 2) {
      closed = true;  // as filling does (SVG 1.1, 11.3)
      if (!(points.front() == points.back())) ++closed_by_fill_;
    }
    drawing_.lines.add(points, closed, outline.source);
    outline.path.curve = CurvePath();
  }
}

Result<DomainFile> SvgReader::finish() {
  if (closed_by_fill_ > 0)
    file_.warnings.push_back(
        {ErrorCode::parse_error,
         "Open paths were closed, as their fill is: " + std::to_string(closed_by_fill_) + ".",
         {}});
  if (left_out_.any())
    file_.warnings.push_back({ErrorCode::parse_error, "Left out: " + left_out_.text() + ".", {}});
  const double tolerance = join_tolerance * drawing_size(drawing_.lines);
  const auto joined = join_drawing(drawing_, text_.size(), tolerance, file_.warnings);
  if (!joined) return joined.error();
  const NestedFaces nested = nest_faces(drawing_.lines);
  if (nested.planar.faces.empty()) {
    if (!nested.planar.chains.empty()) return open_chain_error(drawing_, nested, tolerance);
    return Error{ErrorCode::empty, "The drawing has no closed outline.", {}};
  }
  const auto name = [&](Index f) { return common_name(drawing_, nested.planar.faces[f]); };
  const Index outside = add_regions(drawing_, nested, even_faces(nested), name, file_.domain);
  if (outside > 0)
    file_.warnings.push_back(
        {ErrorCode::parse_error,
         "Open lines outside all regions were left out: " + std::to_string(outside) + ".",
         {}});
  return std::move(file_);
}

}  // namespace

Result<DomainFile> read_svg_domain(std::string_view text) { return SvgReader(text).read(); }

}  // namespace lpq
