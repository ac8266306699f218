// The domain as judged at the door: after make_domain nothing about it can be wrong any more.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/frame.h"
#include "geometry/vec.h"

namespace lpq {

using Loop = std::vector<Vec2>;  // closed; the first point may be repeated at the end

/// What a reader or a caller hands over, unjudged, in the caller's units.
struct DomainInput {
  struct Region {
    std::string name;
    std::vector<Loop> loops;  // any order, any orientation; largest area = outer
    std::vector<std::vector<std::string>>
        tags;  // none, or per loop none or one per edge; "" = untagged
  };
  struct Polyline {
    std::vector<Vec2> points;  // inside the domain; its edges become mesh edges
    std::string tag;
  };
  struct Point {
    Vec2 position;  // inside the domain; becomes a mesh vertex
    std::string tag;
  };
  struct SizeAt {
    Vec2 position;
    double h = 0;
  };
  using Guide = std::vector<Vec2>;
  std::vector<Region> regions;  // one unnamed region for a plain {loops}
  std::vector<Polyline> polylines;
  std::vector<Point> points;
  double h = 0;               // mesh size that came with the domain, 0 = none
  std::vector<SizeAt> sizes;  // target sizes at points
  std::vector<Guide> guides;  // strokes whose direction the quads follow; no edges of the mesh
  std::vector<Vec2> seeds;    // interior points to start L_p from; empty = the method chooses
};

struct DomainOptions {
  bool strict = false;  // repeated consecutive points are an error instead of merged with a warning
  bool outer_first = false;  // the first loop of a region is its outer loop, not the largest one
};

/// A piece of the planar straight-line graph, directed; `none` on a side means outside the domain.
struct Segment {
  Index a = none, b = none;                       // points
  Index left = none, right = none;                // regions on either side
  Index tag = none;                               // into Domain::tags
  Index region = none, loop = none, edge = none;  // as given; without region: polyline `loop`
  bool reversed = false;                          // the caller gave it from b to a
};

/// Canonical: the same arrays whatever loop order, orientation or start the caller chose.
/// Points are in the unit frame, exactly; `given` keeps the caller's own bits.
struct Domain {
  UnitFrame frame;
  std::vector<Vec2> points;          // #P  unit frame; loop points, then polylines, then points
  std::vector<Vec2> given;           // #P  the same points in the caller's units, bit for bit
  std::vector<Index> output_rank;    // #P  position of this point in the caller's order
  std::vector<Segment> segments;     // #S  loop segments have their region on the left
  std::vector<Index> point_tag;      // #P  into tags, none = untagged
  std::vector<std::string> regions;  // #R  names as given
  std::vector<std::string> tags;     // edge and point tags
  double area = 0;                   // unit frame, holes subtracted
  double h = 0;                   // the size that came with the input in the unit frame, 0 = none
  std::vector<Warning> warnings;  // every repair made at the door
};

/// Judges and canonicalises the input. Finite, simple, disjoint loops with holes strictly inside,
/// regions that only share whole edges, polylines and points strictly inside.
/// Errors: see ErrorCode; `where` names loops and edges as given. Cost about n log n
/// for n segments.
Result<Domain> make_domain(const DomainInput& input, const DomainOptions& options = {});

}  // namespace lpq
