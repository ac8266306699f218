// See ply.h.
#include "io/mesh/ply.h"

#include "io/escape.h"
#include "io/mesh/output_parts.h"
#include "io/mesh/region_groups.h"
#include "io/mesh/vtk_cells.h"
#include "io/number.h"

namespace lpq {
namespace {

void append_comments(std::string& out, const OutputMesh& mesh, const RegionGroups& groups) {
  constexpr std::size_t longest_name = 120;  // readers have lines of 255 bytes
  for (Index g = 0; g < groups.count() && !mesh.regions.empty(); ++g) {
    out += "comment region ";
    append_integer(out, g);
    out += " = ";
    append_quoted_ascii(out, region_label(mesh, groups.first(g)), longest_name);
    out += '\n';
  }
}

/// One number of corners after the other: some readers match properties to faces only then.
void append_faces(std::string& out, const OutputMesh& mesh, const RegionGroups& groups,
                  int corners) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (corner_count(mesh.faces[f]) != corners) continue;
    append_integer(out, corners);
    for (int k = 0; k < corners; ++k) {
      out += ' ';
      append_integer(out, mesh.faces[f][k]);
    }
    out += ' ';
    append_integer(out, groups.of(mesh.region[f]));
    out += '\n';
  }
}

}  // namespace

std::string write_ply(const OutputMesh& mesh) {
  std::string out = "ply\nformat ascii 1.0\ncomment lpquad\n";
  const RegionGroups groups = region_groups(mesh);
  append_comments(out, mesh, groups);
  out += "element vertex ";
  append_integer(out, static_cast<std::int64_t>(mesh.points.size()));
  out += "\nproperty double x\nproperty double y\nproperty double z\nelement face ";
  append_integer(out, static_cast<std::int64_t>(mesh.faces.size()));
  out += "\nproperty list uchar int vertex_indices\nproperty int region\nend_header\n";
  append_vtk_points(out, mesh);
  for (const int corners : {4, 3}) append_faces(out, mesh, groups, corners);
  return out;
}

}  // namespace lpq
