// See svg_elements.h.
#include "io/domain/svg_elements.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "io/domain/svg_shapes.h"
#include "io/domain/svg_style.h"
#include "io/domain/svg_transform.h"
#include "io/domain/svg_view_box.h"
#include "io/plain_text.h"
#include "io/text_place.h"

namespace lpq {
namespace {

/// Which children are drawn: all, or of <switch> the first that applies.
enum class Choice : char { all, open, taken };

/// What an element hands down to those in it.
struct Inherited {
  Affine map{1, 0, 0, -1, 0, 0};
  bool drawn = true;
  bool visible = true;
  bool filled = true;  // SVG's initial fill is black
  FillRule rule = FillRule::nonzero;
  std::string name;  // of the <use> around, if that has one
  LengthUnits units;
  Choice choice = Choice::all;
};

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// What draws nothing by itself; <symbol> only for a <use>.
bool is_held_back(std::string_view name, bool is_target) {
  return is_one_of(name, {"defs", "clipPath", "mask", "pattern", "marker", "metadata",
                          "foreignObject", "style", "script"}) ||
         (name == "symbol" && !is_target);
}

/// Of "de, en-GB": whether the language of this text is among them.
bool speaks_english(std::string languages) {
  languages = lower_case(std::move(languages));
  for (std::size_t at = 0; at < languages.size();) {
    const std::size_t end = std::min(languages.find(',', at), languages.size());
    const std::string_view one = trimmed(std::string_view(languages).substr(at, end - at), " ");
    if (one == "en" || one.substr(0, 3) == "en-") return true;
    at = end + 1;
  }
  return false;
}

class SvgWalker {
 public:
  SvgWalker(std::string_view text, Drawing& drawing)
      : text_(text), xml_(text), sheet_(text), around_(1), drawing_(drawing) {
    for (std::size_t i = text.find('\n'); i != std::string_view::npos; i = text.find('\n', i + 1))
      line_ends_.push_back(i);
  }

  Result<SvgOutlines> read() {
    while (step()) {
    }
    if (error_) return *error_;
    found_.unread_rules = sheet_.unread();
    return std::move(found_);
  }

 private:
  /// An element that is drawn for a <use>.
  struct Copy {
    std::size_t target;  // byte of its tag
    std::optional<double> width, height;
  };

  void fail(Error error) {
    if (!error_) error_ = std::move(error);
  }
  void fail(std::string message, ErrorCode code = ErrorCode::parse_error) {
    fail(error_at(text_, xml_.byte(), std::move(message), code));
  }
  void accept(const XmlAttribute& attribute, const MaybeProblem& problem) {
    if (problem) fail(attribute_error(text_, xml_, attribute, *problem));
  }
  double length(const char* name, const LengthUnits& units) {
    MaybeProblem problem;
    const auto found = find_svg_length(xml_, sheet_, units, name, problem);
    if (problem) fail(svg_length_error(text_, xml_, sheet_, name, *problem));
    return found.value_or(0);
  }
  /// Width or height, where it is a length.
  std::optional<double> extent(const char* name, const LengthUnits& units) const {
    MaybeProblem unsaid;
    return find_svg_length(xml_, sheet_, units, name, unsaid);
  }
  std::int64_t line_of(std::size_t byte) const {
    return 1 + (std::lower_bound(line_ends_.begin(), line_ends_.end(), byte) - line_ends_.begin());
  }

  bool step();
  void open_element();
  bool is_chosen(Choice& choice) const;
  void read_properties(Inherited& own, bool is_target);
  void draw_shape(const Inherited& own);
  void draw_use(Inherited own);
  std::optional<std::size_t> target_of_use();
  void draw_copy(const Inherited& own);
  void enter_view(Inherited& own, bool is_target);

