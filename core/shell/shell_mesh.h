// A quad mesh on a surface: flat arrays as everywhere, with the place of every vertex on the
// surface it came from.
#pragma once

#include <string>
#include <vector>

#include "geometry/vec3.h"
#include "mesh/quad_mesh.h"

namespace lpq {

/// A point of the surface: in a triangle, by the weights of its corners.
struct SurfacePlace {
  Index triangle = none;
  double weight[3] = {0, 0, 0};
};

/// What a vertex lies on, and so where it may go.
enum class Pin : char {
  free,    // over the surface
  line,    // along a feature or border
  corner,  // nowhere
};

struct ShellMesh {
  std::vector<Vec3> points;                 // #V  nodes of the curves first
  std::vector<SurfacePlace> places;         // #V
  std::vector<Face> faces;                  // #F  counter-clockwise seen from outside
  std::vector<Index> face;                  // #F  face of the surface, between features
  std::vector<Pin> pins;                    // #V
  std::vector<std::array<Index, 2>> edges;  // #E  edges on features and borders, a < b, sorted
  // #E  faces that the surface has there: beside a -> b, and beside b -> a
  std::vector<std::array<Index, 2>> sides;

  bool is_free(std::size_t v) const { return pins[v] == Pin::free; }
};

/// Sweeps out faces without corners and the vertices that are not `kept` (#V); the order of the
/// others stays. Returns their new numbers; none: gone.
std::vector<Index> sweep(ShellMesh& mesh, const std::vector<char>& kept);

}  // namespace lpq
