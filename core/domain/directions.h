// Points in the order in which they are seen around another.
#pragma once

#include "geometry/predicates.h"
#include "geometry/vec.h"

namespace lpq {

/// Whether p comes before q, counter-clockwise from the positive x axis on. Exact; a total order of
/// points that lie in different directions.
struct Counterclockwise {
  Vec2 centre;

  bool operator()(Vec2 p, Vec2 q) const {
    if (is_above(p) != is_above(q)) return is_above(p);
    return orient2d(centre, p, q) > 0;
  }

 private:
  bool is_above(Vec2 p) const { return p.y > centre.y || (p.y == centre.y && p.x > centre.x); }
};

}  // namespace lpq
