// Places on a surface for points that are known to be near some of its vertices.
#pragma once

#include <span>
#include <vector>

#include "base/csr.h"
#include "mesh/surface_mesh.h"
#include "shell/shell_mesh.h"

namespace lpq {

/// Unlike the nearest of all triangles, what is found is on the same sheet.
class NearbyPlaces {
 public:
  /// `face` of triangles. Both must outlive this.
  NearbyPlaces(const SurfaceMesh& mesh, std::span<const Index> face);

  /// Among triangles of this face (of any, if none of it is around), first those around the given
  /// vertices, then those around the nearest so far, as long as they get nearer to p. Cost: that of
  /// the triangles around the way.
  SurfacePlace nearest(Vec3 p, Index face, std::span<const Index> vertices) const;

 private:
  struct Best {
    Index triangle = none;
    Vec3 point;
    double squared_distance = 0;
  };
  bool look_around(Vec3 p, Index face, std::span<const Index> vertices, Best& best) const;
  SurfacePlace place_of(const Best& best) const;

  const SurfaceMesh& mesh_;
  std::span<const Index> face_;  // #T
  Csr<Index> around_;            // #V  triangles, ascending
};

}  // namespace lpq
