// Constrained Delaunay triangulation of a 1D mesh and interior points, and its repair when the
// points move a little (the optimiser's inner loop).
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "domain/boundary.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// Plain Delaunay triangulation of distinct points (convex hull, no constraints; region all 0; no
/// vertex is free, since any may be on the hull).
/// Errors: duplicate_point, zero_area (all collinear), too_few_points. Cost O(n log n).
Result<TriMesh> triangulate(std::span<const Vec2> points);

/// Constrained Delaunay triangulation of the boundary's nodes and edges plus interior points,
/// outside and holes carved away, walls on every boundary edge, regions labelled.
/// Vertices: boundary nodes first, then `interior` in order. Interior points must be strictly
/// inside the domain and distinct from every other point.
/// Errors: duplicate_point, hole_outside (an interior point outside the domain or on a wall); for a
/// boundary that no make_domain has judged also touching, self_intersection, zero_area,
/// too_few_points.
Result<TriMesh> triangulate(const BoundaryMesh& boundary, std::span<const Vec2> interior);

enum class UpdateStatus {
  flipped,        // repaired by flips only
  needs_rebuild,  // some triangle is inverted or degenerate at the new positions: mesh unspecified
};

struct UpdateResult {
  UpdateStatus status = UpdateStatus::flipped;
  Index flips = 0;
};

/// Scratch memory of update(); keep one beside the mesh to save an allocation per call.
struct UpdateWorkspace {
  std::vector<Index> suspects;  // half-edges whose circle may have become occupied
};

/// Moves the free vertices (index >= mesh.fixed) to `interior` and restores the constrained
/// Delaunay property by flips. For points in general position the result equals a rebuild.
UpdateResult update(TriMesh& mesh, std::span<const Vec2> interior,
                    UpdateWorkspace* workspace = nullptr);

/// Puts triangles in a canonical order with a canonical first corner, so that two triangulations
/// can be compared byte for byte.
TriMesh canonical(TriMesh mesh);

/// Vertex order along a Hilbert curve: `order[k]` is the k-th point. Ties by index.
std::vector<Index> hilbert_order(std::span<const Vec2> points);

}  // namespace lpq
