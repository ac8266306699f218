// The curves that features form, and their 1D mesh: made once, shared by every face beside them.
#pragma once

#include <span>
#include <vector>

#include "base/csr.h"
#include "base/result.h"
#include "surface/features.h"

namespace lpq {

/// Features from corner to corner, and closed loops without a corner. In order of their first
/// vertex; loops come last.
struct SurfaceCurves {
  Csr<Index> vertices;        // #C  along the curve; a closed one ends with its first vertex
  Csr<Index> edges;           // #C  of SurfaceFeatures::edges, one fewer than vertices
  Csr<Index> faces;           // #C  on each side, ascending; a face on both sides is there twice
  Csr<Index> at_face;         // #F  curves around each face and inside, ascending
  std::vector<char> is_loop;  // #C  closed, without a corner

  Index count() const { return vertices.rows(); }
};

/// Every feature edge is on exactly one curve. Cost O(#T).
SurfaceCurves trace_curves(const SurfaceMesh& mesh, const SurfaceFeatures& features);

/// Where a node of the 1D mesh lies, so that it can be found again.
struct CurvePlace {
  Index vertex = none;  // of the surface, for corners; else
  Index curve = none;   //   on this curve
  Index edge = none;    //   from its vertex `edge` to the next
  double t = 0;         //   in [0, 1): point = (1 - t) a + t b
};

struct CurveMesh {
  std::vector<Vec3> points;           // #N  corners of the surface first, ascending; then by curve
  std::vector<CurvePlace> places;     // #N
  std::vector<Index> node_of_corner;  // #V  none at other vertices
  Csr<Index> nodes;                   // #C  along the curve; a closed one ends with its first node
};

/// Divides every curve into equal steps of int ds/h, with 1/h linear along each edge between its
/// vertices. A curve gets the nearest number of edges to that, a closed one an even number, at
/// least four, or six round a narrow ring; a fifth or so more or fewer where opposite sides of a
/// face then have the same; and where a face still has an odd number of edges around it, curves
/// that bear it best get one more or fewer, so that an all-quad mesh of every face exists
/// (4 Q = 2 E - B). Of curves with the same two ends only one may be a single edge. Nodes lie on
/// the curve's edges exactly. `size`: of each vertex, #V. Errors: bad_size; too_many_elements. Cost
/// O(#V + #N + #C log #C).
Result<CurveMesh> mesh_curves(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                              const SurfaceCurves& curves, std::span<const double> size);

}  // namespace lpq
