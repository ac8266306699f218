// Where a surface has features smaller than the mesh size, the mesh cannot have its topology. What
// is known of the place of a failure says where the sizes have to be smaller.
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "shell/mesh_charts.h"

namespace lpq {

/// Why there is no mesh, and where.
struct Fault {
  Error error;
  SurfacePlace place;             // triangle = none: not known
  std::vector<Index> everywhere;  // vertices of the surface that could be to blame
};

/// Makes the sizes smaller near the faults (all over `everywhere` where no place is known, or if
/// `widely`), then limits their growth. False if no fault says where.
bool make_smaller(const SurfaceMesh& mesh, std::span<const Fault> faults, bool widely,
                  double growth, std::span<double> size);

}  // namespace lpq
