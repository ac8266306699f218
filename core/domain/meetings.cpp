#include "domain/meetings.h"

#include "domain/edge_pairs.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

class MeetingSearch {
 public:
  explicit MeetingSearch(const Outline& outline) : outline_(outline) {
    found_.on_neighbour.assign(outline.points.size(), 0);
  }
  Meetings run();

 private:
  void compare(Index e, Index f);
  void mark_ends(const Edge& e, const Edge& f);
  void find_shared_corners();
  Vec2 at(Index corner) const { return outline_.points[corner]; }
  Index region_of(const Edge& e) const { return outline_.chains[e.chain].region; }

  const Outline& outline_;
  Meetings found_;
};

EdgePairs pairs_of(const Outline& outline) {
  std::vector<Vec2> place(outline.vertex_count);
  for (std::size_t c = 0; c < outline.points.size(); ++c)
    place[outline.vertex[c]] = outline.points[c];
  std::vector<EdgePairs::Ends> edges;
  edges.reserve(outline.edges.size());
  for (const Edge& e : outline.edges) edges.push_back({outline.vertex[e.a], outline.vertex[e.b]});
  return EdgePairs(place, std::move(edges));
}

void keep_first(EdgePair& kept, Index e, Index f) {
  if (!kept.found() || e < kept.edge || (e == kept.edge && f < kept.other)) kept = {e, f};
}

void MeetingSearch::mark_ends(const Edge& e, const Edge& f) {
  for (const Index c : {e.a, e.b})
    if (on_segment(at(c), at(f.a), at(f.b))) found_.on_neighbour[c] = 1;
  for (const Index c : {f.a, f.b})
    if (on_segment(at(c), at(e.a), at(e.b))) found_.on_neighbour[c] = 1;
}

void MeetingSearch::compare(Index e_index, Index f_index) {
  const Edge& e = outline_.edges[e_index];
  const Edge& f = outline_.edges[f_index];
  const auto& vertex = outline_.vertex;
  const bool same_region = region_of(e) == region_of(f);
  const bool aa = vertex[e.a] == vertex[f.a], ab = vertex[e.a] == vertex[f.b];
  const bool ba = vertex[e.b] == vertex[f.a], bb = vertex[e.b] == vertex[f.b];
  if ((aa && bb) || (ab && ba)) {
    const bool both_loops = region_of(e) != none && region_of(f) != none;
    if (both_loops && !same_region) return;
    keep_first(found_.overlap, e_index, f_index);
    if (same_region) mark_ends(e, f);
    return;
  }
  if (aa || ab || ba || bb) {
    const Index from = aa || ab ? e.a : e.b;
    const Index p = aa || ab ? e.b : e.a;
    const Index q = aa || ba ? f.b : f.a;
    if (!same_direction(at(from), at(p), at(q))) return;
    keep_first(found_.overlap, e_index, f_index);
    if (same_region) mark_ends(e, f);
    return;
  }
  switch (meet(at(e.a), at(e.b), at(f.a), at(f.b))) {
    case Meeting::apart: return;
    case Meeting::crossing: keep_first(found_.crossing, e_index, f_index); return;
    case Meeting::touching: keep_first(found_.touch, e_index, f_index); break;
    case Meeting::overlapping: keep_first(found_.overlap, e_index, f_index); break;
  }
  if (same_region) mark_ends(e, f);
}

// Polylines may share corners with anything; loops of one region may not.
void MeetingSearch::find_shared_corners() {
  std::vector<Index> last(outline_.vertex_count, none);  // edge that starts there, latest region
  for (Index e = 0; e < static_cast<Index>(outline_.edges.size()); ++e) {
    const Edge& edge = outline_.edges[e];
    if (region_of(edge) == none) break;
    Index& earlier = last[outline_.vertex[edge.a]];
    if (earlier != none && region_of(outline_.edges[earlier]) == region_of(edge)) {
      keep_first(found_.shared_corner, earlier, e);
      found_.on_neighbour[edge.a] = found_.on_neighbour[outline_.edges[earlier].a] = 1;
    }
    earlier = e;
  }
}

Meetings MeetingSearch::run() {
  const EdgePairs pairs = pairs_of(outline_);
  for (Index e = 0; e < static_cast<Index>(outline_.edges.size()); ++e) {
    pairs.each_near(e, [&](Index f) {
      if (f > e) compare(e, f);
    });
    if (found_.crossing.found()) break;
  }
  find_shared_corners();
  return std::move(found_);
}

}  // namespace

Meetings find_meetings(const Outline& outline) { return MeetingSearch(outline).run(); }

}  // namespace lpq
