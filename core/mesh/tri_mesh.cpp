#include "mesh/tri_mesh.h"

namespace lpq {

std::vector<Index> outgoing_half_edges(const TriMesh& mesh) {
  std::vector<Index> out(mesh.points.size(), none);
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    Index& slot = out[mesh.origin(e)];
    if (slot == none || mesh.twins[e] == none) slot = e;
  }
  return out;
}

}  // namespace lpq
