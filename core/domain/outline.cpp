#include "domain/outline.h"

#include <cmath>
#include <cstdio>

#include "base/few_warnings.h"
#include "base/sort_numbers.h"

namespace lpq {
namespace {

// Indices are 32 bits and a mesh has several elements per given point.
constexpr std::size_t max_points = std::size_t{1} << 26;

// Coordinates below this (unit frame) would underflow in the exact predicates, whose terms are
// products of up to four coordinate differences: (2^-200 2^-53)^4 is just above the smallest
// double.
constexpr double smallest_coordinate = 0x1p-200;

// The frame shifts a range that is far from the origin; what it leaves lies within this.
constexpr double largest_coordinate = 4;

class OutlineBuilder {
 public:
  OutlineBuilder(const DomainInput& input, const DomainOptions& options) : options_(options) {
    outline_.input = &input;
  }
  Result<Outline> build();

 private:
  Problem check_counts() const;
  Problem check_tags() const;
  Problem check_numbers() const;
  Problem add_chain(Chain chain, const std::vector<Vec2>& points);
  Problem report_duplicate(const Chain& chain, Index at, Vec2 p);
  Problem fit();
  void number_vertices();
  Problem merge_points();

  const DomainInput& input() const { return *outline_.input; }

  DomainOptions options_;
  Outline outline_;
  FewWarnings duplicates_;
};

std::string chain_name(const Outline& outline, const Chain& chain) {
  return chain.is_loop() ? loop_name(outline, chain) : "polyline " + std::to_string(chain.number);
}

Problem OutlineBuilder::check_counts() const {
  std::size_t count = input().points.size();
  for (const DomainInput::Polyline& line : input().polylines) count += line.points.size();
  bool any_loop = false;
  for (std::size_t r = 0; r < input().regions.size(); ++r) {
    const auto& loops = input().regions[r].loops;
    any_loop = any_loop || !loops.empty();
    for (const Loop& loop : loops) count += loop.size();
  }
  if (count > max_points)
    return Error{ErrorCode::too_large,
                 "The input has " + std::to_string(count) + " points; the limit is " +
                     std::to_string(max_points) + ".",
                 {}};
  if (!any_loop)
    return Error{ErrorCode::empty, "The input has no loops, so there is nothing to mesh.", {}};
  for (std::size_t r = 0; r < input().regions.size(); ++r) {
    if (!input().regions[r].loops.empty()) continue;
    Where where;
    where.region = static_cast<Index>(r);
    return Error{ErrorCode::empty, "The " + region_name(input(), where.region) + " has no loops.",
                 where};
  }
  return {};
}

// One tag per point given is right as well where the first is repeated at the end.
Problem OutlineBuilder::check_tags() const {
  for (std::size_t r = 0; r < input().regions.size(); ++r) {
    const DomainInput::Region& region = input().regions[r];
    Where where;
    where.region = static_cast<Index>(r);
    if (region.tags.size() > region.loops.size()) {
      where.loop = static_cast<Index>(region.loops.size());
      return Error{ErrorCode::bad_option,
                   "There are edge tags for " + std::to_string(region.tags.size()) +
                       " loops, but the " + region_name(input(), where.region) + " has " +
                       std::to_string(region.loops.size()) +
                       "; give a list of tags per loop, with a tag per edge.",
                   where};
    }
    for (std::size_t l = 0; l < region.tags.size(); ++l) {
      const Loop& loop = region.loops[l];
      const std::size_t tags = region.tags[l].size();
      const std::size_t edges = loop.size() - (loop.size() > 1 && loop.front() == loop.back());
      if (tags == 0 || tags == edges || tags == loop.size()) continue;
      where.loop = static_cast<Index>(l);
      return Error{ErrorCode::bad_option,
                   "Loop " + std::to_string(l) + " has " + std::to_string(edges) + " edges but " +
                       std::to_string(tags) +
                       " edge tags; give one tag per edge (\"\" where there is none), or none.",
                   where};
    }
  }
  return {};
}

Error not_finite(const std::string& what, Where where) {
  return {ErrorCode::non_finite,
          what + " has a coordinate that is NaN or infinite; coordinates must be finite numbers.",
          where};
}

Problem OutlineBuilder::check_numbers() const {
  const auto bad = [](const std::vector<Vec2>& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!is_finite(points[i])) return static_cast<Index>(i);
    return none;
  };
  Where where;
  for (std::size_t r = 0; r < input().regions.size(); ++r) {
    for (std::size_t l = 0; l < input().regions[r].loops.size(); ++l) {
      where.edge = bad(input().regions[r].loops[l]);
      if (where.edge == none) continue;
      where.region = static_cast<Index>(r);
      where.loop = static_cast<Index>(l);
      return not_finite("Point " + std::to_string(where.edge) + " of loop " + std::to_string(l),
                        where);
    }
  }
  for (std::size_t i = 0; i < input().polylines.size(); ++i) {
    where.edge = bad(input().polylines[i].points);
    if (where.edge != none)
      return not_finite("Point " + std::to_string(where.edge) + " of polyline " + std::to_string(i),
                        where);
  }
  for (std::size_t i = 0; i < input().points.size(); ++i)
    if (!is_finite(input().points[i].position))
      return not_finite("Point " + std::to_string(i), where);
  if (!std::isfinite(input().h))
    return Error{ErrorCode::non_finite, "The mesh size h is NaN or infinite.", {}};
  if (input().h < 0)
    return Error{ErrorCode::bad_size, "The mesh size h is negative; it must be positive.", {}};
  return {};
}

Problem OutlineBuilder::report_duplicate(const Chain& chain, Index at, Vec2 p) {
  Where where = at_point(where_loop(chain), p);
  where.edge = at;
  const std::string place = "Points " + std::to_string(at) + " and the one after it in " +
                            chain_name(outline_, chain) + " are the same, " + point_text(p);
  if (options_.strict)
    return Error{ErrorCode::duplicate_point, place + ". Remove one of them.", where};
  duplicates_.add({ErrorCode::duplicate_point, place + "; merged.", where});
  return {};
}

// Of a run of equal points the first is kept; the edge that leaves the run starts at its last.
Problem OutlineBuilder::add_chain(Chain chain, const std::vector<Vec2>& points) {
  Index n = static_cast<Index>(points.size());
  if (chain.is_loop() && n > 1 && points[n - 1] == points[0]) --n;
  chain.begin = static_cast<Index>(outline_.given.size());
  for (Index i = 0; i < n; ++i) {
    if (i > 0 && points[i] == points[i - 1]) {
      if (Problem problem = report_duplicate(chain, i - 1, points[i])) return problem;
      outline_.edge_as_given.back() = i;
      continue;
    }
    outline_.given.push_back(points[i]);
    outline_.edge_as_given.push_back(i);
  }
  // A run of equal points may go on over the start of a loop.
  while (chain.is_loop() && static_cast<Index>(outline_.given.size()) - chain.begin > 1 &&
         outline_.given.back() == outline_.given[chain.begin]) {
    if (Problem problem =
            report_duplicate(chain, outline_.edge_as_given.back(), outline_.given.back()))
      return problem;
    outline_.given.pop_back();
    outline_.edge_as_given.pop_back();
  }
  chain.end = static_cast<Index>(outline_.given.size());
  chain.edge_begin = static_cast<Index>(outline_.edges.size());
  const Index number = static_cast<Index>(outline_.chains.size());
  for (Index c = chain.begin; c + 1 < chain.end; ++c) outline_.edges.push_back({c, c + 1, number});
  if (chain.is_loop() && chain.size() > 1)
    outline_.edges.push_back({chain.end - 1, chain.begin, number});
  chain.edge_end = static_cast<Index>(outline_.edges.size());
  outline_.chains.push_back(chain);
  return {};
}

Problem OutlineBuilder::fit() {
  outline_.frame = fit_frame(outline_.given);
  outline_.points.reserve(outline_.given.size());
  for (const Vec2 world : outline_.given) {
    const Vec2 p = outline_.frame.to_frame(world);
    const auto too_small = [](double v) { return v != 0 && std::abs(v) < smallest_coordinate; };
    // Larger than the frame if the extent itself is beyond the largest double.
    const bool fits = std::abs(p.x) <= largest_coordinate && std::abs(p.y) <= largest_coordinate;
    const bool exact = fits && outline_.frame.to_world(p) == world;
    if (!exact || too_small(p.x) || too_small(p.y))
      return Error{ErrorCode::lost_precision,
                   "The point " + point_text(world) +
                       " cannot be held exactly beside the others: the coordinates differ too much "
                       "in magnitude, or are at the end of what doubles hold. Bring them to a "
                       "common scale near 1; write 0 for values that are "
                       "zero but for rounding.",
                   at_point({}, world)};
    outline_.points.push_back(p);
  }
  return {};
}

void OutlineBuilder::number_vertices() {
  const Index n = static_cast<Index>(outline_.points.size());
  const auto& p = outline_.points;
  const std::vector<Index> order = sorted_numbers(
      p.size(), [&](Index a, Index b) { return p[a] < p[b] || (p[a] == p[b] && a < b); });
  outline_.vertex.resize(n);
  for (Index i = 0; i < n; ++i) {
    if (i > 0 && !(p[order[i]] == p[order[i - 1]])) ++outline_.vertex_count;
    outline_.vertex[order[i]] = outline_.vertex_count;
  }
  ++outline_.vertex_count;
}

Problem OutlineBuilder::merge_points() {
  std::vector<Index> first(outline_.vertex_count, none);
  Index kept = outline_.first_point;
  for (Index c = outline_.first_point; c < static_cast<Index>(outline_.points.size()); ++c) {
    Index& earlier = first[outline_.vertex[c]];
    const Index number = outline_.edge_as_given[c];
    if (earlier == none) {
      earlier = number;
      outline_.points[kept] = outline_.points[c];
      outline_.given[kept] = outline_.given[c];
      outline_.vertex[kept] = outline_.vertex[c];
      outline_.edge_as_given[kept++] = number;
      continue;
    }
    const std::string place = "Points " + std::to_string(earlier) + " and " +
                              std::to_string(number) + " are the same, " +
                              point_text(outline_.given[c]);
    const Where where = at_point({}, outline_.given[c]);
    if (options_.strict)
      return Error{ErrorCode::duplicate_point, place + ". Remove one of them.", where};
    duplicates_.add({ErrorCode::duplicate_point, place + "; merged.", where});
  }
  outline_.points.resize(kept);
  outline_.given.resize(kept);
  outline_.vertex.resize(kept);
  outline_.edge_as_given.resize(kept);
  return {};
}

Result<Outline> OutlineBuilder::build() {
  if (Problem problem = check_counts()) return *problem;
  if (Problem problem = check_numbers()) return *problem;
  if (Problem problem = check_tags()) return *problem;
  for (std::size_t r = 0; r < input().regions.size(); ++r) {
    const auto& loops = input().regions[r].loops;
    for (std::size_t l = 0; l < loops.size(); ++l) {
      const Chain chain{.region = static_cast<Index>(r), .number = static_cast<Index>(l)};
      if (Problem problem = add_chain(chain, loops[l])) return *problem;
    }
  }
  outline_.loop_count = static_cast<Index>(outline_.chains.size());
  for (std::size_t i = 0; i < input().polylines.size(); ++i) {
    const Chain chain{.number = static_cast<Index>(i)};
    if (Problem problem = add_chain(chain, input().polylines[i].points)) return *problem;
  }
  outline_.first_point = static_cast<Index>(outline_.given.size());
  for (std::size_t i = 0; i < input().points.size(); ++i) {
    outline_.given.push_back(input().points[i].position);
    outline_.edge_as_given.push_back(static_cast<Index>(i));
  }
  if (Problem problem = fit()) return *problem;
  number_vertices();
  if (Problem problem = merge_points()) return *problem;
  outline_.warnings = duplicates_.take();
  return std::move(outline_);
}

}  // namespace

