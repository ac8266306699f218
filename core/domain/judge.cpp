// The order of the checks is the order in which a person would repair the input: what crosses is
// repaired first, because until then inside and outside mean nothing; then loops that are none;
// then loops in the wrong place; then contacts.
#include "domain/judge.h"

#include <algorithm>
#include <cmath>

#include "base/sort_numbers.h"
#include "domain/meetings.h"
#include "domain/nesting.h"
#include "geometry/polygon.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

Problem judge_crossing(const Outline& outline, const EdgePair& pair) {
  if (!pair.found()) return {};
  const Edge &e = outline.edges[pair.edge], &f = outline.edges[pair.other];
  const Vec2 place = outline.frame.to_world(crossing_point(
      outline.points[e.a], outline.points[e.b], outline.points[f.a], outline.points[f.b]));
  const Index r = outline.chains[e.chain].region, s = outline.chains[f.chain].region;
  const bool regions_overlap = r != s && r != none && s != none;
  return Error{regions_overlap ? ErrorCode::region_conflict : ErrorCode::self_intersection,
               capitalised(edge_name(outline, pair.edge)) + " crosses " +
                   edge_name(outline, pair.other) + " near " + point_text(place) +
                   (regions_overlap ? ". Regions may share whole edges but not overlap."
                                    : ". Edges may meet only at their ends."),
               at_point(where_edges(outline, pair.edge, pair.other), place)};
}

Problem judge_point_counts(const Outline& outline) {
  for (const Chain& chain : outline.chains) {
    std::vector<Index> distinct;
    for (Index c = chain.begin; c < chain.end && distinct.size() < 3; ++c)
      if (std::find(distinct.begin(), distinct.end(), outline.vertex[c]) == distinct.end())
        distinct.push_back(outline.vertex[c]);
    const std::size_t wanted = chain.is_loop() ? 3 : 2;
    if (distinct.size() >= wanted) continue;
    Where where = where_loop(chain);
    if (chain.size() > 0) where = at_point(where, outline.given[chain.begin]);
    const std::string name =
        chain.is_loop() ? loop_name(outline, chain) : "polyline " + std::to_string(chain.number);
    return Error{ErrorCode::too_few_points,
                 capitalised(name) + " has " + std::to_string(distinct.size()) +
                     (distinct.size() == 1 ? " distinct point" : " distinct points") +
                     "; it needs at least " + std::to_string(wanted) + ". Remove it or add points.",
                 where};
  }
  return {};
}

Problem judge_areas(const Outline& outline, const LoopRoles& roles) {
  for (Index l = 0; l < outline.loop_count; ++l) {
    if (roles.orientation[l] != 0) continue;
    const Chain& chain = outline.chains[l];
    return Error{ErrorCode::zero_area,
                 capitalised(loop_name(outline, chain)) +
                     " encloses no area: all of it lies on a line or it runs back over itself.",
                 at_point(where_loop(chain), outline.given[chain.begin])};
  }
  return {};
}

Problem judge_overlap(const Outline& outline, const EdgePair& pair) {
  if (!pair.found()) return {};
  const Edge &e = outline.edges[pair.edge], &f = outline.edges[pair.other];
  // The middle two of the four ends, in order along the line, bound the common piece.
  Index ends[4] = {e.a, e.b, f.a, f.b};
  sort_numbers(ends, [&](Index p, Index q) { return outline.points[p] < outline.points[q]; });
  const Vec2 place = outline.given[ends[1]];
  const Chain &one = outline.chains[e.chain], &two = outline.chains[f.chain];
  const char* cure = ". Remove one of them.";
  if (one.is_loop() != two.is_loop()) {
    cure =
        ". Leave that piece out of the polyline: edges of loops are edges of the mesh anyhow, and "
        "have tags of their own.";
  } else if (one.region != two.region) {
    cure =
        ". Remove one of them, or let both have the same two end points if they bound different "
        "regions.";
  }
  return Error{ErrorCode::overlapping_edges,
               capitalised(edge_name(outline, pair.edge)) + " and " +
                   edge_name(outline, pair.other) + " lie on each other near " + point_text(place) +
                   cure,
               at_point(where_edges(outline, pair.edge, pair.other), place)};
}

Problem judge_touch(const Outline& outline, const EdgePair& pair) {
  if (!pair.found()) return {};
  const Edge &e = outline.edges[pair.edge], &f = outline.edges[pair.other];
  const auto& p = outline.points;
  Index corner = e.a;
  bool on_other = true;
  for (const Index c : {e.a, e.b})
    if (on_segment(p[c], p[f.a], p[f.b])) corner = c;
  for (const Index c : {f.a, f.b}) {
    if (!on_segment(p[c], p[e.a], p[e.b])) continue;
    corner = c;
    on_other = false;
  }
  const Index carrier = on_other ? pair.other : pair.edge;
  const Index guest = on_other ? pair.edge : pair.other;
  const Chain &one = outline.chains[e.chain], &two = outline.chains[f.chain];
  const char* cure = ". Move one of them, so that the loops stay apart.";
  if (!outline.chains[outline.edges[carrier].chain].is_loop()) {
    cure = ". Make this point one of that polyline's, so that both have it.";
  } else if (one.region != two.region) {
    cure = ". Add this point to that edge, so that both have it as a corner.";
  }
  return Error{ErrorCode::touching,
               "An end of " + edge_name(outline, guest) + " touches " +
                   edge_name(outline, carrier) + " at " + point_text(outline.given[corner]) + cure,
               at_point(where_edges(outline, pair.edge, pair.other), outline.given[corner])};
}

Problem judge_shared_corner(const Outline& outline, const EdgePair& pair) {
  if (!pair.found()) return {};
  const Vec2 place = outline.given[outline.edges[pair.edge].a];
  return Error{ErrorCode::touching,
               "The starts of " + edge_name(outline, pair.edge) + " and " +
                   edge_name(outline, pair.other) + " are the same point " + point_text(place) +
                   ". Loops of a region may not touch; move one of the two points.",
               at_point(where_edges(outline, pair.edge, pair.other), place)};
}

LoopRoles measure(const Outline& outline, bool outer_first) {
  LoopRoles roles;
  roles.outer.assign(outline.input->regions.size(), none);
  for (Index l = 0; l < outline.loop_count; ++l) {
    const auto corners = outline.corners(outline.chains[l]);
    roles.orientation.push_back(orientation(corners));
    roles.area.push_back(signed_area(corners));
    Index& outer = roles.outer[outline.chains[l].region];
    if (outer == none || (!outer_first && std::abs(roles.area[l]) > std::abs(roles.area[outer])))
      outer = l;
  }
  return roles;
}

}  // namespace

Result<LoopRoles> judge_loops(const Outline& outline, bool outer_first) {
  const Meetings meetings = find_meetings(outline);
  if (Problem problem = judge_crossing(outline, meetings.crossing)) return *problem;
  if (Problem problem = judge_point_counts(outline)) return *problem;
  LoopRoles roles = measure(outline, outer_first);
  if (Problem problem = judge_areas(outline, roles)) return *problem;
  if (Problem problem = judge_nesting(outline, roles, meetings)) return *problem;
  if (Problem problem = judge_overlap(outline, meetings.overlap)) return *problem;
  if (Problem problem = judge_touch(outline, meetings.touch)) return *problem;
  if (Problem problem = judge_shared_corner(outline, meetings.shared_corner)) return *problem;
  return roles;
}

}  // namespace lpq
