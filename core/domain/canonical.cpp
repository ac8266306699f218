#include "domain/canonical.h"

#include <algorithm>
#include <utility>

#include "base/few_warnings.h"
#include "base/sort_numbers.h"

namespace lpq {
namespace {

class Canonicaliser {
 public:
  Canonicaliser(const Outline& outline, const LoopRoles& roles)
      : outline_(outline), roles_(roles) {}
  Result<Domain> run();

 private:
  void number_points();
  void number_pairs();
  void collect_tags();
  Problem add_loop(Index chain);
  void warn_of_tag(Index existing, Index edge);
  Problem share(Index existing, Index edge, bool reversed, Index region);
  void add_polylines();
  void add_points();
  Index point_of(Index corner);
  Index tag_of(const std::string& tag) const;
  const std::string& tag_text(Index edge) const;
  Index smallest_corner(const Chain& chain) const;

  const Outline& outline_;
  const LoopRoles& roles_;
  Domain domain_;
  std::vector<Index> point_of_vertex_, rank_of_vertex_;
  std::vector<Index> pair_;          // #edges  the same for edges between the same two vertices
  std::vector<Index> segment_of_;    // #pairs  the segment between these vertices, or none
  std::vector<Index> segment_edge_;  // #S  edge of the outline it came from
  FewWarnings tags_left_out_;
  const std::string no_tag_;
};

const std::string& Canonicaliser::tag_text(Index edge) const {
  const Chain& chain = outline_.chains[outline_.edges[edge].chain];
  if (!chain.is_loop()) return outline_.input->polylines[chain.number].tag;
  const auto& tags = outline_.input->regions[chain.region].tags;
  if (chain.number >= static_cast<Index>(tags.size())) return no_tag_;
  const auto& of_loop = tags[chain.number];
  const Index given = outline_.edge_as_given[outline_.edges[edge].a];
  return given < static_cast<Index>(of_loop.size()) ? of_loop[given] : no_tag_;
}

// Sorted, so that the table does not depend on the order of the loops.
void Canonicaliser::collect_tags() {
  auto& tags = domain_.tags;
  for (Index e = 0; e < static_cast<Index>(outline_.edges.size()); ++e)
    if (const std::string& tag = tag_text(e); !tag.empty() && (tags.empty() || tags.back() != tag))
      tags.push_back(tag);
  for (const DomainInput::Point& point : outline_.input->points)
    if (!point.tag.empty()) tags.push_back(point.tag);
  sort_values(tags);
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
}

Index Canonicaliser::tag_of(const std::string& tag) const {
  if (tag.empty()) return none;
  const auto& tags = domain_.tags;
  return static_cast<Index>(std::lower_bound(tags.begin(), tags.end(), tag) - tags.begin());
}

// The caller's order is that of the corners of the outline; a shared corner counts where it is
// first.
void Canonicaliser::number_points() {
  rank_of_vertex_.assign(outline_.vertex_count, none);
  point_of_vertex_.assign(outline_.vertex_count, none);
  Index rank = 0;
  for (const Index v : outline_.vertex)
    if (rank_of_vertex_[v] == none) rank_of_vertex_[v] = rank++;
}

void Canonicaliser::number_pairs() {
  const auto ends = [this](Index e) {
    return std::minmax(outline_.vertex[outline_.edges[e].a], outline_.vertex[outline_.edges[e].b]);
  };
  const std::vector<Index> order =
      sorted_numbers(outline_.edges.size(), [&](Index e, Index f) { return ends(e) < ends(f); });
  pair_.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || ends(order[i - 1]) != ends(order[i])) segment_of_.push_back(none);
    pair_[order[i]] = static_cast<Index>(segment_of_.size()) - 1;
  }
}

Index Canonicaliser::point_of(Index corner) {
  Index& point = point_of_vertex_[outline_.vertex[corner]];
  if (point != none) return point;
  point = static_cast<Index>(domain_.points.size());
  domain_.points.push_back(outline_.points[corner]);
  domain_.given.push_back(outline_.given[corner]);
  domain_.output_rank.push_back(rank_of_vertex_[outline_.vertex[corner]]);
  domain_.point_tag.push_back(none);
  return point;
}

Index Canonicaliser::smallest_corner(const Chain& chain) const {
  Index best = chain.begin;
  for (Index c = chain.begin + 1; c < chain.end; ++c)
    if (outline_.points[c] < outline_.points[best]) best = c;
  return best;
}

void Canonicaliser::warn_of_tag(Index existing, Index edge) {
  const Index first = segment_edge_[existing];
  const Vec2 place = outline_.given[outline_.edges[edge].a];
  tags_left_out_.add({ErrorCode::ignored,
                      "The tag \"" + tag_text(edge) + "\" of " + edge_name(outline_, edge) +
                          " at " + point_text(place) + " was left out: the same edge is " +
                          edge_name(outline_, first) + ", whose tag \"" +
                          domain_.tags[domain_.segments[existing].tag] + "\" is kept.",
                      at_point(where_edges(outline_, edge, first), place)});
}

