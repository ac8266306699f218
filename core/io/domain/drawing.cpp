// See drawing.h.
#include "io/domain/drawing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/words.h"
#include "geometry/box.h"
#include "geometry/segment.h"
#include "io/domain/crossings.h"
#include "io/number.h"

namespace lpq {
namespace {

constexpr double rounding = 1e-9;  // of the drawing's size: nine digits agree
constexpr std::size_t most_kinds = 20;

std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::vector<Vec2> points_of(const LineWork& lines, const Walk& walk) {
  std::vector<Vec2> points;
  points.reserve(walk.points.size());
  for (const Index p : walk.points) points.push_back(lines.points[p]);
  return points;
}

const std::string& tag_of(const Drawing& drawing, Index edge) {
  return drawing.sources[drawing.lines.edges[edge].source].name;
}

/// Tags of a loop's edges, empty where no edge has one.
std::vector<std::string> tags_of(const Drawing& drawing, const Walk& walk) {
  const auto tagged = [&](Index e) { return !tag_of(drawing, e).empty(); };
  if (std::none_of(walk.edges.begin(), walk.edges.end(), tagged)) return {};
  std::vector<std::string> tags;
  tags.reserve(walk.edges.size());
  for (const Index e : walk.edges) tags.push_back(tag_of(drawing, e));
  return tags;
}

/// In the direction in which it was drawn, so that points stay in the caller's order.
void add_loop(const Drawing& drawing, Walk walk, DomainInput::Region& region) {
  if (drawing.lines.edges[walk.edges.front()].a != walk.points.front()) {
    std::reverse(walk.points.begin() + 1, walk.points.end());
    std::reverse(walk.edges.begin(), walk.edges.end());
  }
  region.loops.push_back(points_of(drawing.lines, walk));
  region.tags.push_back(tags_of(drawing, walk));
}

void warn(std::vector<Warning>& warnings, ErrorCode code, std::string message, Vec2 at) {
  warnings.push_back({code, std::move(message), {}});
  warnings.back().where.set_point(at.x, at.y);
}

/// The first source of the same name, for every source.
std::vector<Index> first_of_name(const std::vector<Drawing::Source>& sources) {
  std::vector<Index> order(sources.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index s, Index t) { return sources[s].name < sources[t].name; });
  std::vector<Index> first(order);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_new = k == 0 || sources[order[k]].name != sources[order[k - 1]].name;
    first[order[k]] = is_new ? order[k] : first[order[k - 1]];
  }
  return first;
}

/// Fills holes that were drawn again under another name, and turns over what lies in them. Returns
/// which faces fill one.
std::vector<char> fill_drawn_holes(const Drawing& drawing, const NestedFaces& nested,
                                   std::vector<char>& filled) {
  const std::size_t count = filled.size();
  std::vector<char> fills(count, 0), turned(count, 0);
  if (drawing.drawn.twice_area.empty()) return fills;
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index f, Index g) { return nested.tree.depth[f] < nested.tree.depth[g]; });
  for (const Index f : order) {
    const Index around = nested.tree.parent[f];
    turned[f] = around != none && turned[around];
    if (turned[f]) filled[f] = !filled[f];
    if (filled[f] || around == none || !filled[around]) continue;
    const Walk& face = nested.planar.faces[f];
    if (enclosure_of(drawing.drawn, drawing.lines, face).all().size() < 2) continue;
    fills[f] = filled[f] = 1;
    turned[f] = !turned[f];
  }
  return fills;
}

/// The last name around a face that fills a hole that is not the name of what is around the hole.
std::string filling_name(const Drawing& drawing, const Walk& face, const std::string& around) {
  std::vector<Index> sources = enclosure_of(drawing.drawn, drawing.lines, face).all();
  std::sort(sources.begin(), sources.end());
  while (sources.size() > 1 && drawing.sources[sources.back()].name == around) sources.pop_back();
  return drawing.sources[sources.back()].name;
}

std::vector<Index> degrees(const LineWork& lines) {
  std::vector<Index> degree(lines.points.size(), 0);
  for (const LineWork::Edge& edge : lines.edges) {
    ++degree[edge.a];
    ++degree[edge.b];
  }
  return degree;
}

/// The distance from point p to the nearest edge that is not its own.
double nearest_line(const LineWork& lines, Index p) {
  double nearest = HUGE_VAL;
  const Vec2 at = lines.points[p];
  for (const LineWork::Edge& edge : lines.edges)
    if (edge.a != p && edge.b != p)
      nearest = std::min(
          nearest, distance(at, closest_point(at, lines.points[edge.a], lines.points[edge.b])));
  return nearest;
}

