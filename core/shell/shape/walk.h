// Straight walks on a triangulated surface: across an edge the next triangle is unfolded into the
// plane of the last, so the way is straight in the plane of the strip (a straightest geodesic
// [PS98], vertices aside), and the end depends on the displacement by a rotation alone: gradients
// come back exactly.
#pragma once

#include <span>
#include <vector>

#include "geometry/vec.h"
#include "shell/shell_mesh.h"
#include "surface/frames.h"

namespace lpq {

struct WalkEnd {
  SurfacePlace place;
  Vec2 turn{1, 0};    // frame of the first triangle, as a complex number in that of the last
  bool whole = true;  // false: stopped early, at a barrier
};

class SurfaceWalker {
 public:
  /// `barrier`: half-edges that are not crossed, besides walls.
  SurfaceWalker(const SurfaceMesh& mesh, std::span<const char> barrier);

  /// From a place by a displacement in the frame of its triangle (frames.h). Ends on the surface in
  /// any case: at a barrier, at a triangle without area, or after very many triangles, it stops.
  /// Cost O(triangles crossed).
  WalkEnd walk(const SurfacePlace& from, Vec2 displacement) const;

 private:
  struct Exit {
    Index corner = none;  // opposite the edge that is reached; none: the end is inside
    double share = 1;     // of the displacement until there
  };
  Exit find_exit(const SurfacePlace& at, Vec2 displacement, Index entered) const;

  const SurfaceMesh& mesh_;
  std::span<const char> barrier_;
  std::vector<TriangleLayout> layout_;  // #T
};

}  // namespace lpq
