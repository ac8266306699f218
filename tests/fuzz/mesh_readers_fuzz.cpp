// Mesh files from bytes: the readers refuse or give indices in range, and what they give can be
// written and read again. Byte 0 chooses the format.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "io/mesh/mesh_format.h"
#include "io/picture/svg.h"

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "mesh readers: %s\n", what);
  std::abort();
}

void check_indices(const lpq::OutputMesh& mesh) {
  const auto points = static_cast<lpq::Index>(mesh.points.size());
  for (const lpq::Face& face : mesh.faces)
    for (int k = 0; k < lpq::corner_count(face); ++k)
      require(face[k] >= 0 && face[k] < points, "face index out of range");
  for (const lpq::Index r : mesh.region)
    require(r >= 0 && r < static_cast<lpq::Index>(mesh.regions.size()), "region out of range");
  for (const lpq::OutputEdge& edge : mesh.edges)
    require(edge.a >= 0 && edge.a < points && edge.b >= 0 && edge.b < points, "edge out of range");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const auto format = data[0] % 2 == 0 ? lpq::MeshFormat::msh : lpq::MeshFormat::obj;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const auto mesh = lpq::read_mesh(text, format);
  if (!mesh) return 0;
  check_indices(*mesh);
  for (const auto version : {lpq::MshVersion::v2_2, lpq::MshVersion::v4_1}) {
    const auto again = lpq::read_msh(lpq::write_msh(*mesh, version));
    require(again.has_value(), "a written mesh cannot be read");
    require(again->faces.size() == mesh->faces.size(), "faces were lost");
    require(again->points.size() == mesh->points.size(), "points were lost");
  }
  lpq::draw_quads(*mesh);
  return 0;
}
