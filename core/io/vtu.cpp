// See vtu.h.
#include "io/vtu.h"

#include "io/mesh_text.h"
#include "io/number.h"

namespace lpq {
namespace {

constexpr int vtk_line = 3, vtk_triangle = 5, vtk_quad = 9;

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

/// VTK keeps ASCII strings as numbers, a zero after each string.
void append_names(std::string& out, const char* name, const std::vector<std::string>& names) {
  if (names.empty()) return;
  out += "<Array type=\"String\" Name=\"";
  out += name;
  out += "\" NumberOfTuples=\"";
  append_integer(out, static_cast<std::int64_t>(names.size()));
  out += "\" format=\"ascii\">\n";
  for (const std::string& text : names) {
    for (const char c : text) {
      append_integer(out, static_cast<unsigned char>(c));
      out += ' ';
    }
    out += "0\n";
  }
  out += "</Array>\n";
}

void append_points(std::string& out, const OutputMesh& mesh) {
  out += "<Points>\n";
  open_array(out, "Float64", "Points", " NumberOfComponents=\"3\"");
  for (const Vec2 p : mesh.points) {
    append_number(out, p.x);
    out += ' ';
    append_number(out, p.y);
    out += " 0\n";
  }
  close_array(out);
  out += "</Points>\n";
}

void append_cells(std::string& out, const OutputMesh& mesh) {
  out += "<Cells>\n";
  open_array(out, "Int64", "connectivity");
  for (const Face& face : mesh.faces) {
    for (int k = 0; k < corner_count(face); ++k) {
      if (k > 0) out += ' ';
      append_integer(out, face[k]);
    }
    out += '\n';
  }
  for (const OutputEdge& edge : mesh.edges) {
    append_integer(out, edge.a);
    out += ' ';
    append_line(out, edge.b);
  }
  close_array(out);
  open_array(out, "Int64", "offsets");
  std::int64_t offset = 0;
  for (const Face& face : mesh.faces) append_line(out, offset += corner_count(face));
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) append_line(out, offset += 2);
  close_array(out);
  open_array(out, "UInt8", "types");
  for (const Face& face : mesh.faces)
    append_line(out, corner_count(face) == 4 ? vtk_quad : vtk_triangle);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) append_line(out, vtk_line);
  close_array(out);
  out += "</Cells>\n";
}

/// Lines have the region on their left (or right, where the left is outside) and eta 0; faces have
/// no tag (-1).
void append_cell_data(std::string& out, const OutputMesh& mesh) {
  out += "<CellData Scalars=\"eta\">\n";
  open_array(out, "Int32", "region");
  for (const Index r : mesh.region) append_line(out, r);
  for (const OutputEdge& edge : mesh.edges)
    append_line(out, edge.left != none ? edge.left : edge.right);
  close_array(out);
  open_array(out, "Int32", "tag");
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) append_line(out, none);
  for (const OutputEdge& edge : mesh.edges) append_line(out, edge.tag);
  close_array(out);
  open_array(out, "Float64", "eta");
  for (const Face& face : mesh.faces) {
    append_number(out, output_eta(mesh, face));
    out += '\n';
  }
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) out += "0\n";
  close_array(out);
  out += "</CellData>\n";
}

}  // namespace

std::string write_vtu(const OutputMesh& mesh) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\""
      " header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n";
  append_names(out, "region_names", mesh.regions);
  append_names(out, "tag_names", mesh.tags);
  out += "</FieldData>\n<Piece NumberOfPoints=\"";
  append_integer(out, static_cast<std::int64_t>(mesh.points.size()));
  out += "\" NumberOfCells=\"";
  append_integer(out, static_cast<std::int64_t>(mesh.faces.size() + mesh.edges.size()));
  out += "\">\n";
  append_points(out, mesh);
  append_cells(out, mesh);
  append_cell_data(out, mesh);
  out += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return out;
}

}  // namespace lpq
