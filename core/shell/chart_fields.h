// The fields of a surface as one chart's plane sees them: directions turned by the map, sizes
// scaled by it (paper section 5: h_uv = h lambda).
#pragma once

#include <span>

#include "field/field.h"
#include "mesh/surface_mesh.h"
#include "surface/charts/charts.h"
#include "surface/cross_field.h"

namespace lpq {

/// On the chart's own triangles. `size` is the target at the vertices of the surface, in space.
Fields chart_fields(const SurfaceMesh& mesh, const SurfaceCrossField& cross,
                    std::span<const double> size, const Chart& chart);

}  // namespace lpq
