// The input with repeated points merged and put into the unit frame, still in the caller's order,
// and the words in which its parts are named to the caller.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "domain/domain.h"

namespace lpq {

/// A loop or a polyline: corners begin .. end-1 of the Outline.
struct Chain {
  Index region = none;  // none: a polyline
  Index number = 0;     // of the loop within its region, or of the polyline
  Index begin = 0, end = 0;
  Index edge_begin = 0, edge_end = 0;  // its edges, in order

  bool is_loop() const { return region != none; }
  Index size() const { return end - begin; }
};

struct Edge {
  Index a, b;  // corners
  Index chain;
};

struct Outline {
  const DomainInput* input = nullptr;
  UnitFrame frame;
  std::vector<Vec2> points;  // #C  corners in the unit frame; isolated points follow the chains
  std::vector<Vec2> given;   // #C  in the caller's units
  std::vector<Index> edge_as_given;  // #C  number of the edge that starts here, or of the point
  std::vector<Index> vertex;         // #C  corners at the same place have the same vertex
  std::vector<Chain> chains;         // loops first
  std::vector<Edge> edges;
  Index vertex_count = 0;
  Index loop_count = 0;
  Index first_point = 0;  // corners from here on are isolated points
  std::vector<Warning> warnings;

  std::span<const Vec2> corners(const Chain& chain) const {
    return {points.data() + chain.begin, static_cast<std::size_t>(chain.size())};
  }
};

/// Checks numbers and counts, merges repeated points, fits the frame. Errors: non_finite, empty,
/// too_large, bad_option (tags that do not fit), bad_size, duplicate_point (strict),
/// lost_precision.
Result<Outline> make_outline(const DomainInput& input, const DomainOptions& options);

/// "edge 3 of loop 0", "edge 0 of polyline 2", with the region where there are several.
std::string edge_name(const Outline& outline, Index edge);
std::string loop_name(const Outline& outline, const Chain& chain);
std::string region_name(const DomainInput& input, Index region);
/// "(1.5, -2)" in the caller's units.
std::string point_text(Vec2 world);

/// Where filled in for an edge, for a pair of edges, and for a loop.
Where where_edge(const Outline& outline, Index edge);
Where where_edges(const Outline& outline, Index edge, Index other);
Where where_loop(const Chain& chain);
/// The same with a point: in the caller's units, but for errors that prepare() takes there from the
/// unit frame (of sample_boundary and make_fields).
Where at_point(Where where, Vec2 point);

}  // namespace lpq
