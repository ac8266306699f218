// See poly_domain.h. Nothing is reserved from the counts in the file.
#include "io/domain/poly_domain.h"

#include <algorithm>

#include "io/domain/drawing.h"
#include "io/domain/line_landings.h"
#include "io/number.h"
#include "io/text_lines.h"

namespace lpq {
namespace {

struct Marked {
  Vec2 point;
  std::int64_t marker = 0;
};

/// Points to tell of: how many, and the first.
struct NotedPoints {
  Index count = 0;
  Vec2 first;
  void add(Vec2 p) {
    if (count++ == 0) first = p;
  }
};

std::string marker_name(std::int64_t marker) {
  std::string name;
  if (marker == 0) return name;
  name = "marker ";
  append_integer(name, marker);
  return name;
}

class PolyReader {
 public:
  explicit PolyReader(std::string_view text) : lines_(text), text_size_(text.size()) {}

  Result<DomainFile> read() {
    read_vertices();
    if (!failed_) read_segments();
    if (!failed_) read_holes();
    if (!failed_) read_regions();
    if (failed_) return error_;
    return finish();
  }

 private:
  void fail(std::string message) {
    if (!failed_) error_ = lines_.error(std::move(message));
    failed_ = true;
  }

  /// The next line that is neither blank nor a comment; false at the end of the file.
  bool next_record() {
    do {
      if (lines_.at_end()) return false;
      words_.split(lines_.next());
    } while (words_.size() == 0);
    return true;
  }
  bool next_record(std::size_t words, const char* what) {
    if (!next_record()) {
      fail(std::string("The file ends where ") + what + " was expected.");
    } else if (words_.size() < words) {
      fail(std::string("The line is too short for ") + what + ".");
    }
    return !failed_;
  }
  std::int64_t integer(std::size_t i) {
    std::int64_t value = 0;
    if (!parse_integer(words_[i], value))
      fail(std::string(words_[i].substr(0, 40)).append(" is not an integer."));
    return value;
  }
  double number(std::size_t i) {
    double value = 0;
    if (!parse_number(words_[i], value))
      fail(std::string(words_[i].substr(0, 40)).append(" is not a finite number."));
    return value;
  }
  std::int64_t count(std::size_t i) {
    const std::int64_t value = integer(i);
    if (value < 0) fail("A count is negative.");
    return value;
  }

  void read_vertices();
  void read_segments();
  void read_holes();
  void read_regions();
  std::vector<Marked> free_vertices();
  void warn_of_sides();
  std::vector<Vec2> probes(const std::vector<Marked>& free) const;
  void paint(const NestedFaces& nested, std::vector<char>& filled, std::vector<std::string>& names);
  Index add_points(const std::vector<Marked>& free, const NestedFaces& nested,
                   const std::vector<char>& filled);
  void warn_of(const NotedPoints& points, const char* text);
  void warn(Index segments_outside, Index points_outside);
  Result<DomainFile> finish();

