// The surface at a face of a mesh on it, on the face's own side of features: which way is out, how
// much it bends there, whether the face looks the same way, and in which triangle its corners lie.
#pragma once

#include <span>
#include <vector>

#include "base/csr.h"
#include "shell/nearest_triangle.h"
#include "shell/shell_mesh.h"
#include "surface/features.h"

namespace lpq {

class Outside {
 public:
  Outside(const SurfaceMesh& surface, const SurfaceFeatures& features,
          std::span<const double> size);

  /// Of length one: the mean of the surface's normals at the corners of face f. Zero where these
  /// cancel.
  Vec3 at(const ShellMesh& mesh, Index f) const;
  /// Length of that mean: 1 where the surface is flat, less the more it bends from corner to
  /// corner.
  double flatness(const ShellMesh& mesh, Index f) const;
  /// A quad that looks against the surface: by the mean normal at its corners where that says all;
  /// where the surface bends, or is thinner than the quad, so that its corners may lie on two sides
  /// of it, by the surface nearest to it at most of five points. Cost O(log #T) there.
  bool is_turned(const ShellMesh& mesh, Index f) const;
  /// Those of them that look against the nearest of their own face of the surface, ascending: a
  /// wall of another body may be in the same place. Cost O(#F + #T log #T).
  std::vector<Index> turned_quads(const ShellMesh& mesh) const;

  /// The same place in that triangle of this face of the surface which lies most in direction `way`
  /// from it; as it is if there is none there.
  SurfacePlace on_side(const SurfacePlace& place, Index face, Vec3 way) const;

 private:
  template <class Visit>
  void for_each_triangle_at(const SurfacePlace& place, Visit&& visit) const;
  Vec3 mean_normal(const ShellMesh& mesh, Index f) const;
  struct Sheet {
    const NearestTriangle& nearest;
    std::span<const Index> triangles = {};  // of the surface; empty: all
  };
  bool looks_away(const ShellMesh& mesh, Index f, const Sheet& sheet) const;
  bool looks_away(Vec3 p, Vec3 normal, Index hint, const Sheet& sheet) const;

  const SurfaceMesh& surface_;
  const SurfaceFeatures& features_;
  std::vector<Vec3> normal_;  // #T
  Csr<Index> triangles_;      // #V of the surface  around it
  NearestTriangle nearest_;
};

}  // namespace lpq