/// The distance from point p to the nearest other loose end that is not the far end of its chain.
double nearest_end(const Drawing& drawing, const std::vector<Index>& degree, Index p, Index own) {
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i < degree.size(); ++i) {
    if (degree[i] != 1 || static_cast<Index>(i) == p || static_cast<Index>(i) == own) continue;
    nearest = std::min(nearest, distance(drawing.lines.points[i], drawing.lines.points[p]));
  }
  return nearest;
}

std::string place_text(Vec2 p) { return "(" + number_text(p.x) + ", " + number_text(p.y) + ")"; }

/// What is around the open end p of a chain whose other end is `own`.
std::string open_end_text(const Drawing& drawing, const std::vector<Index>& degree, Index p,
                          Index own, double tolerance) {
  std::string text = "The outline is open at " + place_text(drawing.lines.points[p]) +
                     ": nothing else ends " +
                     (tolerance > 0 ? "within " + short_number(tolerance) + " of it" : "there");
  const double end = nearest_end(drawing, degree, p, own), line = nearest_line(drawing.lines, p);
  if (end < HUGE_VAL) text += "; the nearest other open end is " + short_number(end) + " away";
  if (line <= tolerance) {
    text += "; it lies on a line that runs along its own";
  } else if (line < end) {
    text += "; the nearest line is " + short_number(line) +
            " away, and would be divided where something ends on it";
  }
  return text + ". Close it in the drawing.";
}

Error error_at_edge(const Drawing& drawing, Index edge, Vec2 at, std::string message) {
  const Drawing::Source& source = drawing.sources[drawing.lines.edges[edge].source];
  Error error{ErrorCode::parse_error, std::move(message), {}};
  error.where.set_line(source.line, source.byte);
  error.where.set_point(at.x, at.y);
  return error;
}

/// The first two lines that cross: around them nothing can be told of what divides what.
Problem crossing_error(const Drawing& drawing) {
  const LineWork& lines = drawing.lines;
  const auto crossings = find_crossings(lines);
  if (!crossings || crossings->empty()) return std::nullopt;
  const LineWork::Edge& one = lines.edges[crossings->front().edge];
  const LineWork::Edge& two = lines.edges[crossings->front().other];
  const auto at = [&](Index p) { return lines.points[p]; };
  const Vec2 place = crossing_point(at(one.a), at(one.b), at(two.a), at(two.b));
  return error_at_edge(drawing, crossings->front().edge, place,
                       "Two lines cross near " + place_text(place) +
                           " and have no end there, so that they divide nothing. Break both of "
                           "them there.");
}

}  // namespace

Index Drawing::add_source(std::string_view name, std::int64_t line, std::int64_t byte) {
  std::size_t size = std::min(name.size(), longest_name);
  while (size > 0 && size < name.size() && (name[size] & 0xC0) == 0x80) --size;
  sources.push_back({std::string(name.substr(0, size)), line, byte});
  return static_cast<Index>(sources.size()) - 1;
}

double drawing_size(const LineWork& lines) {
  return lines.points.empty() ? 0 : longer_side(box_of(lines.points));
}

Error too_many_corners() {
  return {ErrorCode::too_large,
          "The curves of this drawing have more than a million corners, and more than the file has "
          "bytes. Draw them with fewer points, or simpler.",
          {}};
}

Problem join_drawing(Drawing& drawing, std::size_t bytes, double tolerance,
                     std::vector<Warning>& warnings) {
  if (is_too_many(drawing.lines.points.size(), bytes)) return too_many_corners();
  for (const LineWork::Edge& edge : drawing.lines.edges) {
    if (is_finite(drawing.lines.points[edge.a]) && is_finite(drawing.lines.points[edge.b]))
      continue;
    const Drawing::Source& source = drawing.sources[edge.source];
    Error error{ErrorCode::non_finite, "A coordinate is too large for a double.", {}};
    error.where.set_line(source.line, source.byte);
    return error;
  }
  const double size = drawing_size(drawing.lines);
  const Joined joined = join_points(drawing.lines, tolerance);
  if (joined.farthest > rounding * size)
    warn(warnings, ErrorCode::duplicate_point,
         "Points within " + short_number(tolerance) +
             " of each other were made one: " + std::to_string(joined.moved) + ", at most " +
             short_number(joined.farthest) + " apart.",
         joined.moved_at);
  if (joined.farthest_landed > rounding * size)
    warn(warnings, ErrorCode::touching,
         "Points within " + short_number(tolerance) +
             " of a line were made corners of it: " + std::to_string(joined.landed) + ", at most " +
             short_number(joined.farthest_landed) + " away.",
         joined.landed_at);
  if (joined.doubled > 0)
    warn(warnings, ErrorCode::overlapping_edges,
         "Edges drawn more than once were taken once: " + std::to_string(joined.doubled) + ".",
         joined.doubled_at);
  drawing.drawn = drawn_edges_of(drawing.lines, first_of_name(drawing.sources));
  return {};
}

