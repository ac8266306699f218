// See svg_elements.h.
#include "io/domain/svg_elements.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "io/domain/svg_shapes.h"
#include "io/domain/svg_style.h"
#include "io/domain/svg_view_box.h"
#include "io/text_place.h"

namespace lpq {
namespace {

/// What an element hands down to those in it.
struct Inherited {
  Affine map{1, 0, 0, -1, 0, 0};
  bool drawn = true;
  bool visible = true;
  bool filled = true;  // SVG's initial fill is black
  FillRule rule = FillRule::nonzero;
  std::string name;  // of the <use> around, if that has one
};

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), name) != list.end();
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
    std::optional<Vec2> size;
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
  double length(const char* name) {
    double value = 0;
    if (const XmlAttribute* attribute = xml_.find(name))
      accept(*attribute, read_length(xml_value(attribute->raw), value));
    return value;
  }
  std::int64_t line_of(std::size_t byte) const {
    return 1 + (std::lower_bound(line_ends_.begin(), line_ends_.end(), byte) - line_ends_.begin());
  }

  bool step();
  void open_element();
  void read_properties(Inherited& own, bool is_target);
  void draw_shape(const Inherited& own);
  void draw_use(Inherited own);
  std::optional<std::size_t> target_of_use();
  std::optional<Vec2> size_of_use() const;
  void draw_copy(const Inherited& own);
  void fit_symbol(Inherited& own);

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
  if (own.drawn) {
    const bool held_back = is_one_of(name, {"defs", "clipPath", "mask", "pattern", "marker",
                                            "metadata", "foreignObject", "style", "script"}) ||
                           (name == "symbol" && !is_target);
    own.drawn = svg_property(xml_, sheet_, "display") != "none" && !held_back;
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

void SvgWalker::read_properties(Inherited& own, bool is_target) {
  const std::string fill = svg_property(xml_, sheet_, "fill");
  if (!fill.empty() && fill != "inherit") own.filled = fill != "none" && fill != "transparent";
  const std::string rule = svg_property(xml_, sheet_, "fill-rule");
  if (rule == "evenodd") own.rule = FillRule::even_odd;
  if (rule == "nonzero") own.rule = FillRule::nonzero;
  const std::string visibility = svg_property(xml_, sheet_, "visibility");
  if (!visibility.empty() && visibility != "inherit") own.visible = visibility == "visible";
  if (const XmlAttribute* transform = xml_.find("transform"))
    accept(*transform, read_transform(xml_value(transform->raw), own.map));
  if (is_target && is_one_of(xml_.name(), {"symbol", "svg"})) fit_symbol(own);
}

void SvgWalker::draw_shape(const Inherited& own) {
  std::vector<Subpath> subpaths;
  if (auto error = read_svg_shape(text_, xml_, subpaths)) return fail(*std::move(error));
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
  std::string link = svg_attribute(xml_, "href");
  if (link.empty()) link = svg_attribute(xml_, "xlink:href");
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
  const auto found = targets_->find(link.substr(link.empty() ? 0 : 1));
  if (!link.empty() && !is_elsewhere && found != targets_->end()) return found->second;
  found_.left_out.add(is_elsewhere ? "use of another file" : "use without its element");
  return std::nullopt;
}

/// Width and height, where both are lengths.
std::optional<Vec2> SvgWalker::size_of_use() const {
  Vec2 size;
  const std::string width = svg_attribute(xml_, "width"), height = svg_attribute(xml_, "height");
  if (width.empty() || height.empty()) return std::nullopt;
  if (read_length(width, size.x) || read_length(height, size.y)) return std::nullopt;
  return size;
}

void SvgWalker::draw_use(Inherited own) {
  const std::optional<std::size_t> target = target_of_use();
  if (!target) return;
  for (const Copy& around : copies_)
    if (around.target == *target) return fail("This <use> is part of what it draws.");
  if (copies_.size() == deepest_use)
    return fail("<use> is nested more than " + std::to_string(deepest_use) + " deep.",
                ErrorCode::too_large);
  own.map = own.map * Affine{1, 0, 0, 1, length("x"), length("y")};
  if (own.name.empty()) own.name = svg_attribute(xml_, "id");
  if (error_) return;
  copies_.push_back({*target, size_of_use()});
  draw_copy(own);
  copies_.pop_back();
}

/// Reads the element of the innermost copy where `own` says.
void SvgWalker::draw_copy(const Inherited& own) {
  XmlReader outside = std::exchange(xml_, XmlReader(text_, copies_.back().target));
  around_.push_back(own);
  at_target_ = true;
  const std::size_t depth = around_.size();
  while (step() && around_.size() > depth) {
  }
  around_.pop_back();
  xml_ = std::move(outside);
}

/// A <symbol> fills the width and height of its <use>, or its own [SVG 1.1, 7.8]; without both, or
/// without a viewBox, coordinates stay as they are, as those of the page do.
void SvgWalker::fit_symbol(Inherited& own) {
  const XmlAttribute* view_box = xml_.find("viewBox");
  std::optional<Vec2> size = copies_.back().size;
  if (!size) size = size_of_use();
  if (view_box == nullptr || !size) return;
  accept(*view_box, fit_view_box(xml_value(view_box->raw),
                                 svg_attribute(xml_, "preserveAspectRatio"), *size, own.map));
}

}  // namespace

Result<SvgOutlines> read_svg_outlines(std::string_view text, Drawing& drawing) {
  return SvgWalker(text, drawing).read();
}

}  // namespace lpq
