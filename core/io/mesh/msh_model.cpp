// See msh_model.h.
#include "io/mesh/msh_model.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "io/mesh/output_parts.h"
#include "io/number.h"

namespace lpq {
namespace {

/// The physical name of an edge: its tag, or where it came from.
std::string edge_name(const OutputMesh& mesh, const OutputEdge& edge) {
  if (edge.tag != none) return mesh.tags[static_cast<std::size_t>(edge.tag)];
  if (edge.loop == none) return "polyline";
  std::string name;
  if (edge.region != none && mesh.regions.size() > 1) name = region_label(mesh, edge.region) + " ";
  name += edge.region != none ? "loop " : "polyline ";
  append_integer(name, std::int64_t{edge.loop} + 1);
  return name;
}

/// 1-based number of `name` in `names`, added if new.
class NameTable {
 public:
  explicit NameTable(std::vector<std::string>& names) : names_(names) {}
  Index number(const std::string& name) {
    const auto at = std::lower_bound(
        order_.begin(), order_.end(), name,
        [&](Index i, const auto& n) { return names_[static_cast<std::size_t>(i)] < n; });
    if (at != order_.end() && names_[static_cast<std::size_t>(*at)] == name) return *at + 1;
    names_.push_back(name);
    order_.insert(at, static_cast<Index>(names_.size()) - 1);
    return static_cast<Index>(names_.size());
  }

 private:
  std::vector<std::string>& names_;
  std::vector<Index> order_;  // sorted by name
};

void make_curves(const OutputMesh& mesh, MshModel& model) {
  const auto key = [&](Index e) {
    const OutputEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
    return std::array<Index, 5>{edge.region, edge.loop, edge.tag, edge.left, edge.right};
  };
  std::vector<Index> order(mesh.edges.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Index e = order[i];
    if (i == 0 || key(order[i - 1]) != key(e)) {
      const OutputEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
      model.curves.push_back({edge.left, edge.right, 0, {}});
    }
    model.curves.back().edges.push_back(e);
  }
  // Curves and their names in the order of their first edges.
  std::stable_sort(model.curves.begin(), model.curves.end(),
                   [](const auto& a, const auto& b) { return a.edges.front() < b.edges.front(); });
  NameTable names(model.curve_names);
  for (MshModel::Curve& curve : model.curves) {
    const OutputEdge& first = mesh.edges[static_cast<std::size_t>(curve.edges.front())];
    curve.physical = names.number(edge_name(mesh, first));
  }
}

void make_surfaces(const OutputMesh& mesh, MshModel& model) {
  model.groups = region_groups(mesh);
  for (Index g = 0; g < model.groups.count(); ++g)
    model.surface_names.push_back(region_label(mesh, model.groups.first(g)));
  model.faces_of_region = members_of(mesh.region, model.groups.group.size());
}

void classify_nodes(const OutputMesh& mesh, MshModel& model) {
  model.node_dimension.assign(mesh.points.size(), 2);
  model.node_entity.assign(mesh.points.size(), 0);
  const auto own = [&](Index v, Index dimension, std::size_t entity) {
    const auto i = static_cast<std::size_t>(v);
    if (model.node_dimension[i] < dimension) return;
    if (dimension < 2 && model.node_dimension[i] == dimension) return;  // the first one keeps it
    model.node_dimension[i] = dimension;
    model.node_entity[i] = static_cast<Index>(entity);
  };
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Face& face = mesh.faces[f];
    for (int k = 0; k < corner_count(face); ++k)
      own(face[k], 2, static_cast<std::size_t>(mesh.region[f]));
  }
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    for (const Index e : model.curves[c].edges) {
      own(mesh.edges[static_cast<std::size_t>(e)].a, 1, c);
      own(mesh.edges[static_cast<std::size_t>(e)].b, 1, c);
    }
  }
  for (std::size_t p = 0; p < mesh.tagged_points.size(); ++p)
    own(mesh.tagged_points[p].point, 0, p);
}

}  // namespace

MshModel make_msh_model(const OutputMesh& mesh) {
  MshModel model;
  make_curves(mesh, model);
  make_surfaces(mesh, model);
  NameTable names(model.point_names);
  for (const OutputPoint& point : mesh.tagged_points) {
    model.point_physical.push_back(names.number(mesh.tags[static_cast<std::size_t>(point.tag)]));
  }
  classify_nodes(mesh, model);
  return model;
}

std::vector<std::vector<Index>> edges_of_names(const MshModel& model) {
  std::vector<std::vector<Index>> edges(model.curve_names.size());
  for (const MshModel::Curve& curve : model.curves) {
    std::vector<Index>& list = edges[static_cast<std::size_t>(curve.physical) - 1];
    list.insert(list.end(), curve.edges.begin(), curve.edges.end());
  }
  for (std::vector<Index>& list : edges) std::sort(list.begin(), list.end());
  return edges;
}

}  // namespace lpq
