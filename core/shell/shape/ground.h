// What shape optimisation needs of a surface, made once: where vertices may go, which way is out,
// how large quads are to be.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "shell/shape/outside.h"
#include "shell/shape/tracks.h"
#include "shell/shape/walk.h"

namespace lpq {

class ShapeGround {
 public:
  explicit ShapeGround(const Charted& charted)
      : surface(charted.mesh),
        feature_(half_edges_on(charted.features)),
        size_(charted.size),
        walker(charted.mesh, feature_),
        tracks(charted.mesh, charted.features, charted.size),
        outside(charted.mesh, charted.features),
        largest_size(*std::max_element(charted.size.begin(), charted.size.end())) {}
  ShapeGround(const ShapeGround&) = delete;

  double size_at(const SurfacePlace& place) const {
    double h = 0;
    for (int k = 0; k < 3; ++k) h += place.weight[k] * size_[surface.triangles[place.triangle][k]];
    return h;
  }

  const SurfaceMesh& surface;

 private:
  static std::vector<char> half_edges_on(const SurfaceFeatures& features) {
    std::vector<char> on(features.edges.edge_of.size());
    for (std::size_t e = 0; e < on.size(); ++e)
      on[e] = features.half_edge_is_feature(static_cast<Index>(e));
    return on;
  }

  std::vector<char> feature_;  // #half-edges
  std::span<const double> size_;

 public:
  SurfaceWalker walker;
  Tracks tracks;
  Outside outside;
  double largest_size;
};

}  // namespace lpq
