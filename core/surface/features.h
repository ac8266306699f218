// The lines that the mesh must follow, the corners it must keep, and the faces between them.
#pragma once

#include <span>
#include <vector>

#include "mesh/surface_mesh.h"
#include "surface/edges.h"

namespace lpq {

struct FeatureOptions {
  double angle = 40;           // degrees between normals from which an edge is sharp; 180: none is
  double hysteresis = 0.6;     // part of the angle from which an edge carries on a sharp chain
  double shortest = 5;         // mesh sizes; shorter chains that do not stand out are noise, and so
                               // are others that have a loose end
  double shortest_loop = 1.5;  // mesh sizes; smaller heaps without loose ends that do not stand out
                               // are noise, except rims
  double shortest_stub = 1;    // mesh sizes; shorter side branches with a loose end are noise
  double corner_angle = 40;    // degrees of turn from which a curve has a corner
  double bend_angle = 70;      // degrees of turn within a mesh size that are a corner, too
  bool groups = true;          // keep the borders between groups of the file
};

/// Hard kinds come last: they are never filtered.
enum class FeatureKind : char { smooth, sharp, marked, group_border, wall };

struct SurfaceFeatures {
  SurfaceEdges edges;
  std::vector<FeatureKind> kind;  // #E
  std::vector<char> corner;       // #V
  std::vector<Index> face;        // #T
  Index face_count = 0;

  bool is_feature(Index edge) const { return kind[edge] != FeatureKind::smooth; }
  bool half_edge_is_feature(Index e) const { return is_feature(edges.edge_of[e]); }
  /// #half-edges: those on features. Cost O(#half-edges).
  std::vector<char> half_edges() const;
  /// Feature edges at every vertex, ascending. Cost O(#E).
  Csr<Index> edges_at_vertices(Index vertex_count) const;
};

/// `size` is the mesh size at each vertex (#V, > 0), here a quarter of the bounding diagonal of
/// what hangs together at most. Cost O(#T log #T).
///
/// Features are
///  - walls, and if asked the borders between groups: hard ones, never dropped;
///  - edges sharp by angle, but for those dropped below;
///  - what goes on straight ahead of a chain that stands out, down to the angle's part `hysteresis`
///    (as edges in pictures [C86]), where it still stands out.
///
/// A chain stands out where it bends much more than the surface beside it, which on scans is about
/// as uneven everywhere (sharp_chains.h), or where one side is flat, as beside the rim of a hole of
/// coarse facets.
///
/// Dropped are, of those sharp by angle,
///  - side branches with a loose end shorter than `shortest_stub`;
///  - chains shorter than `shortest` that do not stand out, and short pieces that have become a
///    long one because branches between them are gone;
///  - in the end, what hangs together with nothing hard and is small altogether: with a loose end
///    shorter than `shortest`, or else not standing out within `shortest_loop`. This last not where
///    it is a rim: a plain closed line of eight edges or more, or of fewer beside a flat side.
///
/// Triangles so flat that their normals are noise, and needles that are nothing beside the mesh,
/// take their normals from their neighbours (normals.h). Where a chain of noise folds back along a
/// needle it becomes one line (needles.h).
///
/// Corners lie
///  - where other than two features meet;
///  - where a curve turns, both at the vertex and between points half a mesh size away;
///  - in the middle of bends that are smaller than the mesh (bends.h);
///  - where the faces along a curve change;
///  - where sheets meet in a point only.
///
/// Faces are connected across edges that are no features, numbered by first triangle.
SurfaceFeatures find_features(const SurfaceMesh& mesh, std::span<const double> size,
                              const FeatureOptions& options = {});

/// The faces between the features, numbered by first triangle. Cost O(#T).
void number_faces(const SurfaceMesh& mesh, SurfaceFeatures& features);

}  // namespace lpq