NestedFaces nest_faces(const LineWork& lines, std::span<const Vec2> probes) {
  NestedFaces nested;
  nested.planar = find_faces(lines);
  std::vector<std::vector<Vec2>> loops;
  for (const Walk& face : nested.planar.faces) loops.push_back(points_of(lines, face));
  std::vector<Vec2> all;
  for (const Walk& chain : nested.planar.chains)
    all.push_back(midpoint(lines.points[chain.points[0]], lines.points[chain.points[1]]));
  all.insert(all.end(), probes.begin(), probes.end());
  nested.tree = nest_loops(loops, all);
  return nested;
}

std::vector<char> even_faces(const NestedFaces& nested) {
  std::vector<char> filled;
  for (const Index depth : nested.tree.depth) filled.push_back(depth % 2 == 0);
  return filled;
}

Index add_regions(const Drawing& drawing, const NestedFaces& nested, std::vector<char> filled,
                  const std::function<std::string(Index)>& name, DomainInput& input) {
  const std::vector<char> fills = fill_drawn_holes(drawing, nested, filled);
  const PlanarFaces& planar = nested.planar;
  std::vector<Index> region_of(planar.faces.size(), none),
      parent(drawing.lines.points.size(), none);
  for (std::size_t f = 0; f < planar.faces.size(); ++f) {
    parent[planar.faces[f].component] = nested.tree.parent[f];
    if (!filled[f]) continue;
    region_of[f] = static_cast<Index>(input.regions.size());
    input.regions.emplace_back();
    if (name) input.regions.back().name = name(static_cast<Index>(f));
    add_loop(drawing, planar.faces[f], input.regions.back());
  }
  for (std::size_t f = 0; f < fills.size(); ++f) {
    if (!name || !fills[f]) continue;
    const DomainInput::Region& around = input.regions[region_of[nested.tree.parent[f]]];
    input.regions[region_of[f]].name = filling_name(drawing, planar.faces[f], around.name);
  }
  for (const Walk& outer : planar.outers) {
    const Index around = parent[outer.component];
    if (around == none || !filled[around]) continue;
    add_loop(drawing, outer, input.regions[region_of[around]]);
  }
  Index left_out = 0;
  for (std::size_t c = 0; c < planar.chains.size(); ++c) {
    const Index around = nested.around_chain(c);
    if (around == none || !filled[around]) {
      ++left_out;
      continue;
    }
    const Walk& chain = planar.chains[c];
    input.polylines.push_back(
        {points_of(drawing.lines, chain), tag_of(drawing, chain.edges.front())});
  }
  return left_out;
}

std::string common_name(const Drawing& drawing, const Walk& walk) {
  Enclosure around = enclosure_of(drawing.drawn, drawing.lines, walk);
  std::vector<Index>& shared = around.shared;
  std::erase_if(shared, [&](Index source) { return drawing.sources[source].name.empty(); });
  const auto is_shared = [&](Index source) {
    return shared.empty() || std::find(shared.begin(), shared.end(), source) != shared.end();
  };
  const auto smallest = std::find_if(around.outlines.begin(), around.outlines.end(), is_shared);
  if (shared.size() != 1 && smallest != around.outlines.end())
    return drawing.sources[*smallest].name;
  return shared.empty() ? std::string() : drawing.sources[shared.front()].name;
}

Error open_chain_error(const Drawing& drawing, const NestedFaces& nested, double tolerance) {
  const std::vector<Index> degree = degrees(drawing.lines);
  const std::vector<Vec2>& points = drawing.lines.points;
  for (const Walk& chain : nested.planar.chains) {
    const Index first = chain.points.front(), last = chain.points.back();
    const bool at_end = degree[first] != 1;
    if (at_end && degree[last] != 1) continue;
    return error_at_edge(
        drawing, at_end ? chain.edges.back() : chain.edges.front(), points[at_end ? last : first],
        open_end_text(drawing, degree, at_end ? last : first, at_end ? first : last, tolerance));
  }
  if (const auto crossing = crossing_error(drawing)) return *crossing;
  const Walk& bridge = nested.planar.chains.front();
  const Vec2 start = points[bridge.points.front()];
  return error_at_edge(drawing, bridge.edges.front(), start,
                       "The line that begins at " + place_text(start) +
                           " leads from outline to outline and divides nothing. Remove it from "
                           "the drawing.");
}

void Counter::add(std::string_view name) {
  name = name.substr(0, 40);
  for (auto& [known, count] : counts_) {
    if (known != name && known != "other things") continue;
    ++count;
    return;
  }
  counts_.emplace_back(counts_.size() < most_kinds ? std::string(name) : "other things", 1);
}

std::string Counter::text() const {
  std::string text;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (i > 0) text += i + 1 == counts_.size() ? " and " : ", ";
    text += std::to_string(counts_[i].second) + " " + counts_[i].first;
  }
  return text;
}

}  // namespace lpq