Problem Canonicaliser::share(Index existing, Index edge, bool reversed, Index region) {
  Segment& segment = domain_.segments[existing];
  const Edge& e = outline_.edges[edge];
  const bool same_way = segment.a == point_of(reversed ? e.b : e.a);
  Index& side = same_way ? segment.left : segment.right;
  if (side != none) {
    const Index first = segment_edge_[existing];
    const Vec2 place = outline_.given[e.a];
    return Error{ErrorCode::region_conflict,
                 "The regions of " + edge_name(outline_, first) + " and " +
                     edge_name(outline_, edge) + " lie on the same side of their common edge at " +
                     point_text(place) + ". Regions may share edges but not overlap.",
                 at_point(where_edges(outline_, first, edge), place)};
  }
  side = region;
  const std::string& tag = tag_text(edge);
  if (segment.tag == none) segment.tag = tag_of(tag);
  if (!tag.empty() && tag != domain_.tags[segment.tag]) warn_of_tag(existing, edge);
  return {};
}

Problem Canonicaliser::add_loop(Index number) {
  const Chain& chain = outline_.chains[number];
  const bool outer = roles_.outer[chain.region] == number;
  const bool reversed = (roles_.orientation[number] > 0) != outer;
  const Index start = smallest_corner(chain) - chain.begin, n = chain.size();
  domain_.area += (reversed ? -1 : 1) * roles_.area[number];
  for (Index i = 0; i < n; ++i) {
    // Walking backwards, the edge before a corner is the one that leaves it.
    const Index step = reversed ? (start - i - 1 + 2 * n) % n : (start + i) % n;
    const Index edge = chain.edge_begin + step;
    const Edge& e = outline_.edges[edge];
    const Index a = point_of(reversed ? e.b : e.a), b = point_of(reversed ? e.a : e.b);
    if (outline_.input->regions.size() > 1) {
      Index& segment = segment_of_[pair_[edge]];
      if (segment != none) {
        if (auto problem = share(segment, edge, reversed, chain.region)) return problem;
        continue;
      }
      segment = static_cast<Index>(domain_.segments.size());
    }
    domain_.segments.push_back({.a = a,
                                .b = b,
                                .left = chain.region,
                                .right = none,
                                .tag = tag_of(tag_text(edge)),
                                .region = chain.region,
                                .loop = chain.number,
                                .edge = outline_.edge_as_given[e.a],
                                .reversed = reversed});
    segment_edge_.push_back(edge);
  }
  return {};
}

void Canonicaliser::add_polylines() {
  for (Index c = outline_.loop_count; c < static_cast<Index>(outline_.chains.size()); ++c) {
    const Chain& chain = outline_.chains[c];
    for (Index i = chain.edge_begin; i < chain.edge_end; ++i) {
      const Edge& e = outline_.edges[i];
      const Index a = point_of(e.a), b = point_of(e.b);
      domain_.segments.push_back({.a = a,
                                  .b = b,
                                  .tag = tag_of(tag_text(i)),
                                  .loop = chain.number,
                                  .edge = outline_.edge_as_given[e.a]});
    }
  }
}

void Canonicaliser::add_points() {
  for (Index c = outline_.first_point; c < static_cast<Index>(outline_.points.size()); ++c) {
    const Index point = point_of(c);
    domain_.point_tag[point] = tag_of(outline_.input->points[outline_.edge_as_given[c]].tag);
  }
}

Result<Domain> Canonicaliser::run() {
  domain_.frame = outline_.frame;
  for (const DomainInput::Region& region : outline_.input->regions)
    domain_.regions.push_back(region.name);
  collect_tags();
  number_points();
  if (domain_.regions.size() > 1) number_pairs();
  std::vector<Vec2> smallest(outline_.loop_count);
  for (Index l = 0; l < outline_.loop_count; ++l)
    smallest[l] = outline_.points[smallest_corner(outline_.chains[l])];
  const std::vector<Index> order = sorted_numbers(smallest.size(), [&](Index k, Index l) {
    const Index r = outline_.chains[k].region, s = outline_.chains[l].region;
    if (r != s) return r < s;
    if (!(smallest[k] == smallest[l])) return smallest[k] < smallest[l];
    return k < l;
  });
  for (const Index l : order)
    if (auto problem = add_loop(l)) return *problem;
  add_polylines();
  add_points();
  domain_.h = outline_.frame.length_to_frame(outline_.input->h);
  domain_.warnings = outline_.warnings;
  for (Warning& warning : tags_left_out_.take()) domain_.warnings.push_back(std::move(warning));
  return std::move(domain_);
}

}  // namespace

Result<Domain> make_canonical(const Outline& outline, const LoopRoles& roles) {
  return Canonicaliser(outline, roles).run();
}

}  // namespace lpq