  std::string_view text_;
  XmlReader xml_;
  StyleSheet sheet_;
  std::vector<Inherited> around_;
  std::vector<Copy> copies_;  // outermost first
  bool at_target_ = false;    // the next tag is that of an element for a <use>
  std::optional<std::map<std::string, std::size_t>> targets_;  // id to byte, once it is asked for
  std::size_t copied_ = 0;
  std::vector<std::size_t> line_ends_;
  Drawing& drawing_;
  SvgOutlines found_;
  Problem error_;
};

/// One tag; false at the end of the text, and after an error.
bool SvgWalker::step() {
  const std::size_t before = xml_.position();
  const XmlReader::Event event = xml_.next();
  if (event == XmlReader::Event::error) fail(xml_.error());
  if (event == XmlReader::Event::open) open_element();
  if (event == XmlReader::Event::close) around_.pop_back();
  if (!copies_.empty() && !error_) {
    copied_ += xml_.position() - before;
    if (copied_ > std::max(most_copied_bytes, text_.size()))
      fail("The <use> elements of this drawing draw more than " +
               std::to_string(std::max(most_copied_bytes, text_.size()) / 1000000) +
               " MB, all copies together. Draw fewer copies.",
           ErrorCode::too_large);
  }
  return !error_ && event != XmlReader::Event::end;
}

void SvgWalker::open_element() {
  const bool is_target = std::exchange(at_target_, false);
  const std::string_view name = xml_.name();
  if (around_.size() == 1 && name != "svg")
    return fail("This is not SVG: the outermost element is <" + std::string(name.substr(0, 40)) +
                ">.");
  Inherited own = around_.back();
  own.choice = name == "switch" ? Choice::open : Choice::all;
  if (own.drawn) own.drawn = is_chosen(around_.back().choice);
  if (own.drawn) {
    own.drawn = svg_property(xml_, sheet_, "display") != "none" && !is_held_back(name, is_target);
    if (is_one_of(name, {"text", "image", "foreignObject"})) found_.left_out.add(name);
  }
  if (own.drawn) {
    read_properties(own, is_target);
    if (name == "use") {
      draw_use(own);
      own.drawn = false;
    } else if (!error_ && own.visible) {
      draw_shape(own);
    }
  }
  around_.push_back(std::move(own));
}

/// Whether the element is drawn by the choice around it [SVG 1.1, 5.8].
bool SvgWalker::is_chosen(Choice& choice) const {
  if (choice != Choice::open) return choice == Choice::all;
  if (is_held_back(xml_.name(), false) || is_one_of(xml_.name(), {"title", "desc"})) return false;
  if (xml_.find("requiredExtensions") != nullptr) return false;
  if (xml_.find("systemLanguage") != nullptr &&
      !speaks_english(svg_attribute(xml_, "systemLanguage")))
    return false;
  choice = Choice::taken;
  return true;
}

void SvgWalker::read_properties(Inherited& own, bool is_target) {
  const std::string fill = svg_property(xml_, sheet_, "fill");
  if (!fill.empty() && fill != "inherit") own.filled = fill != "none" && fill != "transparent";
  const std::string rule = svg_property(xml_, sheet_, "fill-rule");
  if (rule == "evenodd") own.rule = FillRule::even_odd;
  if (rule == "nonzero") own.rule = FillRule::nonzero;
  const std::string visibility = svg_property(xml_, sheet_, "visibility");
  if (!visibility.empty() && visibility != "inherit") own.visible = visibility == "visible";
  const std::string font_size = svg_property(xml_, sheet_, "font-size");
  const LengthUnits font{own.units.em, Vec2{own.units.em, own.units.em}};
  if (!font_size.empty()) read_length(font_size, own.units.em, font);  // words change nothing
  for (const char* hides : {"clip-path", "mask"}) {
    const std::string value = svg_property(xml_, sheet_, hides);
    if (!value.empty() && value != "none") found_.not_applied.add(hides);
  }
  if (auto problem =
          apply_svg_transform(text_, xml_, sheet_, own.units, own.map, found_.not_applied))
    fail(*std::move(problem));
  if (xml_.name() == "svg" || xml_.name() == "symbol") enter_view(own, is_target);
}

void SvgWalker::draw_shape(const Inherited& own) {
  if (xml_.name() == "path" && !styled_property(xml_, sheet_, "d").empty())
    found_.not_applied.add("d of a style");
  std::vector<Subpath> subpaths;
  if (auto error = read_svg_shape(text_, xml_, sheet_, own.units, subpaths))
    return fail(*std::move(error));
  if (subpaths.empty()) return;
  const XmlAttribute* data = xml_.find("d");
  const std::size_t byte = data != nullptr ? data->byte : xml_.byte();
  const XmlAttribute* id = own.name.empty() ? xml_.find("id") : nullptr;
  const Index source = drawing_.add_source(id == nullptr ? own.name : xml_value(id->raw),
                                           line_of(byte), static_cast<std::int64_t>(byte));
  const FillRule fill = own.filled && xml_.name() != "line" ? own.rule : FillRule::unfilled;
  for (Subpath& path : subpaths) {
    path.curve.transform(own.map);
    found_.outlines.push_back({std::move(path), fill, source});
  }
}

/// The byte of the element that a <use> names; where there is none, a word about it.
std::optional<std::size_t> SvgWalker::target_of_use() {
  const XmlAttribute* href = xml_.find_prefixed("href");
  const std::string value = href == nullptr ? "" : xml_value(href->raw);
  const std::string_view link = trimmed(value, " ");
  if (!targets_) {
    targets_.emplace();
    XmlReader all(text_);  // what is wrong in the text is said where it is read
    for (auto event = all.next();
         event == XmlReader::Event::open || event == XmlReader::Event::close; event = all.next()) {
      const XmlAttribute* id = event == XmlReader::Event::open ? all.find("id") : nullptr;
      if (id != nullptr) targets_->try_emplace(xml_value(id->raw), all.byte());
    }
  }
  const bool is_elsewhere = !link.empty() && link[0] != '#';
  const auto found = targets_->find(std::string(link.substr(link.empty() ? 0 : 1)));
  if (!link.empty() && !is_elsewhere && found != targets_->end()) return found->second;
  found_.left_out.add(is_elsewhere ? "use of another file" : "use without its element");
  return std::nullopt;
}

void SvgWalker::draw_use(Inherited own) {
  const std::optional<std::size_t> target = target_of_use();
  if (!target) return;
  for (const Copy& around : copies_)
    if (around.target == *target) return fail("This <use> is part of what it draws.");
  if (copies_.size() == deepest_use)
    return fail("<use> is nested more than " + std::to_string(deepest_use) + " deep.",
                ErrorCode::too_large);
  own.map = own.map * Affine{1, 0, 0, 1, length("x", own.units), length("y", own.units)};
  if (own.name.empty()) own.name = svg_attribute(xml_, "id");
  if (error_) return;
  copies_.push_back({*target, extent("width", own.units), extent("height", own.units)});
  draw_copy(own);
  copies_.pop_back();
}

/// Reads the element of the innermost copy where `own` says.
void SvgWalker::draw_copy(const Inherited& own) {
  XmlReader outside = std::exchange(xml_, xml_.at(copies_.back().target));
  around_.push_back(own);
  at_target_ = true;
  const std::size_t depth = around_.size();
  while (step() && around_.size() > depth) {
  }
  around_.pop_back();
  xml_ = std::move(outside);
}

/// <svg> in <svg> and the <symbol> of a <use> fill the width and height of their <use>, or their
/// own, or all of the view around them [SVG 1.1, 5.1.2 and 7.9]. Where that is not known,
/// coordinates stay as they are, as those of the page do.
void SvgWalker::enter_view(Inherited& own, bool is_target) {
  const bool is_page = around_.size() == 1;
  const auto size_of = [&](const char* name, std::optional<double> Copy::*of_use,
                           double Vec2::*part) {
    std::optional<double> size = is_target ? copies_.back().*of_use : std::nullopt;
    if (!size) size = extent(name, own.units);
    if (!size && own.units.view) size = *own.units.view.*part;
    return size;
  };
  const auto width = size_of("width", &Copy::width, &Vec2::x);
  const auto height = size_of("height", &Copy::height, &Vec2::y);
  if (xml_.name() == "svg" && !is_page)
    own.map = own.map * Affine{1, 0, 0, 1, length("x", own.units), length("y", own.units)};
  own.units.view.reset();
  if (width && height) own.units.view = Vec2{*width, *height};
  if (!is_page && (width == 0 || height == 0)) own.drawn = false;  // nothing is [SVG 1.1, 5.1.2]
  const XmlAttribute* attribute = xml_.find("viewBox");
  if (attribute == nullptr || !own.drawn) return;
  const std::string view_box = xml_value(attribute->raw);
  if (!is_page && own.units.view)
    accept(*attribute, fit_view_box(view_box, svg_attribute(xml_, "preserveAspectRatio"),
                                    *own.units.view, own.map));
  Vec2 corner, size;
  if (!read_view_box(view_box, corner, size)) own.units.view = size;
}

}  // namespace

Result<SvgOutlines> read_svg_outlines(std::string_view text, Drawing& drawing) {
  return SvgWalker(text, drawing).read();
}

}  // namespace lpq
