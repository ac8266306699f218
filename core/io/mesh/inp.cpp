// See inp.h.
#include "io/mesh/inp.h"

#include <map>

#include "base/sort_unique.h"
#include "io/mesh/edge_sides.h"
#include "io/mesh/labels.h"
#include "io/mesh/msh_model.h"
#include "io/number.h"
#include "io/number_field.h"

namespace lpq {
namespace {

constexpr std::size_t longest_label = 80, longest_number = 20;

class InpWriter {
 public:
  InpWriter(const OutputMesh& mesh, InpElement element)
      : mesh_(mesh),
        element_(mesh.in_space() ? InpElement::s4 : element),
        model_(make_msh_model(mesh)) {}

  std::string write() {
    out_ = "*HEADING\nlpquad\n";
    nodes();
    number_of_face_.assign(mesh_.faces.size(), 0);
    for (Index g = 0; g < model_.groups.count(); ++g) group(g);
    const auto edges = edges_of_names(model_);
    node_sets(edges);
    if (element_ != InpElement::s4) surfaces(edges);
    return std::move(out_);
  }

 private:
  void integer(std::int64_t value) { append_integer(out_, value); }

  void nodes() {
    out_ += "*NODE\n";
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      integer(static_cast<std::int64_t>(v) + 1);
      coordinate(mesh_.points[v].x);
      coordinate(mesh_.points[v].y);
      if (mesh_.in_space()) {
        coordinate(mesh_.z[v]);
      } else if (element_ == InpElement::s4) {
        out_ += ", 0.0";
      }
      out_ += '\n';
    }
  }
  void coordinate(double x) {
    out_ += ", ";
    append_number_field(out_, x, longest_number, "e");
  }

  std::string_view type(int corners) const {
    switch (element_) {
      case InpElement::cps4: return corners == 4 ? "CPS4" : "CPS3";
      case InpElement::cpe4: return corners == 4 ? "CPE4" : "CPE3";
      case InpElement::cax4: return corners == 4 ? "CAX4" : "CAX3";
      case InpElement::s4: return corners == 4 ? "S4" : "S3";
    }
    return {};
  }

  /// The set is a range of its own, not a parameter of *ELEMENT: some readers take the second
  /// *ELEMENT block of a set, that of the triangles, for the whole set.
  void group(Index g) {
    const std::int64_t first = next_element_;
    for (const int corners : {4, 3}) elements(g, corners);
    if (next_element_ == first) return;
    out_ += "*ELSET, ELSET=";
    out_ += region_labels_.add(model_.surface_names[static_cast<std::size_t>(g)]);
    out_ += ", GENERATE\n";
    integer(first);
    out_ += ", ";
    integer(next_element_ - 1);
    out_ += ", 1\n";
  }

  void elements(Index g, int corners) {
    bool is_open = false;
    for (const Index r : model_.groups.regions.row(g))
      for (const Index f : model_.faces_of_region.row(r)) {
        if (corner_count(mesh_.faces[static_cast<std::size_t>(f)]) != corners) continue;
        if (!is_open) {
          out_ += "*ELEMENT, TYPE=";
          out_ += type(corners);
          out_ += '\n';
          is_open = true;
        }
        element(f);
      }
  }

  void element(Index f) {
    const Face& face = mesh_.faces[static_cast<std::size_t>(f)];
    number_of_face_[static_cast<std::size_t>(f)] = next_element_;
    integer(next_element_++);
    for (int k = 0; k < corner_count(face); ++k) {
      out_ += ", ";
      integer(std::int64_t{face[k]} + 1);
    }
    out_ += '\n';
  }

  /// Points and edges of one name are one set.
  void node_sets(const std::vector<std::vector<Index>>& edges) {
    std::map<std::string, std::size_t> set_of_name;
    std::vector<std::vector<Index>> sets(edges.size());
    for (std::size_t c = 0; c < edges.size(); ++c) {
      set_labels_.push_back(labels_.add(model_.curve_names[c]));
      set_of_name[model_.curve_names[c]] = c;
      for (const Index e : edges[c]) {
        const OutputEdge& edge = mesh_.edges[static_cast<std::size_t>(e)];
        sets[c].insert(sets[c].end(), {edge.a, edge.b});
      }
    }
    for (const OutputPoint& point : mesh_.tagged_points) {
      const std::string& name = mesh_.tags[static_cast<std::size_t>(point.tag)];
      const auto [entry, is_new] = set_of_name.try_emplace(name, sets.size());
      if (is_new) {
        sets.emplace_back();
        set_labels_.push_back(labels_.add(name));
      }
      sets[entry->second].push_back(point.point);
    }
    for (std::size_t i = 0; i < sets.size(); ++i) node_set(set_labels_[i], sets[i]);
  }

  void node_set(const std::string& label, std::vector<Index>& nodes) {
    sort_unique(nodes);
    out_ += "*NSET, NSET=" + label;
    constexpr std::size_t on_a_line = 16;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      out_ += i % on_a_line == 0 ? "\n" : ", ";
      integer(std::int64_t{nodes[i]} + 1);
    }
    out_ += '\n';
  }

  void surfaces(const std::vector<std::vector<Index>>& edges) {
    const std::vector<EdgeSide> sides = edge_sides(mesh_);
    for (std::size_t c = 0; c < edges.size(); ++c) {
      out_ += "*SURFACE, NAME=" + set_labels_[c] + ", TYPE=ELEMENT\n";
      for (const Index e : edges[c]) {
        const EdgeSide& side = sides[static_cast<std::size_t>(e)];
        if (side.face == none) continue;
        integer(number_of_face_[static_cast<std::size_t>(side.face)]);
        out_ += ", S";
        integer(side.side + 1);
        out_ += '\n';
      }
    }
  }

  const OutputMesh& mesh_;
  const InpElement element_;
  const MshModel model_;
  std::string out_;
  std::int64_t next_element_ = 1;
  std::vector<std::int64_t> number_of_face_;
  Labels region_labels_{longest_label}, labels_{longest_label};
  std::vector<std::string> set_labels_;  // of the node sets, those of edges first
};

}  // namespace

std::string write_inp(const OutputMesh& mesh, InpElement element) {
  return InpWriter(mesh, element).write();
}

}  // namespace lpq
