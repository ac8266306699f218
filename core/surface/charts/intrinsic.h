// A triangulation known by its edge lengths alone. Flips to Delaunay keep the vertices and the
// surface but make no weight of the cotangent Laplacian negative [Bobenko, Springborn 2007; Fisher
// et al. 2007].
#pragma once

#include <vector>

#include "mesh/surface_mesh.h"
#include "numerics/sparse.h"
#include "surface/charts/part.h"

namespace lpq {

struct Intrinsic {
  Index vertices = 0;
  std::vector<Tri> corners;
  std::vector<Index> twins;
  std::vector<double> length;  // of half-edges, > 0, triangle inequality strict
};

/// The part as it is, holes (all loops but the first) filled by fans round a vertex at their mean;
/// these vertices follow the part's own. All lengths grow a little where some triangle has no
/// height [Sharp, Crane 2020].
Intrinsic intrinsic_of(const SurfaceMesh& mesh, const Part& part);

/// Edge flips until no two angles across an edge exceed half a turn together. Triangles may meet
/// themselves then, and edges may run from a vertex to itself.
void flip_to_delaunay(Intrinsic& surface);

/// Four times the area of the triangle; a little above 0 where it is flat.
double four_areas(const double (&length)[3]);

/// Weight (cot alpha) / 2 of each half-edge, alpha the angle across it: #half-edges.
std::vector<double> half_cotangents(const Intrinsic& surface);
/// Sums of the angles at the vertices: #V.
std::vector<double> angle_sums(const Intrinsic& surface);

}  // namespace lpq
