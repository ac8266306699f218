// The cross field of a whole surface: one value z = e^{4 i theta} per triangle, in the triangle's
// frame, compared across edges by parallel transport. Aligned with features and borders only, so
// that quads flow over any cut that is made for another reason.
#pragma once

#include <span>
#include <vector>

#include "geometry/vec.h"
#include "mesh/surface_mesh.h"

namespace lpq {

struct SurfaceSingularity {
  Index vertex = none;
  int index = 0;  // in quarters: +1 = valence-3 vertex, -1 = valence-5 vertex
};

struct SurfaceCrossField {
  std::vector<Vec2> z;  // #T  unit e^{4 i theta} in the frame of surface/frames.h
  std::vector<SurfaceSingularity> singularities;  // by vertex, those inside the surface
};

/// Minimises the sum of w |z_g - r z_f|^2 over edges, z given in triangles that touch a feature
/// (`feature` marks half-edges, both sides; half-edges without twin count as marked); where a
/// component has none, the smoothest field, by inverse iteration [Knoppel et al. 2013]. Then
/// diffusion with renormalisation [Viertel, Osting 2019]. The indices of a closed surface sum to
/// 4 chi, always. Cost: sparse Hermitian factorisations with up to 60,000 unknowns, and O(#T):
/// larger surfaces are solved for by levels (cross_system.h).
SurfaceCrossField solve_surface_cross(const SurfaceMesh& mesh, std::span<const char> feature);

/// e^{4 i (change of angle)} from the frame of e's triangle to that of its twin's: #half-edges,
/// (1, 0) where there is no twin.
std::vector<Vec2> cross_transport(const SurfaceMesh& mesh);

/// Vertices round which z turns, counted by signs alone.
std::vector<SurfaceSingularity> find_surface_singularities(const SurfaceMesh& mesh,
                                                           std::span<const Vec2> z);

}  // namespace lpq
