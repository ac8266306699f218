// Midpoint subdivision: every triangle becomes three quads through its edge midpoints and its
// centroid. All of them are strictly convex whatever the triangle, so this is the chain of last
// resort: always valid, never pretty. It needs the right to divide the boundary's edges.
#pragma once

#include "domain/boundary.h"
#include "geometry/frame.h"
#include "mesh/quad_mesh.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// The same 1D mesh with a node at the middle of every edge. Edge k becomes edges 2k and 2k+1, its
/// new node is number #B + k. Midpoints are snapped to what the caller's coordinates can hold.
BoundaryMesh halve_edges(const BoundaryMesh& boundary, const UnitFrame& frame);

/// `triangles` is a triangulation of `boundary`; the result's fixed vertices are those of
/// halve_edges(boundary). Pre: every wall of `triangles` is an edge of `boundary`.
QuadMesh subdivide_triangles(const TriMesh& triangles, const BoundaryMesh& boundary,
                             const UnitFrame& frame);

}  // namespace lpq
