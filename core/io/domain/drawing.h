// From the lines of a drawing to a domain: what all formats share that draw outlines without
// saying what is inside.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/domain/domain_file.h"
#include "io/domain/line_work.h"
#include "io/domain/loop_tree.h"
#include "io/domain/outlines.h"
#include "io/domain/planar_faces.h"

namespace lpq {

struct Drawing {
  /// What drew an edge: an element, an entity, a segment.
  struct Source {
    std::string name;  // becomes the edge's tag, "" = none
    std::int64_t line = none, byte = none;
  };
  std::vector<Source> sources;
  LineWork lines;
  DrawnEdges drawn;  // by join_drawing

  Index add_source(std::string_view name, std::int64_t line = none, std::int64_t byte = none);
};

/// Names longer than this are cut, between characters: every edge of a long curve carries one.
inline constexpr std::size_t longest_name = 127;

/// Points of open pieces this near, relative to the larger side of the drawing's box, are one
/// point. Numbers in drawings have six digits or so, and each program rounds in its own way.
inline constexpr double join_tolerance = 1e-5;

/// A text of `bytes` may draw this many points: one for each byte, or a million. Few bytes make a
/// curve of many corners, and memory is to grow with the text.
inline bool is_too_many(std::size_t points, std::size_t bytes) {
  constexpr std::size_t always_allowed = 1 << 20;
  return points > always_allowed && points > bytes;
}
/// What is said then: too_large.
Error too_many_corners();

/// The larger side of the box around the points; 0 without points.
double drawing_size(const LineWork& lines);

/// Joins the points, with warnings about gaps larger than rounding (1e-9 of the size), between
/// points and from points to lines, and about edges drawn twice. `bytes` is the size of the text.
/// Errors: non_finite, too_large.
Problem join_drawing(Drawing& drawing, std::size_t bytes, double tolerance,
                     std::vector<Warning>& warnings);

/// The faces of joined line work, and which of them lie in which others.
struct NestedFaces {
  PlanarFaces planar;
  LoopTree tree;  // of planar.faces; `around` of the chains first, then of the probes
  Index around_chain(std::size_t c) const { return tree.around[c]; }
  Index around_probe(std::size_t i) const { return tree.around[planar.chains.size() + i]; }
};
NestedFaces nest_faces(const LineWork& lines, std::span<const Vec2> probes = {});

/// The even-odd rule: faces inside an even number of outlines of other parts are filled.
std::vector<char> even_faces(const NestedFaces& nested);

/// A region for every face with filled[f], and for those that closed outlines or lines of several
/// names enclose, for one of them is of a hole then, and another one fills it. Each with the
/// outlines of what lies in it as holes, edge tags and, where `name(f)` is given, a name. Chains in
/// filled faces become polylines; returns how many others there are.
Index add_regions(const Drawing& drawing, const NestedFaces& nested, std::vector<char> filled,
                  const std::function<std::string(Index)>& name, DomainInput& input);

/// The name that everything around a face was drawn with, else that of the smallest closed outline
/// around it of those along its border, else "".
std::string common_name(const Drawing& drawing, const Walk& walk);

/// The first loose end of the drawing as an error: what is open, and how far the nearest end and
/// the nearest line are; without a loose end, the first two lines that cross, or the first line that
/// joins outlines.
Error open_chain_error(const Drawing& drawing, const NestedFaces& nested, double tolerance);

/// "2 INSERT and 1 TEXT": counted names, in the order of the first of each kind.
class Counter {
 public:
  void add(std::string_view name);
  bool any() const { return !counts_.empty(); }
  std::string text() const;

 private:
  std::vector<std::pair<std::string, std::int64_t>> counts_;
};

}  // namespace lpq
