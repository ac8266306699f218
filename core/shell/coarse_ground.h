// A surface with very many triangles to a quad makes windows slow and no better: a coarser one
// stands in for it while seams are remeshed.
#pragma once

#include <span>
#include <vector>

#include "shell/mesh_charts.h"
#include "surface/coarsen.h"

namespace lpq {

/// Whether the surface has so many triangles, and so many of them to a quad, that it is worth it.
bool wants_coarse_ground(const Charted& charted);

class CoarseGround {
 public:
  /// What `fine` refers to must outlive this. Cost O(#T log #T).
  explicit CoarseGround(const Charted& fine);
  CoarseGround(const CoarseGround&) = delete;
  CoarseGround& operator=(const CoarseGround&) = delete;

  /// The same on the coarse surface, with its features, faces, crosses and sizes; the charts are
  /// still those of the fine one. Refers to this.
  Charted charted() const;
  /// Gives the vertices places on the coarse surface; their points stay.
  void lower(ShellMesh& mesh) const;
  /// Back: free vertices go to the fine surface, pinned ones, of which there are the same in the
  /// same order, to their places in the mesh `before` it was lowered.
  void raise(const ShellMesh& before, ShellMesh& mesh) const;

 private:
  void carry_crosses();

  Charted fine_;
  CoarseSurface coarse_;
  SurfaceFeatures features_;
  SurfaceCrossField cross_;
  std::vector<double> size_;  // #V of the coarse surface
};

}  // namespace lpq