Result<Outline> make_outline(const DomainInput& input, const DomainOptions& options) {
  return OutlineBuilder(input, options).build();
}

std::string region_name(const DomainInput& input, Index region) {
  const std::string& name = input.regions[region].name;
  return "region " + std::to_string(region) + (name.empty() ? "" : " (" + name + ")");
}

std::string loop_name(const Outline& outline, const Chain& chain) {
  const std::string name = "loop " + std::to_string(chain.number);
  if (outline.input->regions.size() < 2) return name;
  return name + " of " + region_name(*outline.input, chain.region);
}

std::string edge_name(const Outline& outline, Index edge) {
  const Chain& chain = outline.chains[outline.edges[edge].chain];
  return "edge " + std::to_string(outline.edge_as_given[outline.edges[edge].a]) + " of " +
         chain_name(outline, chain);
}

std::string point_text(Vec2 world) {
  char text[80];
  std::snprintf(text, sizeof text, "(%.10g, %.10g)", world.x, world.y);
  return text;
}

Where where_loop(const Chain& chain) {
  Where where;
  where.region = chain.region;
  if (chain.is_loop()) where.loop = chain.number;
  return where;
}

Where where_edge(const Outline& outline, Index edge) {
  Where where = where_loop(outline.chains[outline.edges[edge].chain]);
  where.edge = outline.edge_as_given[outline.edges[edge].a];
  return where;
}

Where where_edges(const Outline& outline, Index edge, Index other) {
  Where where = where_edge(outline, edge);
  const Where second = where_edge(outline, other);
  where.other_loop = second.loop;
  where.other_edge = second.edge;
  return where;
}

Where at_point(Where where, Vec2 point) {
  where.set_point(point.x, point.y);
  return where;
}

}  // namespace lpq
