// See dxf_domain.h.
#include "io/domain/dxf_domain.h"

#include <algorithm>
#include <functional>

#include "io/domain/drawing.h"
#include "io/domain/dxf_entity.h"

namespace lpq {
namespace {

class DxfReader {
 public:
  explicit DxfReader(std::string_view text) : groups_(text), text_size_(text.size()) {}

  Result<DomainFile> read() {
    if (!find_entities()) return error_;
    while (!failed_ && group_.value != "ENDSEC" && group_.value != "EOF") read_entity();
    if (failed_) return error_;
    leave_out_paper();
    flatten();
    return finish();
  }

 private:
  struct Piece {
    DxfCurve curve;
    Index source;
    bool on_paper;
  };

  bool fail(std::string message) {
    if (!failed_) error_ = groups_.error(std::move(message));
    failed_ = true;
    return false;
  }
  bool next() {
    if (groups_.next(group_)) return true;
    return fail(groups_.is_malformed()
                    ? "A group code (a whole number) was expected; this is not ASCII DXF."
                    : "The file ends before its ENTITIES section does.");
  }

  /// Goes to the first entity.
  bool find_entities() {
    bool in_header = false;
    while (next()) {
      if (in_header && group_.code == 2 && group_.value == "ENTITIES") {
        while (next() && group_.code != 0) {
        }
        return !failed_;
      }
      in_header = group_.code == 0 && group_.value == "SECTION";
      if (group_.code == 0 && group_.value == "EOF") return fail("There is no ENTITIES section.");
    }
    return false;
  }

  /// The entity that starts at the current group; then that group is the start of the next one.
  DxfEntity take_entity() {
    DxfEntity entity{group_.value, {}, group_.line, group_.byte, {}};
    while (next() && group_.code != 0) {
      if (group_.code == 8) entity.layer = group_.value;
      if (group_.code == 67) paper_space_ = group_.value == "1";
      entity.groups.push_back(group_);
    }
    return entity;
  }

  void read_entity() {
    paper_space_ = false;
    const DxfEntity entity = take_entity();
    const bool on_paper = paper_space_;
    std::vector<DxfEntity> vertices;
    while (!failed_ &&
           (group_.value == "VERTEX" || group_.value == "ATTRIB" || group_.value == "SEQEND")) {
      DxfEntity vertex = take_entity();
      if (entity.type == "POLYLINE" && vertex.type == "VERTEX")
        vertices.push_back(std::move(vertex));
    }
    if (failed_) return;
    if (!is_dxf_curve(entity.type)) return left_out_.add(entity.type);
    auto curve = make_dxf_curve(entity, vertices);
    if (!curve) {
      failed_ = true;
      error_ = curve.error();
    } else if (*curve) {
      add(std::move(**curve), entity, on_paper);
    } else {
      left_out_.add(entity.type);
    }
  }

  void add(DxfCurve curve, const DxfEntity& entity, bool on_paper) {
    heights_ += curve.has_height ? 1 : 0;
    interpolated_ += curve.interpolated ? 1 : 0;
    const std::string_view layer = entity.layer == "0" ? std::string_view() : entity.layer;
    pieces_.push_back(
        {std::move(curve), drawing_.add_source(layer, entity.line, entity.byte), on_paper});
  }

  /// Paper space shows the model again, in views and frames - unless it holds all there is.
  void leave_out_paper() {
    const auto is_on_paper = [](const Piece& piece) { return piece.on_paper; };
    const auto model =
        std::stable_partition(pieces_.begin(), pieces_.end(), std::not_fn(is_on_paper));
    const auto on_paper = pieces_.end() - model;
    if (on_paper == 0) return;
    const bool all = model == pieces_.begin();
    warn(true, (all ? "All curves are in paper space, and were taken from there: "
                    : "Curves in paper space were left out: ") +
                   std::to_string(on_paper) + ".");
    if (!all) pieces_.erase(model, pieces_.end());
  }

  void flatten() {
    Box box = empty_box();
    for (const Piece& piece : pieces_) {
      if (piece.curve.spline) {
        extend(box, *piece.curve.spline);
      } else {
        piece.curve.path.extend(box);
      }
    }
    const double tolerance = flattening_tolerance(box);
    std::vector<Vec2> points;
    for (const Piece& piece : pieces_) {
      if (is_too_many(drawing_.lines, text_size_)) return;  // join_drawing says so
      points.clear();
      if (piece.curve.spline) {
        lpq::flatten(*piece.curve.spline, tolerance, points);
      } else {
        piece.curve.path.flatten(tolerance, points);
      }
      drawing_.lines.add(points, piece.curve.closed, piece.source);
    }
    pieces_.clear();
  }

  void warn(bool applies, const std::string& message) {
    if (applies) file_.warnings.push_back({ErrorCode::parse_error, message, {}});
  }

  Result<DomainFile> finish() {
    warn(left_out_.any(), "Left out: " + left_out_.text() + ".");
    warn(heights_ > 0,
         "Entities with z other than 0, which was ignored: " + std::to_string(heights_) + ".");
    warn(interpolated_ > 0, "Splines given by fit points alone, drawn as natural cubic splines: " +
                                std::to_string(interpolated_) + ".");
    const double tolerance = join_tolerance * drawing_size(drawing_.lines);
    const auto joined = join_drawing(drawing_, text_size_, tolerance, file_.warnings);
    if (!joined) return joined.error();
    const NestedFaces nested = nest_faces(drawing_.lines);
    if (!nested.planar.chains.empty()) return open_chain_error(drawing_, nested, tolerance);
    if (nested.planar.faces.empty()) {
      const std::string what = left_out_.any() ? ", only " + left_out_.text() : std::string();
      return Error{ErrorCode::empty, "The drawing has no closed outline" + what + ".", {}};
    }
    const auto name = [&](Index f) { return common_name(drawing_, nested.planar.faces[f]); };
    add_regions(drawing_, nested, even_faces(nested), name, file_.domain);
    return std::move(file_);
  }

  DxfGroups groups_;
  std::size_t text_size_;
  DxfGroup group_;
  bool paper_space_ = false;
  Drawing drawing_;
  std::vector<Piece> pieces_;
  Counter left_out_;
  Index heights_ = 0, interpolated_ = 0;
  DomainFile file_;
  bool failed_ = false;
  Error error_;
};

}  // namespace

Result<DomainFile> read_dxf_domain(std::string_view text) {
  if (text.substr(0, 18) == "AutoCAD Binary DXF") {
    Error error{ErrorCode::parse_error, "Binary DXF cannot be read; save it as ASCII DXF.", {}};
    error.where.line = 1;
    error.where.byte = 0;
    return error;
  }
  return DxfReader(text).read();
}

}  // namespace lpq
