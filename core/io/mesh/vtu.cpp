// See vtu.h.
#include "io/mesh/vtu.h"

#include "io/mesh/output_parts.h"
#include "io/mesh/vtk_cells.h"
#include "io/number.h"

namespace lpq {
namespace {

void open_array(std::string& out, const char* type, const char* name, const char* more = "") {
  out += "<DataArray type=\"";
  out += type;
  out += "\" Name=\"";
  out += name;
  out += "\" format=\"ascii\"";
  out += more;
  out += ">\n";
}
void close_array(std::string& out) { out += "</DataArray>\n"; }

void append_line(std::string& out, std::int64_t value) {
  append_integer(out, value);
  out += '\n';
}

/// As bytes: meshio refuses a file with an array of VTK's type String.
void append_names(std::string& out, const char* name, const std::vector<std::string>& names) {
  if (names.empty()) return;
  std::string tuples = " NumberOfTuples=\"";
  append_integer(tuples, static_cast<std::int64_t>(vtk_names_size(names)));
  open_array(out, "UInt8", name, (tuples + "\"").c_str());
  append_vtk_names(out, names);
  close_array(out);
}

void append_points(std::string& out, const OutputMesh& mesh) {
  out += "<Points>\n";
  open_array(out, "Float64", "Points", " NumberOfComponents=\"3\"");
  append_vtk_points(out, mesh);
  close_array(out);
  out += "</Points>\n";
}

void append_cells(std::string& out, const OutputMesh& mesh) {
  out += "<Cells>\n";
  open_array(out, "Int64", "connectivity");
  each_vtk_cell(mesh, [&](const VtkCell& cell) {
    for (int k = 0; k < cell.count; ++k) {
      if (k > 0) out += ' ';
      append_integer(out, cell.points[k]);
    }
    out += '\n';
  });
  close_array(out);
  open_array(out, "Int64", "offsets");
  std::int64_t offset = 0;
  each_vtk_cell(mesh, [&](const VtkCell& cell) { append_line(out, offset += cell.count); });
  close_array(out);
  open_array(out, "UInt8", "types");
  each_vtk_cell(mesh, [&](const VtkCell& cell) { append_line(out, cell.type); });
  close_array(out);
  out += "</Cells>\n";
}

void append_cell_data(std::string& out, const OutputMesh& mesh) {
  out += "<CellData Scalars=\"eta\">\n";
  open_array(out, "Int32", "region");
  each_vtk_cell(mesh, [&](const VtkCell& cell) { append_line(out, cell.region); });
  close_array(out);
  open_array(out, "Int32", "tag");
  each_vtk_cell(mesh, [&](const VtkCell& cell) { append_line(out, cell.tag); });
  close_array(out);
  open_array(out, "Float64", "eta");
  each_vtk_cell(mesh, [&](const VtkCell& cell) {
    append_number(out, cell.face == none ? 0 : output_eta(mesh, cell.points));
    out += '\n';
  });
  close_array(out);
  out += "</CellData>\n";
}

}  // namespace

std::string write_vtu(const OutputMesh& mesh) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\""
      " header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n";
  append_names(out, "region_names", group_names(mesh, region_groups(mesh)));
  append_names(out, "tag_names", mesh.tags);
  out += "</FieldData>\n<Piece NumberOfPoints=\"";
  append_integer(out, static_cast<std::int64_t>(mesh.points.size()));
  out += "\" NumberOfCells=\"";
  append_integer(out, static_cast<std::int64_t>(vtk_cell_count(mesh)));
  out += "\">\n";
  append_points(out, mesh);
  append_cells(out, mesh);
  append_cell_data(out, mesh);
  out += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return out;
}

}  // namespace lpq
