// See su2.h.
#include "io/mesh/su2.h"

#include "io/escape.h"
#include "io/mesh/labels.h"
#include "io/mesh/msh_model.h"
#include "io/mesh/vtk_cells.h"
#include "io/number.h"

namespace lpq {
namespace {

constexpr std::size_t longest_name = 80;

class Su2Writer {
 public:
  explicit Su2Writer(const OutputMesh& mesh) : mesh_(mesh), model_(make_msh_model(mesh)) {}

  std::string write() {
    out_ = "% lpquad\n";
    comments();
    out_ += "NDIME= 2\n";
    elements();
    points();
    markers();
    return std::move(out_);
  }

 private:
  void integer(std::int64_t value) { append_integer(out_, value); }
  void count(const char* keyword, std::size_t value) {
    out_ += keyword;
    integer(static_cast<std::int64_t>(value));
    out_ += '\n';
  }
  void node(Index v) {
    out_ += ' ';
    integer(v);
  }

  void comments() {
    for (Index s = 0; s < model_.faces_of_region.rows(); ++s) {
      const Index first = model_.faces_of_region.offsets[static_cast<std::size_t>(s)];
      const Index end = model_.faces_of_region.offsets[static_cast<std::size_t>(s) + 1];
      if (first == end) continue;
      out_ += "% elements ";
      integer(first);
      out_ += " to ";
      integer(end - 1);
      out_ += ": region ";
      append_quoted_ascii(out_, model_.surface_names[static_cast<std::size_t>(model_.groups.of(s))],
                          longest_name);
      out_ += '\n';
    }
    for (const OutputPoint& point : mesh_.tagged_points) {
      out_ += "% point";
      node(point.point);
      out_ += ": ";
      append_quoted_ascii(out_, mesh_.tags[static_cast<std::size_t>(point.tag)], longest_name);
      out_ += '\n';
    }
  }

  void elements() {
    count("NELEM= ", mesh_.faces.size());
    std::int64_t element = 0;
    for (const Index f : model_.faces_of_region.values) {
      const Face& face = mesh_.faces[static_cast<std::size_t>(f)];
      integer(corner_count(face) == 4 ? vtk_quad : vtk_triangle);
      for (int k = 0; k < corner_count(face); ++k) node(face[k]);
      out_ += ' ';
      integer(element++);
      out_ += '\n';
    }
  }

  void points() {
    count("NPOIN= ", mesh_.points.size());
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      append_numbers(out_, {mesh_.points[v].x, mesh_.points[v].y});
      node(static_cast<Index>(v));
      out_ += '\n';
    }
  }

  void markers() {
    std::size_t markers = 0;
    std::string text;
    std::swap(text, out_);  // the number of markers stands before them
    const auto names = edges_of_names(model_);
    for (const bool inside : {false, true}) {
      for (std::size_t c = 0; c < names.size(); ++c) {
        std::vector<Index> edges;
        for (const Index e : names[c])
          if (belongs(mesh_.edges[static_cast<std::size_t>(e)], inside)) edges.push_back(e);
        if (edges.empty()) continue;
        marker(model_.curve_names[c], edges);
        ++markers;
      }
    }
    std::swap(text, out_);
    count("NMARK= ", markers);
    out_ += text;
  }

  static bool belongs(const OutputEdge& edge, bool inside) {
    const bool is_inside = edge.left != none && edge.right != none;
    return is_inside == inside && (!inside || edge.tag != none);
  }

  void marker(const std::string& name, const std::vector<Index>& edges) {
    out_ += "MARKER_TAG= " + labels_.add(name) + "\n";
    count("MARKER_ELEMS= ", edges.size());
    for (const Index e : edges) {
      integer(vtk_line);
      node(mesh_.edges[static_cast<std::size_t>(e)].a);
      node(mesh_.edges[static_cast<std::size_t>(e)].b);
      out_ += '\n';
    }
  }

  const OutputMesh& mesh_;
  const MshModel model_;
  std::string out_;
  Labels labels_{longest_name};
};

}  // namespace

std::string write_su2(const OutputMesh& mesh) { return Su2Writer(mesh).write(); }

}  // namespace lpq
