// Quads that are triangles but for a tiny side: their angles can be good.
#pragma once

#include "cleanup/smooth.h"
#include "shell/shape/patch.h"

namespace lpq {

/// Is a side less than `share` of the longest one of the face?
bool has_short_side(const ShellMesh& mesh, Index f, double share);

/// Where a quad has a side of less than a twentieth of its longest, it and those around it go where
/// their mean ratios are best, which see sides as well as angles. Only where the surface bends
/// little and no quad is tangled, if all such sides there grow to that length, and no quad gets
/// poor or worse than the worst one was: in a strip that is narrow for the size they cannot.
/// Cost O(1) for each such quad, beside O(#F). All that is given must stay until the end.
class SideLengthener {
 public:
  SideLengthener(const ShapeGround& ground, const SmoothOptions& options, ShellMesh& mesh,
                 std::vector<VertexRole>& roles)
      : ground_(ground), options_(options), mesh_(mesh), roles_(roles), stars_(mesh) {}

  /// The next of these quads; false if there is none.
  bool step();
  Index places() const { return places_; }  // where sides grew

 private:
  const ShapeGround& ground_;
  const SmoothOptions& options_;
  ShellMesh& mesh_;
  std::vector<VertexRole>& roles_;
  const FaceStars stars_;
  Index next_ = 0;  // face
  Index places_ = 0;
};

}  // namespace lpq
