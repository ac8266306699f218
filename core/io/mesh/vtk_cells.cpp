// See vtk_cells.h.
#include "io/mesh/vtk_cells.h"

#include "io/number.h"

namespace lpq {

std::size_t vtk_names_size(const std::vector<std::string>& names) {
  std::size_t size = names.size();
  for (const std::string& name : names) size += name.size();
  return size;
}

void append_vtk_names(std::string& out, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    for (const char c : name) {
      append_integer(out, static_cast<unsigned char>(c == 0 ? '?' : c));
      out += ' ';
    }
    out += "0\n";
  }
}

void append_vtk_points(std::string& out, const OutputMesh& mesh) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Vec3 p = mesh.point(static_cast<Index>(v));
    append_numbers(out, {p.x, p.y, p.z});
    out += '\n';
  }
}

}  // namespace lpq
