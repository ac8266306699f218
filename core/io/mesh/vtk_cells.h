// What VTK's two file formats share: the mesh as one list of cells, names as numbers.
#pragma once

#include <string>
#include <vector>

#include "io/mesh/region_groups.h"
#include "mesh/output_mesh.h"

namespace lpq {

// Cell types of VTK (vtkCellType.h); SU2 uses the same numbers.
inline constexpr int vtk_vertex = 1, vtk_line = 3, vtk_triangle = 5, vtk_quad = 9;

struct VtkCell {
  int type = 0;
  int count = 0;  // of points
  Face points{none, none, none, none};
  Index region = none, tag = none;  // groups of regions
  Index face = none;                // of the mesh, where the cell is one
};

inline std::size_t vtk_cell_count(const OutputMesh& mesh) {
  return mesh.faces.size() + mesh.edges.size() + mesh.tagged_points.size();
}

/// Calls visit(VtkCell) for the faces, which have no tag; then for the 1D mesh, with the region on
/// its left (right, where the left is outside); then for the tagged points, without a region.
template <class Visit>
void each_vtk_cell(const OutputMesh& mesh, Visit&& visit) {
  const RegionGroups groups = region_groups(mesh);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const int count = corner_count(mesh.faces[f]);
    visit(VtkCell{count == 4 ? vtk_quad : vtk_triangle, count, mesh.faces[f],
                  groups.of(mesh.region[f]), none, static_cast<Index>(f)});
  }
  for (const OutputEdge& edge : mesh.edges) {
    visit(VtkCell{vtk_line,
                  2,
                  {edge.a, edge.b, none, none},
                  groups.of(edge.left != none ? edge.left : edge.right),
                  edge.tag});
  }
  for (const OutputPoint& point : mesh.tagged_points)
    visit(VtkCell{vtk_vertex, 1, {point.point, none, none, none}, none, point.tag});
}

/// The bytes of each name as numbers, a zero after each name.
std::size_t vtk_names_size(const std::vector<std::string>& names);
void append_vtk_names(std::string& out, const std::vector<std::string>& names);

/// x y z, one point a line.
void append_vtk_points(std::string& out, const OutputMesh& mesh);

}  // namespace lpq
