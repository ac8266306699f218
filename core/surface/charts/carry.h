// Fields of the surface as a chart sees them in its plane.
#pragma once

#include <span>
#include <vector>

#include "geometry/vec.h"
#include "surface/charts/charts.h"

namespace lpq {

/// Crosses turned by the rotation that is nearest to the map of their triangle: e^{4 i theta} in
/// the plane, #T of the chart. `z`: #T of the surface, in the frames of surface/frames.h.
std::vector<Vec2> crosses_in_plane(const SurfaceMesh& mesh, const Chart& chart,
                                   std::span<const Vec2> z);

/// What maps that are not conformal do to lengths: the Beltrami coefficients of their inverses, #T
/// of the chart. A direction d of the plane is along stretched(d, mu) (field/field.h) on the
/// surface, turned by the same rotation back.
std::vector<Vec2> stretches_in_plane(const SurfaceMesh& mesh, const Chart& chart);

/// h lambda at the chart's vertices, lambda the mean scale of the triangles there by area. `h`: #V
/// of the surface.
std::vector<double> sizes_in_plane(const SurfaceMesh& mesh, const Chart& chart,
                                   std::span<const double> h);

}  // namespace lpq
