// The faces of line work: which loops of edges enclose something, and which edges enclose nothing.
#pragma once

#include <vector>

#include "io/domain/line_work.h"

namespace lpq {

/// A closed walk or an open chain along edges: edges[i] runs from points[i] to the point after it.
struct Walk {
  std::vector<Index> points, edges;  // a chain has one point more than edges
  Index component = none;            // walks that share a vertex have the same
};

struct PlanarFaces {
  std::vector<Walk> faces;   // the outer walk of every bounded face, counter-clockwise
  std::vector<Walk> outers;  // the outline of every component, clockwise
  std::vector<Walk> chains;  // of edges that have the same face on both sides
};

/// Numbers of the parts that hang together by the edges with used[e], for each point.
std::vector<Index> component_of_points(const LineWork& lines, const std::vector<char>& used);

/// The walks along both sides of every edge.
struct Sides {
  std::vector<Index> walk;     // 2 #E  to the left of edge e at 2 e, to its right at 2 e + 1
  std::vector<char> is_outer;  // #walks  around a component, seen from outside
};

/// Requires the same of the lines as find_faces. Exact; cost O(n log n).
Sides find_sides(const LineWork& lines);

/// Requires points without duplicates and edges as join_points leaves them. Edges that cross are
/// not looked for: whatever comes out then is judged at the door. Exact; cost O(n log n).
PlanarFaces find_faces(const LineWork& lines);

}  // namespace lpq
