// See dxf_domain.h.
#include "io/domain/dxf_domain.h"

#include <algorithm>
#include <functional>

#include "io/domain/drawing.h"
#include "io/domain/dxf_blocks.h"

namespace lpq {
namespace {

CurvePath path_of(const DxfPiece& piece) {
  CurvePath path = piece.curve->path;
  if (piece.moved) path.transform(piece.map);
  return path;
}

BSpline spline_of(const DxfPiece& piece) {
  BSpline spline = *piece.curve->spline;
  if (piece.moved)
    for (Vec2& p : spline.control) p = piece.map(p);
  return spline;
}

/// Corners of the polyline but for its start, at least: of a spline the spans that knots as
/// multiple as its degree leave.
std::size_t least_corners(const DxfCurve& curve) {
  if (!curve.spline) return curve.path.least_corners();
  return (curve.spline->control.size() - 1) / static_cast<std::size_t>(curve.spline->degree);
}

class DxfReader {
 public:
  explicit DxfReader(std::string_view text) : text_(text) {}

  Result<DomainFile> read() {
    const auto sections = read_dxf_sections(text_);
    if (!sections) return sections.error();
    letters_ = dxf_letters(text_, sections->code_page);
    code_page_ = sections->code_page;
    auto placed = place_dxf_blocks(*sections, letters_, drawing_);
    if (!placed) return placed.error();
    found_ = *std::move(placed);
    leave_out_paper();
    if (Problem problem = judge_count()) return *problem;
    flatten();
    return finish();
  }

 private:
  /// Paper space shows the model again, in views and frames - unless it holds all there is.
  void leave_out_paper() {
    std::vector<DxfPiece>& pieces = found_.pieces;
    const auto is_on_paper = [](const DxfPiece& piece) { return piece.on_paper; };
    const auto model =
        std::stable_partition(pieces.begin(), pieces.end(), std::not_fn(is_on_paper));
    const auto on_paper = pieces.end() - model;
    if (on_paper == 0) return;
    const bool all = model == pieces.begin();
    warn(true,
         (all ? "All curves are in paper space, and were taken from there: "
              : "Curves in paper space were left out: ") +
             std::to_string(on_paper) + ".",
         all ? ErrorCode::adapted : ErrorCode::ignored);
    if (!all) pieces.erase(model, pieces.end());
  }

  /// Few bytes of INSERTs ask for any number of copies: these are counted before any is made.
  Problem judge_count() const {
    std::size_t corners = 0;
    for (const DxfPiece& piece : found_.pieces) {
      corners += least_corners(*piece.curve);
      if (!is_too_many(corners, text_.size())) continue;
      Error error = too_many_corners();
      const Drawing::Source& source = drawing_.sources[piece.source];
      error.where.set_line(source.line, source.byte);
      return error;
    }
    return {};
  }

  void flatten() {
    Box box = empty_box();
    for (const DxfPiece& piece : found_.pieces) {
      if (piece.curve->spline) {
        extend(box, spline_of(piece));
      } else {
        path_of(piece).extend(box);
      }
    }
    const double tolerance = flattening_tolerance(box);
    std::vector<Vec2> points;
    std::vector<double> bows;
    for (const DxfPiece& piece : found_.pieces) {
      if (is_too_many(drawing_.lines.points.size(), text_.size())) return;  // join_drawing says so
      points.clear();
      bows.clear();
      if (piece.curve->spline) {
        lpq::flatten(spline_of(piece), tolerance, points, &bows);
      } else {
        path_of(piece).flatten(tolerance, points, &bows);
      }
      drawing_.lines.add(points, piece.curve->closed, piece.source, bows);
    }
  }

  void warn(bool applies, const std::string& message, ErrorCode code = ErrorCode::ignored) {
    if (applies) file_.warnings.push_back({code, message, {}});
  }

  void warn_of_letters() {
    if (!found_.foreign_names) return;
    const std::string page = "\"" + std::string(code_page_.substr(0, 40)) + "\"";
    warn(
        letters_ == DxfLetters::unknown,
        "Layers are named in the code page " + page +
            ", which is not known here: their letters outside ASCII became \"?\". Save the drawing "
            "in the format of 2007 or later.",
        ErrorCode::adapted);
    warn(code_page_.empty(),
         "The drawing does not say in which code page its layers are named; ANSI_1252 was taken.",
         ErrorCode::adapted);
  }

  void warn_of_entities() {
    warn(found_.left_out.any(), "Left out: " + found_.left_out.text() + ".");
    warn(found_.hidden.any(),
         "Left out, for they are invisible or on layers that are off or "
         "frozen: " +
             found_.hidden.text() + ".");
    warn(found_.heights > 0, "Entities with z other than 0, which was ignored: " +
                                 std::to_string(found_.heights) + ".");
    warn(found_.interpolated > 0,
         "Splines given by fit points alone, drawn as natural cubic splines: " +
             std::to_string(found_.interpolated) + ".",
         ErrorCode::adapted);
  }

  Error no_outline() const {
    std::string what = "The drawing has no closed outline";
    if (found_.left_out.any()) what += ", only " + found_.left_out.text();
    what += ".";
    if (found_.hidden.any())
      what += " Invisible or on layers that are off or frozen: " + found_.hidden.text() + ".";
    return Error{ErrorCode::empty, std::move(what), {}};
  }

  Result<DomainFile> finish() {
    warn_of_entities();
    warn_of_letters();
    const double tolerance = join_tolerance * drawing_size(drawing_.lines);
    if (Problem problem = join_drawing(drawing_, text_.size(), tolerance, file_.warnings))
      return *problem;
    const NestedFaces nested = nest_faces(drawing_.lines);
    if (!nested.planar.chains.empty()) return open_chain_error(drawing_, nested, tolerance);
    if (nested.planar.faces.empty()) return no_outline();
    const auto name = [&](Index f) { return common_name(drawing_, nested.planar.faces[f]); };
    add_regions(drawing_, nested, even_faces(nested), name, file_.domain);
    return std::move(file_);
  }

  std::string_view text_;
  std::string_view code_page_;
  DxfLetters letters_ = DxfLetters::utf8;
  Drawing drawing_;
  DxfPieces found_;
  DomainFile file_;
};

}  // namespace

Result<DomainFile> read_dxf_domain(std::string_view text) {
  if (text.substr(0, 18) == "AutoCAD Binary DXF") {
    Error error{ErrorCode::parse_error, "Binary DXF cannot be read; save it as ASCII DXF.", {}};
    error.where.set_line(1, 0);
    return error;
  }
  return DxfReader(text).read();
}

}  // namespace lpq
