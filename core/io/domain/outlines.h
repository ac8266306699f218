// Which closed outlines a face lies in, told by all that was drawn along its border.
#pragma once

#include <vector>

#include "base/csr.h"
#include "io/domain/planar_faces.h"

namespace lpq {

/// An edge as one thing drew it.
struct DrawnEdge {
  Index source = none;   // the first one of that name
  Index outline = none;  // as in LineWork::Edge
  bool along = true;     // in the direction of the edge, else against it
};

struct DrawnEdges {
  Csr<DrawnEdge> of_edge;          // the edge itself, then its copies
  std::vector<double> twice_area;  // of outlines; positive: they run counter-clockwise
};

/// Twice the signed area of every closed outline, copies included.
std::vector<double> outline_areas(const LineWork& lines);

/// Of joined lines; first_of_name[s] is the first source with the name of source s. Cost
/// O(n log n).
DrawnEdges drawn_edges_of(const LineWork& lines, const std::vector<Index>& first_of_name);

/// What was drawn around a face, as first sources of their names, each once.
struct Enclosure {
  std::vector<Index> outlines;  // of closed outlines around it that its border shares an edge with,
                                // the smallest first
  std::vector<Index> shared;    // of what drew all of its border
  std::vector<Index> all() const;
};

/// Cost about linear in the edges of the face and what drew them.
Enclosure enclosure_of(const DrawnEdges& drawn, const LineWork& lines, const Walk& face);

}  // namespace lpq