  LineReader lines_;
  std::size_t text_size_;
  Words words_;
  std::int64_t first_ = 0;  // number of the first vertex, 0 or 1
  std::vector<Marked> vertices_;
  std::vector<char> in_segment_;  // the vertex is an end of one
  std::vector<Vec2> holes_, region_points_;
  std::vector<std::string> region_names_;
  Index area_limits_ = 0;
  Drawing drawing_;
  DomainFile file_;
  bool failed_ = false;
  Error error_;
};

void PolyReader::read_vertices() {
  if (!next_record(1, "the number of vertices")) return;
  const std::int64_t vertices = count(0);
  if (vertices == 0 && !failed_)
    return fail(
        "The vertices of this .poly file are in a .node file of their own; put its lines "
        "in place of this one.");
  if (words_.size() > 1 && integer(1) != 2) fail("Only files of dimension 2 can be read.");
  const std::int64_t attributes = words_.size() > 2 ? count(2) : 0;
  const bool marked = words_.size() > 3 && integer(3) != 0;
  for (std::int64_t i = 0; i < vertices && !failed_; ++i) {
    if (!next_record(3, "a vertex (number, x, y)")) return;
    const std::int64_t given = integer(0);
    if (i == 0) first_ = given;
    if (first_ != 0 && first_ != 1) return fail("The first vertex should have number 0 or 1.");
    if (given != first_ + i) return fail("Vertices should be numbered one after another.");
    Marked vertex{{number(1), number(2)}, 0};
    const std::int64_t marker_at = 3 + std::min<std::int64_t>(attributes, 1 << 20);
    if (marked && marker_at < static_cast<std::int64_t>(words_.size()))
      vertex.marker = integer(static_cast<std::size_t>(marker_at));
    vertices_.push_back(vertex);
  }
}

void PolyReader::read_segments() {
  if (!next_record(1, "the number of segments")) return;
  const std::int64_t segments = count(0);
  const bool marked = words_.size() > 1 && integer(1) != 0;
  in_segment_.assign(vertices_.size(), 0);
  for (const Marked& vertex : vertices_) drawing_.lines.points.push_back(vertex.point);
  const auto end = first_ + static_cast<std::int64_t>(vertices_.size());
  for (std::int64_t i = 0; i < segments && !failed_; ++i) {
    if (!next_record(3, "a segment (number and two vertices)")) return;
    const std::int64_t a = integer(1), b = integer(2);
    if (a < first_ || a >= end || b < first_ || b >= end)
      return fail("A segment names a vertex that is not in the file.");
    const std::int64_t marker = marked && words_.size() > 3 ? integer(3) : 0;
    const Index source = drawing_.add_source(marker_name(marker), lines_.line(), lines_.byte());
    const auto from = static_cast<Index>(a - first_), to = static_cast<Index>(b - first_);
    drawing_.lines.edges.push_back({from, to, source});
    in_segment_[from] = in_segment_[to] = 1;
  }
}

void PolyReader::read_holes() {
  if (!next_record(1, "the number of holes")) return;
  const std::int64_t holes = count(0);
  for (std::int64_t i = 0; i < holes && !failed_; ++i) {
    if (!next_record(3, "a hole (number, x, y)")) return;
    holes_.push_back({number(1), number(2)});
  }
}

void PolyReader::read_regions() {
  if (!next_record()) return;
  const std::int64_t regions = count(0);
  for (std::int64_t i = 0; i < regions && !failed_; ++i) {
    if (!next_record(4, "a region (number, x, y, attribute)")) return;
    region_points_.push_back({number(1), number(2)});
    area_limits_ += words_.size() > 4 && number(4) > 0 ? 1 : 0;
    std::string name = "region ";
    append_number(name, number(3));
    region_names_.push_back(std::move(name));
  }
}

/// Vertices without segments that are not on one.
std::vector<Marked> PolyReader::free_vertices() {
  std::vector<Vec2> ends;
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    if (in_segment_[i]) ends.push_back(vertices_[i].point);
  std::sort(ends.begin(), ends.end());
  std::vector<Marked> apart, free;
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    if (in_segment_[i] || std::binary_search(ends.begin(), ends.end(), vertices_[i].point))
      continue;
    apart.push_back(vertices_[i]);
    places.push_back(vertices_[i].point);
  }
  const std::vector<char> on_edge = points_on_edges(drawing_.lines, places);
  NotedPoints left_out;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    if (on_edge[i]) left_out.add(places[i]);
    if (!on_edge[i]) free.push_back(apart[i]);
  }
  warn_of(left_out,
          "Vertices on a segment that is not divided there were left out (make each an end of two "
          "segments): ");
  return free;
}

/// Points of holes and regions should lie inside a face.
void PolyReader::warn_of_sides() {
  std::vector<Vec2> points = holes_;
  points.insert(points.end(), region_points_.begin(), region_points_.end());
  const std::vector<char> on_edge = points_on_edges(drawing_.lines, points);
  NotedPoints noted;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (on_edge[i]) noted.add(points[i]);
  warn_of(noted, "Points of holes and regions on a segment count on one side of it only: ");
}

