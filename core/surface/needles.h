// Features that fold back beside themselves, along the long sides of a triangle as thin as a
// needle.
#pragma once

#include <span>

#include "surface/features.h"

namespace lpq {

/// Where two sides of a needle are sharp, one of them the longest, the mesh would have to fit
/// between them: one line goes along the two shorter sides instead, which pass at next to no
/// distance from the longest. Only where the chain does not stand out from the surface beside it
/// (sharp_chains.h): parts may have such corners. A needle with three sharp sides would be a face
/// of its own, far thinner than its quads: of its shorter sides those stay between whose other
/// faces the surface bends. Hard features stay.
void unfold_needles(const SurfaceMesh& mesh, std::span<const double> size,
                    std::span<const double> angles, const FeatureOptions& options,
                    SurfaceFeatures& features);

}  // namespace lpq
