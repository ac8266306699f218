// The target edge length at the vertices of a surface: a constant or the caller's values, less
// where the surface or its features bend, and never growing faster than asked.
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "mesh/surface_mesh.h"

namespace lpq {

struct SurfaceSizeOptions {
  double size = 0;                  // constant target; 0 = only what follows
  std::vector<double> at_vertices;  // #V or empty; wins over size, 0 = no value at that vertex
  double largest_turn = 0;          // radians an edge may turn the normal by; 0 = not asked for
  double least = 0;                 // bending asks for nothing smaller
  double growth = 0.3;              // largest slope of the size along edges; > 0
};

/// #V, > 0. Curvature is that of second_forms() and of the polylines that features and borders make
/// (`feature` marks half-edges, both sides). With r the radius of curvature, a chord that turns by
/// phi is 2 r sin(phi / 2) long. No size is more than .7 of the diagonal of what hangs together.
/// Errors: bad_size where an option is out of range or no size is left anywhere.
/// Cost O(#V log #V).
Result<std::vector<double>> surface_sizes(const SurfaceMesh& mesh, std::span<const char> feature,
                                          const SurfaceSizeOptions& options);

/// Lowers h so that |h_i - h_j| <= growth |x_i - x_j| along every edge; infinite values are filled.
void limit_surface_growth(const SurfaceMesh& mesh, double growth, std::span<double> h);

/// Lowers h to this share of the bounding diagonal of what hangs together. Cost O(#T).
void limit_to_parts(const SurfaceMesh& mesh, double share, std::span<double> h);

/// Integral of dA / h^2: the number of quads that fit.
double surface_capacity(const SurfaceMesh& mesh, std::span<const double> h);

}  // namespace lpq
