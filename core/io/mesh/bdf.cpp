// See bdf.h.
#include "io/mesh/bdf.h"

#include "io/escape.h"
#include "io/mesh/msh_model.h"
#include "io/number.h"
#include "io/number_field.h"

namespace lpq {
namespace {

constexpr std::size_t short_field = 8, long_field = 16;
constexpr std::int64_t longest_short = 99'999'999;  // the last integer of 8 digits

void append_left(std::string& out, std::string_view text, std::size_t width) {
  out += text;
  out.append(width - text.size(), ' ');
}
void append_right(std::string& out, std::string_view text, std::size_t width) {
  out.append(width - text.size(), ' ');
  out += text;
}

class BdfWriter {
 public:
  explicit BdfWriter(const OutputMesh& mesh) : mesh_(mesh), model_(make_msh_model(mesh)) {}

  std::string write() {
    out_ = "$ lpquad\n";
    const auto regions = static_cast<std::int64_t>(model_.surface_names.size());
    comments("$ PID ", 1, "region", model_.surface_names);
    comments("$ PID ", regions + 1, "edges", model_.curve_names);
    comments("$ SET1 ", 1, "points", model_.point_names);
    out_ += "CEND\nBEGIN BULK\n";
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) grid(v);
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) face(f);
    for (const MshModel::Curve& curve : model_.curves) {
      for (const Index e : curve.edges) {
        const OutputEdge& edge = mesh_.edges[static_cast<std::size_t>(e)];
        const std::int64_t a = edge.a, b = edge.b;
        append_bdf_entry(out_, "CROD", {next_element_++, regions + curve.physical, a + 1, b + 1});
      }
    }
    point_sets();
    out_ += "ENDDATA\n";
    return std::move(out_);
  }

 private:
  void comments(const char* head, std::int64_t first, const char* what,
                const std::vector<std::string>& names) {
    constexpr std::size_t longest_name = 48;  // lines end at column 80
    for (const std::string& name : names) {
      out_ += head;
      append_integer(out_, first++);
      out_ += " = ";
      out_ += what;
      out_ += ' ';
      append_quoted_ascii(out_, name, longest_name);
      out_ += '\n';
    }
  }

  void grid(std::size_t v) {
    const auto number = [&](double x) {
      std::string text;
      append_number_field(text, x, long_field, "");
      append_right(out_, text, long_field);
    };
    append_left(out_, "GRID*", short_field);
    std::string id;
    append_integer(id, static_cast<std::int64_t>(v) + 1);
    append_right(out_, id, long_field);
    out_.append(long_field, ' ');  // the basic coordinate system
    number(mesh_.points[v].x);
    number(mesh_.points[v].y);
    out_ += "\n*       ";
    number(mesh_.point(static_cast<Index>(v)).z);
    out_ += '\n';
  }

  void face(std::size_t f) {
    const Face& corners = mesh_.faces[f];
    std::vector<std::int64_t> fields{next_element_++,
                                     std::int64_t{model_.groups.of(mesh_.region[f])} + 1};
    for (int k = 0; k < corner_count(corners); ++k) fields.push_back(std::int64_t{corners[k]} + 1);
    append_bdf_entry(out_, corner_count(corners) == 4 ? "CQUAD4" : "CTRIA3", fields);
  }

  void point_sets() {
    for (std::size_t s = 0; s < model_.point_names.size(); ++s) {
      const auto number = static_cast<std::int64_t>(s) + 1;
      std::vector<std::int64_t> fields{number};
      for (std::size_t p = 0; p < mesh_.tagged_points.size(); ++p)
        if (model_.point_physical[p] == number)
          fields.push_back(std::int64_t{mesh_.tagged_points[p].point} + 1);
      append_bdf_entry(out_, "SET1", fields);
    }
  }

  const OutputMesh& mesh_;
  const MshModel model_;
  std::string out_;
  std::int64_t next_element_ = 1;
};

}  // namespace

void append_bdf_entry(std::string& out, std::string_view name,
                      const std::vector<std::int64_t>& fields) {
  bool large = false;
  for (const std::int64_t value : fields) large = large || value > longest_short;
  const std::size_t width = large ? long_field : short_field, on_a_line = large ? 4 : 8;
  append_left(out, std::string(name) + (large ? "*" : ""), short_field);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0 && i % on_a_line == 0) {
      out += '\n';
      append_left(out, large ? "*" : "+", short_field);
    }
    std::string text;
    append_integer(text, fields[i]);
    append_right(out, text, width);
  }
  out += '\n';
}

std::string write_bdf(const OutputMesh& mesh) { return BdfWriter(mesh).write(); }

}  // namespace lpq
