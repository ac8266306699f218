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
    // Outlines that crossed: which of them, numbered as they hang together, end their paint here.
    // It lies to the left, none to the right.
    Index painted = none;
    Index outline = none;  // of a closed polyline: which one; it runs from a to b
    double bow = 0;        // the curve it stands for passes its middle this far to the left
  };
  std::vector<Vec2> points;
  std::vector<char> loose;  // #points, or empty: the point may be moved; it is of an open polyline
  std::vector<Edge> edges;
  std::vector<Edge> copies = {};  // what join_points dropped: each joins the points of another one

  /// Appends a polyline; closed: with the edge from its last point to its first. `bows` are those
  /// of its edges; where there are no more they are straight.
  void add(std::span<const Vec2> polyline, bool closed, Index source,
           std::span<const double> bows = {});
};

/// Where an edge is to be divided.
struct Stop {
  Index edge = none;
  double way = 0;  // along it; what ascends from its start to its end
  Index point = none;
};

/// Divides edges at their stops, given in any order; the pieces are alike but for their ends.
void divide_edges(LineWork& lines, std::vector<Stop> stops);

/// Makes points at one place one point, the first; what is loose only where all were stays so.
void merge_equal_points(LineWork& lines);

/// What join_points did. Points are in the drawing's units.
struct Joined {
  Index moved = 0;  // points moved onto another point
  double farthest = 0;
  Vec2 moved_at;     // the one moved farthest, where it was
  Index landed = 0;  // points at which an edge was divided that passes them
  double farthest_landed = 0;
  Vec2 landed_at;     // the one farthest from its edge
  Index doubled = 0;  // edges dropped because another one joins the same points
  Vec2 doubled_at;
};

/// Makes points at one place one point. Then every loose point is moved onto the nearest other
/// point within `tolerance` that no edge joins it to, and others where rounding (1e-4 of it) is all
/// that is between them: ends meet, and curves drawn twice fall
/// together, but short edges stay; edges are divided where others end on them (line_landings.h; not
/// with tolerance 0). Edges without length vanish; of several edges between the same points the
/// first stays, and the others are kept as copies. Cost O(n log n).
Joined join_points(LineWork& lines, double tolerance);

}  // namespace lpq
