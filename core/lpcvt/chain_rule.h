// How Voronoi vertices move with the sites: from dF/dC to dF/dx, one case per kind of vertex
// (paper section 3.2.3 and the two matrices at the end of section 3.2.4).
#pragma once

#include "geometry/vec.h"

namespace lpq {

/// Gradient contributions to the sites that a Voronoi vertex depends on.
struct ThreeSites {
  Vec2 x0, x1, x2;
};
struct TwoSites {
  Vec2 u, v;
};

/// Circumcentre C of x0, x1, x2 (Fig. 15). Equidistance gives, with e_k = x_k - x0,
///   e_k . dC = (C - x0) . dx0 - (C - x_k) . dx_k,   k = 1, 2.
/// Solving the transposed system e_1 l1 + e_2 l2 = dF/dC turns the matrix of the paper into
/// two scalars.
inline ThreeSites circumcentre_gradient(Vec2 x0, Vec2 x1, Vec2 x2, Vec2 C, Vec2 dF_dC) {
  const Vec2 e1 = x1 - x0, e2 = x2 - x0;
  const double inverse = 1 / cross(e1, e2);
  const double l1 = cross(dF_dC, e2) * inverse, l2 = cross(e1, dF_dC) * inverse;
  return {(l1 + l2) * (C - x0), l1 * (x1 - C), l2 * (x2 - C)};
}

/// Crossing C of the bisector of u, v with a wall of direction d (Fig. 16; N = perpendicular to d).
/// C moves along the wall only: dC = d t, (v - u) . dC = (C - u) . du - (C - v) . dv.
inline TwoSites wall_crossing_gradient(Vec2 u, Vec2 v, Vec2 d, Vec2 C, Vec2 dF_dC) {
  const double l = dot(dF_dC, d) / dot(v - u, d);
  return {l * (C - u), l * (v - C)};
}

}  // namespace lpq
