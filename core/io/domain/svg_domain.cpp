// See svg_domain.h.
#include "io/domain/svg_domain.h"

#include <algorithm>

#include "io/domain/drawing.h"
#include "io/domain/svg_elements.h"

namespace lpq {
namespace {

class SvgReader {
 public:
  explicit SvgReader(std::string_view text) : text_(text) {}

  Result<DomainFile> read() {
    auto found = read_svg_outlines(text_, drawing_);
    if (!found) return found.error();
    found_ = *std::move(found);
    flatten();
    return finish();
  }

 private:
  void flatten();
  void warn(bool applies, std::string message, ErrorCode code = ErrorCode::ignored);
  void warn_of_elements();
  void unite_crossing();
  Result<DomainFile> finish();

  std::string_view text_;
  Drawing drawing_;
  SvgOutlines found_;
  Index closed_by_fill_ = 0;
  DomainFile file_;
};

/// Relative commands that lead back to the start end beside it, by what rounding adds up to, and
/// rounded numbers do so by more: that is no edge. Among edges of its own length one may be meant.
void drop_rounded_end(double size, double tolerance, std::vector<Vec2>& points) {
  constexpr double rounding = 1e-11, share = 0.05;  // of the size; of the edges beside
  while (points.size() > 3) {
    const double gap = distance(points.front(), points.back());
    const double beside = std::min(distance(points[0], points[1]),
                                   distance(points.back(), points[points.size() - 2]));
    if (gap > rounding * size && (gap > tolerance || gap > share * beside)) return;
    points.pop_back();
  }
}

void SvgReader::flatten() {
  Box box = empty_box();
  for (const SvgOutline& outline : found_.outlines) outline.path.curve.extend(box);
  const double tolerance = flattening_tolerance(box);
  std::vector<Vec2> points;
  std::vector<double> bows;
  for (SvgOutline& outline : found_.outlines) {
    if (is_too_many(drawing_.lines.points.size(), text_.size())) return;  // join_drawing says so
    points.clear();
    bows.clear();
    outline.path.curve.flatten(tolerance, points, &bows);
    bool closed = outline.path.closed;
    if (!closed && outline.fill != FillRule::unfilled && points.size() > 2) {
      closed = true;  // as filling does (SVG 1.1, 11.3)
      if (!(points.front() == points.back())) ++closed_by_fill_;
    }
    if (closed) drop_rounded_end(diagonal(box), tolerance, points);
    drawing_.lines.add(points, closed, outline.source, bows);
    outline.path.curve = CurvePath();
  }
}

void SvgReader::warn(bool applies, std::string message, ErrorCode code) {
  if (applies) file_.warnings.push_back({code, std::move(message), {}});
}

void SvgReader::warn_of_elements() {
  warn(closed_by_fill_ > 0,
       "Open paths were closed, as their fill is: " + std::to_string(closed_by_fill_) + ".",
       ErrorCode::adapted);
  warn(found_.left_out.any(), "Left out: " + found_.left_out.text() + ".");
  warn(found_.not_applied.any(),
       "Not applied: " + found_.not_applied.text() +
           ". Apply it to the outlines in the drawing program and save the file again.");
  warn(found_.unread_rules > 0,
       "Style rules for more than a name, a class or an id were left out: " +
           std::to_string(found_.unread_rules) + ".");
}

void SvgReader::unite_crossing() {
  std::vector<FillRule> rules(drawing_.sources.size(), FillRule::unfilled);
  for (const SvgOutline& outline : found_.outlines) rules[outline.source] = outline.fill;
  const double gap = join_tolerance * drawing_size(drawing_.lines);
  if (const auto place = unite_painted(drawing_.lines, rules, gap)) {
    warn(true, "Painted shapes cross: what they cover together was taken, without the lines in it.",
         ErrorCode::adapted);
    file_.warnings.back().where.set_point(place->x, place->y);
  }
}

Result<DomainFile> SvgReader::finish() {
  warn_of_elements();
  if (!is_too_many(drawing_.lines.points.size(), text_.size())) unite_crossing();
  const double tolerance = join_tolerance * drawing_size(drawing_.lines);
  if (Problem problem = join_drawing(drawing_, text_.size(), tolerance, file_.warnings))
    return *problem;
  const NestedFaces nested = nest_faces(drawing_.lines);
  if (nested.planar.faces.empty()) {
    if (!nested.planar.chains.empty()) return open_chain_error(drawing_, nested, tolerance);
    std::string text = "The drawing has no closed outline";
    if (found_.left_out.any()) text += ", only " + found_.left_out.text();
    return Error{ErrorCode::empty, text + ".", {}};
  }
  const auto name = [&](Index f) { return common_name(drawing_, nested.planar.faces[f]); };
  const Index outside =
      add_regions(drawing_, nested, painted_faces(drawing_.lines, nested), name, file_.domain);
  warn(outside > 0,
       "Open lines outside all regions were left out: " + std::to_string(outside) + ".");
  return std::move(file_);
}

}  // namespace

Result<DomainFile> read_svg_domain(std::string_view text) { return SvgReader(text).read(); }

}  // namespace lpq
