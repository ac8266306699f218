// How far places of the surface lie from a mesh of it, for the size of the quads there.
#pragma once

#include <vector>

#include "base/csr.h"
#include "shell/face_fans.h"
#include "shell/mesh_charts.h"
#include "shell/nearest_triangle.h"

namespace lpq {

struct PlaceToCover {
  SurfacePlace place;
  Vec3 point;
};

/// Vertices, middles of edges longer than .15 of the mesh size there, and points inside triangles
/// with a side longer than .3 of it, about so far apart, in needles on chords across the longest
/// side; none on features, which have nodes of their own. Cost O(#T) and the number of points.
std::vector<PlaceToCover> places_to_cover(const Charted& charted);

class Cover {
 public:
  /// `mesh` must outlive this and stay as it is; it has faces.
  explicit Cover(const ShellMesh& mesh);
  Cover(const Cover&) = delete;
  Cover& operator=(const Cover&) = delete;

  /// A face, and the distance from it in mean lengths of its sides.
  struct Gap {
    Index face = none;
    double distance = 0;
  };
  /// From the face nearest to p; of those around a vertex that is nearest, from that with the
  /// shortest sides. `hint`: any face, best one near p. Cost O(log #F) where hints are good.
  Gap at(Vec3 p, Index hint = 0) const;

 private:
  const ShellMesh& mesh_;
  FaceFans fans_;
  std::vector<Index> fan_of_;  // #F  first triangle of the face
  NearestTriangle nearest_;
  Csr<Index> stars_;          // #V  faces
  std::vector<double> side_;  // #F  mean length of the sides
};

}  // namespace lpq
