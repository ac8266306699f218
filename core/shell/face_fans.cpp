// See face_fans.h.
#include "shell/face_fans.h"

namespace lpq {

FaceFans face_fans(const ShellMesh& mesh) {
  FaceFans fans;
  fans.points = mesh.points;
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f) {
    const Face& face = mesh.faces[f];
    const int n = corner_count(face);
    const auto middle = static_cast<Index>(fans.points.size());
    Vec3 centre{};
    for (int k = 0; k < n; ++k) {
      centre += (1.0 / n) * mesh.points[face[k]];
      fans.triangles.push_back({face[k], face[(k + 1) % n], middle});
      fans.face.push_back(f);
    }
    fans.points.push_back(centre);
  }
  return fans;
}

}  // namespace lpq
