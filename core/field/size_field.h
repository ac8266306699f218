// The size field h on the background: from the walls inward, and never steeper than asked.
#pragma once

#include <span>
#include <vector>

#include "domain/boundary.h"
#include "domain/size_cones.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// Harmonic log h with the boundary's spacing as Dirichlet data (nodes of spacing 0 are free):
/// within the walls' range everywhere. Solved relative to the smallest spacing, so that scaling by
/// powers of two scales the result exactly. Cost: one sparse Cholesky factorisation.
std::vector<double> harmonic_size(const TriMesh& mesh, const BoundaryMesh& boundary);

/// Lowers h to at most the boundary's spacing at its nodes.
void limit_by_walls(const BoundaryMesh& boundary, std::span<double> h);

/// From a point to the triangle it is in (0), or beside.
double distance_to_triangle(const TriMesh& mesh, Index t, Vec2 p);

/// Lowers h to what sizes at points ask for. Each value holds in its triangle, so that sampling
/// there returns it. Outside the domain, where nothing is meshed, a size grows on its way in. What
/// grows no faster than `growth` is left to limit_growth; else a cone reaches where a path through
/// the mesh below it goes. Cost O(#reached log).
void limit_by_cones(const TriMesh& mesh, std::span<const SizeCone> cones, double growth,
                    std::span<double> h);

/// Lowers h so that |h_i - h_j| <= growth |x_i - x_j| along every edge; infinite values are filled.
/// Sizes spread in increasing order (Dijkstra), ties by index. Cost O(#V log #V).
void limit_growth(const TriMesh& mesh, double growth, std::span<double> h);

}  // namespace lpq
