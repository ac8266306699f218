// What shape optimisation needs of a surface, made once: where vertices may go, which way is out,
// how large quads are to be.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "shell/place.h"
#include "shell/shape/outside.h"
#include "shell/shape/tracks.h"
#include "shell/shape/walk.h"

namespace lpq {

class ShapeGround {
 public:
  explicit ShapeGround(const Charted& charted)
      : surface(charted.mesh),
        feature_(charted.features.half_edges()),
        size_(charted.size),
        walker(charted.mesh, feature_),
        tracks(charted.mesh, charted.features, charted.size),
        outside(charted.mesh, charted.features, charted.size),
        largest_size(*std::max_element(charted.size.begin(), charted.size.end())) {}
  ShapeGround(const ShapeGround&) = delete;

  double size_at(const SurfacePlace& place) const {
    return lpq::size_at(surface.triangles, place, size_);
  }

  const SurfaceMesh& surface;

 private:
  std::vector<char> feature_;  // #half-edges
  std::span<const double> size_;

 public:
  SurfaceWalker walker;
  Tracks tracks;
  Outside outside;
  double largest_size;
};

}  // namespace lpq
