// See vtk.h.
#include "io/mesh/vtk.h"

#include "io/mesh/output_parts.h"
#include "io/mesh/vtk_cells.h"
#include "io/number.h"

namespace lpq {
namespace {

class VtkWriter {
 public:
  explicit VtkWriter(const OutputMesh& mesh) : mesh_(mesh) {}

  std::string write() {
    out_ = "# vtk DataFile Version 3.0\nlpquad\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    head("POINTS", mesh_.points.size(), " double\n");
    append_vtk_points(out_, mesh_);
    cells();
    fields();  // before CELL_DATA, where a FIELD would need one tuple per cell
    head("CELL_DATA", vtk_cell_count(mesh_), "\n");
    // VTK's reader takes one SCALARS, unless told otherwise, but every array of a FIELD.
    out_ += "SCALARS eta double 1\nLOOKUP_TABLE default\n";
    values([&](const VtkCell& cell) {
      append_number(out_, cell.face == none ? 0 : output_eta(mesh_, cell.points));
    });
    out_ += "FIELD FieldData 2\n";
    head("region 1", vtk_cell_count(mesh_), " int\n");
    values([&](const VtkCell& cell) { append_integer(out_, cell.region); });
    head("tag 1", vtk_cell_count(mesh_), " int\n");
    values([&](const VtkCell& cell) { append_integer(out_, cell.tag); });
    return std::move(out_);
  }

 private:
  void head(const char* keyword, std::size_t count, std::string_view rest) {
    out_ += keyword;
    out_ += ' ';
    append_integer(out_, static_cast<std::int64_t>(count));
    out_ += rest;
  }

  void cells() {
    std::int64_t numbers = 0;
    each_vtk_cell(mesh_, [&](const VtkCell& cell) { numbers += cell.count + 1; });
    head("CELLS", vtk_cell_count(mesh_), " ");
    append_integer(out_, numbers);
    out_ += '\n';
    each_vtk_cell(mesh_, [&](const VtkCell& cell) {
      append_integer(out_, cell.count);
      for (int k = 0; k < cell.count; ++k) {
        out_ += ' ';
        append_integer(out_, cell.points[k]);
      }
      out_ += '\n';
    });
    head("CELL_TYPES", vtk_cell_count(mesh_), "\n");
    each_vtk_cell(mesh_, [&](const VtkCell& cell) {
      append_integer(out_, cell.type);
      out_ += '\n';
    });
  }

  void fields() {
    const int count = (mesh_.regions.empty() ? 0 : 1) + (mesh_.tags.empty() ? 0 : 1);
    if (count == 0) return;
    out_ += "FIELD FieldData ";
    append_integer(out_, count);
    out_ += '\n';
    names("region_names", group_names(mesh_, region_groups(mesh_)));
    names("tag_names", mesh_.tags);
  }

  void names(const char* array, const std::vector<std::string>& names) {
    if (names.empty()) return;
    out_ += array;
    head(" 1", vtk_names_size(names), " unsigned_char\n");
    append_vtk_names(out_, names);
  }

  template <class Value>
  void values(Value&& append_value) {
    each_vtk_cell(mesh_, [&](const VtkCell& cell) {
      append_value(cell);
      out_ += '\n';
    });
  }

  const OutputMesh& mesh_;
  std::string out_;
};

}  // namespace

std::string write_vtk(const OutputMesh& mesh) { return VtkWriter(mesh).write(); }

}  // namespace lpq
