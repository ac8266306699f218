// Triangles as a file says them, unjudged: what the surface readers hand over and repair takes.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/vec3.h"
#include "mesh/tri_mesh.h"

namespace lpq {

struct SurfaceSoup {
  std::vector<Vec3> points;
  std::vector<Tri> triangles;
  std::vector<Index> group;              // #T  into group_names; empty = all in group 0
  std::vector<std::string> group_names;  // "" = unnamed; none = as many unnamed as group says
  std::vector<double> sizes;             // #points, target length there, 0 = none; empty = none
  std::vector<Index> body;  // #T  into body_names; empty = all one. Nothing joins bodies
  std::vector<std::string> body_names;  // "" = unnamed; none = as many unnamed as body says
  std::vector<Warning> warnings;        // what the file holds and the reader left out
};

struct SoupExtent {
  std::vector<char> used;  // #points  whether a triangle has it
  Index unused = 0;
  double diagonal = 0;  // of the box around the used points
};

/// Errors: empty; parse_error for a corner, a group or a body that is not there (without names, for
/// one beyond the number of triangles); bad_size;
/// non_finite; too_large beyond 1e100 (squares must not overflow); lost_precision for what is too
/// small or large to calculate with. Cost O(#points + #T).
Result<SoupExtent> check_soup(const SurfaceSoup& soup);

}  // namespace lpq
