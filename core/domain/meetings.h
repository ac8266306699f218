// Which edges of an outline meet other than at the joints of their own chain.
#pragma once

#include <vector>

#include "base/index.h"
#include "domain/outline.h"

namespace lpq {

struct EdgePair {
  Index edge = none, other = none;
  bool found() const { return edge != none; }
};

/// The first of each kind in the caller's order; two edges that are one and the same in different
/// regions are no finding.
struct Meetings {
  EdgePair crossing;
  EdgePair overlap;
  EdgePair touch;                  // an end of one strictly inside the other
  EdgePair shared_corner;          // two corners of one region at the same place
  std::vector<char> on_neighbour;  // #C  the corner lies on another loop, or again on its own
};

/// Exact, about n log n for n edges. Ends early once a crossing is found.
Meetings find_meetings(const Outline& outline);

}  // namespace lpq
