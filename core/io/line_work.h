// Straight lines as drawings have them: pieces that meet in their end points, or nearly so.
#pragma once

#include <span>
#include <vector>

#include "base/index.h"
#include "geometry/vec.h"

namespace lpq {

struct LineWork {
  struct Edge {
    Index a = none, b = none;  // points
    Index source = none;       // of the drawing: which element, segment or entity drew it
  };
  std::vector<Vec2> points;
  std::vector<Edge> edges;

  /// Appends a polyline; closed: with the edge from its last point to its first.
  void add(std::span<const Vec2> polyline, bool closed, Index source);
};

/// What join_ends did. Points are in the drawing's units.
struct Joined {
  Index gaps = 0;  // loose ends moved onto another point
  double largest_gap = 0;
  Vec2 gap_at;
  Index doubled = 0;  // edges dropped because another one joins the same points
  Vec2 doubled_at;
};

/// Makes points at one place one point. Then every loose end - a point of one edge - is moved onto
/// the nearest other point within `tolerance`, unless that is the other end of its own edge.
/// Edges without length vanish; of several edges between the same points the first stays.
/// Cost O(n log n).
Joined join_ends(LineWork& lines, double tolerance);

}  // namespace lpq