/// What the faces around are asked for: holes, then points of regions, then free vertices.
std::vector<Vec2> PolyReader::probes(const std::vector<Marked>& free) const {
  std::vector<Vec2> points = holes_;
  points.insert(points.end(), region_points_.begin(), region_points_.end());
  for (const Marked& vertex : free) points.push_back(vertex.point);
  return points;
}

/// Faces with a hole in them are empty; points of regions name theirs.
void PolyReader::paint(const NestedFaces& nested, std::vector<char>& filled,
                       std::vector<std::string>& names) {
  filled.assign(nested.planar.faces.size(), 1);
  names.resize(filled.size());
  NotedPoints idle_holes, idle_regions, renamed;
  for (std::size_t i = 0; i < holes_.size(); ++i) {
    const Index face = nested.around_probe(i);
    if (face == none) idle_holes.add(holes_[i]);
    if (face != none) filled[face] = 0;
  }
  for (std::size_t i = 0; i < region_points_.size(); ++i) {
    const Index face = nested.around_probe(holes_.size() + i);
    if (face == none || !filled[face]) {
      idle_regions.add(region_points_[i]);
      continue;
    }
    if (!names[face].empty() && names[face] != region_names_[i]) renamed.add(region_points_[i]);
    names[face] = region_names_[i];
  }
  warn_of(idle_holes, "Holes whose point no segments enclose had no effect: ");
  warn_of(idle_regions, "Regions whose point lies outside, or in a hole, had no effect: ");
  warn_of(renamed, "Region points in a face that had a name before gave it theirs instead: ");
}

/// Free vertices in filled faces; returns how many others there are.
Index PolyReader::add_points(const std::vector<Marked>& free, const NestedFaces& nested,
                             const std::vector<char>& filled) {
  const std::size_t first_probe = holes_.size() + region_points_.size();
  Index outside = 0;
  for (std::size_t i = 0; i < free.size(); ++i) {
    const Index face = nested.around_probe(first_probe + i);
    if (face == none || !filled[face]) {
      ++outside;
    } else {
      file_.domain.points.push_back({free[i].point, marker_name(free[i].marker)});
    }
  }
  return outside;
}

void PolyReader::warn_of(const NotedPoints& points, const char* text) {
  if (points.count == 0) return;
  Warning warning{ErrorCode::ignored, text + std::to_string(points.count) + ".", {}};
  warning.where.set_point(points.first.x, points.first.y);
  file_.warnings.push_back(std::move(warning));
}

void PolyReader::warn(Index segments_outside, Index points_outside) {
  if (segments_outside > 0 || points_outside > 0)
    file_.warnings.push_back({ErrorCode::ignored,
                              "Outside all regions, and left out: segments " +
                                  std::to_string(segments_outside) + ", vertices " +
                                  std::to_string(points_outside) + ".",
                              {}});
  if (area_limits_ > 0)
    file_.warnings.push_back({ErrorCode::ignored,
                              "Area limits of regions were ignored: " +
                                  std::to_string(area_limits_) + ". Give the option size instead.",
                              {}});
}

Result<DomainFile> PolyReader::finish() {
  if (Problem problem = join_drawing(drawing_, text_size_, 0, file_.warnings)) return *problem;
  const std::vector<Marked> free = free_vertices();
  warn_of_sides();
  const NestedFaces nested = nest_faces(drawing_.lines, probes(free));
  std::vector<char> filled;
  std::vector<std::string> names;
  paint(nested, filled, names);
  if (std::find(filled.begin(), filled.end(), 1) == filled.end())
    return Error{ErrorCode::empty,
                 "Nothing is enclosed by segments, or all of it is holes. The outline must consist "
                 "of segments; the convex hull (Triangle's -c) is not taken.",
                 {}};
  const Index segments_outside = add_regions(
      drawing_, nested, filled, [&](Index f) { return names[f]; }, file_.domain);
  warn(segments_outside, add_points(free, nested, filled));
  return std::move(file_);
}

}  // namespace

Result<DomainFile> read_poly_domain(std::string_view text) { return PolyReader(text).read(); }

}  // namespace lpq
