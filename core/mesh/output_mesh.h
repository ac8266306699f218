// The mesh as it leaves the library: the caller's units, the caller's names, in the plane or on a
// surface, whose faces are the regions and whose features are the edges. Everything a writer
// needs is in here, so a file format never has to ask where the mesh came from.
#pragma once

#include <string>
#include <vector>

#include "geometry/vec3.h"
#include "mesh/quad_mesh.h"

namespace lpq {

/// An edge of the 1D mesh: of the outer boundary, a hole, a region border or an inner polyline.
struct OutputEdge {
  Index a = none, b = none;         // points, directed as the domain is: its region on the left
  Index left = none, right = none;  // regions on either side; none = outside the domain
  Index tag = none;                 // into `tags`, none = untagged
  Index region = none, loop = none, edge = none;  // as given; without region: polyline `loop`
};

/// A mesh vertex that the caller tagged.
struct OutputPoint {
  Index point = none;  // into `points`
  Index tag = none;    // into `tags`
};

struct OutputMesh {
  std::vector<Vec2> points;       // #V  in the caller's units; given points bit for bit
  std::vector<double> z;          // #V  heights; empty for a mesh in the plane
  std::vector<Face> faces;        // #F  counter-clockwise; slot 3 is none for a triangle
  std::vector<Index> region;      // #F  into `regions`
  std::vector<OutputEdge> edges;  // #E  the 1D mesh, each edge once
  std::vector<OutputPoint> tagged_points;
  std::vector<std::string> regions;  // #R  names as given, "" = unnamed
  std::vector<std::string> tags;     // names of edge and point tags
  Index fixed = 0;                   // points 0 .. fixed-1 are those of the 1D mesh

  bool in_space() const { return !z.empty(); }
  Vec3 point(Index v) const {
    const auto i = static_cast<std::size_t>(v);
    return {points[i].x, points[i].y, in_space() ? z[i] : 0};
  }
};

}  // namespace lpq
