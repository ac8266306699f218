// How faces in space hang together, and what no mesh of a surface may have.
#pragma once

#include <span>
#include <vector>

#include "geometry/vec3.h"
#include "mesh/quad_mesh.h"
#include "mesh/tri_mesh.h"
#include "mesh/validate.h"

namespace lpq {

/// Counted from the faces alone; points that none has do not count.
struct ShellTopology {
  Index components = 0;       // connected across edges
  Index euler = 0;            // #V - #E + #F
  Index border_edges = 0;     // of one face
  Index borders = 0;          // pieces that these form
  Index meeting_edges = 0;    // of three faces or more
  Index one_sided_edges = 0;  // of two that look to opposite sides
  Index pinches = 0;          // vertices where parts meet in the point only
};

/// Cost O(#F log #F).
ShellTopology shell_topology(std::span<const Face> faces);
std::vector<Face> faces_of(std::span<const Tri> triangles);

/// Vertices in one point (within `reach`, see weld_points()), faces with the same vertices: sound
/// in itself, but too coarse for what is there. `body`: #V, or empty for one; different bodies may
/// touch. At most `limit`, with a vertex each. Cost O(#F log #F).
std::vector<Violation> check_places(std::span<const Vec3> points, std::span<const Face> faces,
                                    double reach, std::size_t limit = 10,
                                    std::span<const Index> body = {});

/// Faces with a vertex twice, quads that are not convex, and what check_places() finds at reach 0.
/// At most `limit` are listed; their `vertex` says where. `body`: as there.
std::vector<Violation> validate_faces(std::span<const Vec3> points, std::span<const Face> faces,
                                      std::size_t limit = 10, std::span<const Index> body = {});

/// Does the quad have a corner that turns against the quad's own normal?
bool has_reflex_corner(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

}  // namespace lpq
