// Writes the two versions of msh.h.
#include <array>

#include "base/check.h"
#include "geometry/box.h"
#include "io/escape.h"
#include "io/mesh/msh.h"
#include "io/mesh/msh_model.h"
#include "io/number.h"
#include "io/unique_names.h"

namespace lpq {
namespace {

// Element types of the format.
constexpr int type_line = 1, type_triangle = 2, type_quad = 3, type_point = 15;

class MshWriter {
 public:
  explicit MshWriter(const OutputMesh& mesh) : mesh_(mesh), model_(make_msh_model(mesh)) {}

  std::string version_2_2() {
    text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
    physical_names();
    text("$Nodes\n");
    line(mesh_.points.size());
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      integer(v + 1);
      coordinates(point(static_cast<Index>(v)));
    }
    text("$EndNodes\n$Elements\n");
    line(mesh_.tagged_points.size() + mesh_.edges.size() + mesh_.faces.size());
    elements_2_2();
    text("$EndElements\n");
    return std::move(out_);
  }

  std::string version_4_1() {
    text("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    physical_names();
    entities();
    nodes_4_1();
    elements_4_1();
    return std::move(out_);
  }

 private:
  void text(std::string_view t) { out_ += t; }
  void integer(std::size_t value) { append_integer(out_, static_cast<std::int64_t>(value)); }
  /// Integers on one line.
  template <class... Values>
  void line(Values... values) {
    (..., (append_integer(out_, static_cast<std::int64_t>(values)), out_ += ' '));
    out_.back() = '\n';
  }
  void coordinates(Vec3 p) {
    if (out_.back() != '\n') out_ += ' ';
    append_numbers(out_, {p.x, p.y, p.z});
    out_ += '\n';
  }

  void physical_names() {
    text("$PhysicalNames\n");
    line(model_.point_names.size() + model_.curve_names.size() + model_.surface_names.size());
    const std::array<const std::vector<std::string>*, 3> names{
        &model_.point_names, &model_.curve_names, &model_.surface_names};
    for (std::size_t dimension = 0; dimension < 3; ++dimension) {
      const std::vector<std::string> written =
          unique_names(*names[dimension], append_msh_name, longest_msh_name);
      for (std::size_t i = 0; i < written.size(); ++i) {
        integer(dimension);
        text(" ");
        integer(i + 1);
        text(" \"");
        text(written[i]);
        text("\"\n");
      }
    }
    text("$EndPhysicalNames\n");
  }

  // --- version 2.2: every element carries (physical, elementary) tags

  void element_2_2(int type, std::size_t physical, std::size_t entity) {
    integer(++elements_);
    text(" ");
    append_integer(out_, type);
    text(" 2 ");
    integer(physical);
    text(" ");
    integer(entity);
  }
  void node(Index v) {
    text(" ");
    append_integer(out_, std::int64_t{v} + 1);
  }

  std::size_t physical_surface(Index region) const {
    return static_cast<std::size_t>(model_.groups.of(region)) + 1;
  }

  void elements_2_2() {
    for (std::size_t p = 0; p < mesh_.tagged_points.size(); ++p) {
      element_2_2(type_point, static_cast<std::size_t>(model_.point_physical[p]), p + 1);
      node(mesh_.tagged_points[p].point);
      text("\n");
    }
    for (std::size_t c = 0; c < model_.curves.size(); ++c) {
      for (const Index e : model_.curves[c].edges) {
        const OutputEdge& edge = mesh_.edges[static_cast<std::size_t>(e)];
        element_2_2(type_line, static_cast<std::size_t>(model_.curves[c].physical), c + 1);
        node(edge.a);
        node(edge.b);
        text("\n");
      }
    }
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const Face& face = mesh_.faces[f];
      element_2_2(corner_count(face) == 4 ? type_quad : type_triangle,
                  physical_surface(mesh_.region[f]), static_cast<std::size_t>(mesh_.region[f]) + 1);
      for (int k = 0; k < corner_count(face); ++k) node(face[k]);
      text("\n");
    }
  }

  // --- version 4.1: nodes and elements come in blocks, one per entity

  void bounding_box(const Box3& box) {
    const Box3 shown = is_empty(box) ? Box3{{}, {}} : box;
    for (const Vec3 p : {shown.lo, shown.hi}) {
      text(" ");
      append_numbers(out_, {p.x, p.y, p.z});
    }
  }
  Vec3 point(Index v) const { return mesh_.point(v); }

  void entities() {
    const std::size_t surfaces = model_.groups.group.size();
    text("$Entities\n");
    line(mesh_.tagged_points.size(), model_.curves.size(), surfaces, 0);
    for (std::size_t p = 0; p < mesh_.tagged_points.size(); ++p) {
      integer(p + 1);
      const Vec3 at = point(mesh_.tagged_points[p].point);
      text(" ");
      append_numbers(out_, {at.x, at.y, at.z});
      text(" 1 ");
      line(model_.point_physical[p]);
    }
    for (std::size_t c = 0; c < model_.curves.size(); ++c) curve_entity(c);
    Csr<std::int64_t> bounding = surface_boundaries(surfaces);
    for (std::size_t s = 0; s < surfaces; ++s) {
      integer(s + 1);
      Box3 box;
      for (const Index f : model_.faces_of_region.row(static_cast<Index>(s))) {
        const Face& face = mesh_.faces[static_cast<std::size_t>(f)];
        for (int k = 0; k < corner_count(face); ++k) extend(box, point(face[k]));
      }
      bounding_box(box);
      text(" 1 ");
      integer(physical_surface(static_cast<Index>(s)));
      const auto curves = bounding.row(static_cast<Index>(s));
      text(" ");
      integer(curves.size());
      for (const std::int64_t curve : curves) {
        text(" ");
        append_integer(out_, curve);
      }
      text("\n");
    }
    text("$EndEntities\n");
  }

  void curve_entity(std::size_t c) {
    Box3 box;
    for (const Index e : model_.curves[c].edges) {
      extend(box, point(mesh_.edges[static_cast<std::size_t>(e)].a));
      extend(box, point(mesh_.edges[static_cast<std::size_t>(e)].b));
    }
    integer(c + 1);
    bounding_box(box);
    text(" 1 ");
    // No bounding points: most curves are closed loops, and a discrete curve needs none.
    line(model_.curves[c].physical, 0);
  }

  /// Signed curve tags that bound each region: + where the region lies on the curve's left.
  Csr<std::int64_t> surface_boundaries(std::size_t surfaces) const {
    std::vector<std::vector<std::int64_t>> curves(surfaces);
    for (std::size_t c = 0; c < model_.curves.size(); ++c) {
      const MshModel::Curve& curve = model_.curves[c];
      if (curve.left == curve.right) continue;  // embedded, bounds nothing
      const auto tag = static_cast<std::int64_t>(c) + 1;
      if (curve.left != none) curves[static_cast<std::size_t>(curve.left)].push_back(tag);
      if (curve.right != none) curves[static_cast<std::size_t>(curve.right)].push_back(-tag);
    }
    Csr<std::int64_t> result;
    for (const auto& row : curves) {
      result.values.insert(result.values.end(), row.begin(), row.end());
      result.end_row();
    }
    return result;
  }

  void nodes_4_1() {
    const std::array<std::size_t, 3> entity_count{mesh_.tagged_points.size(), model_.curves.size(),
                                                  model_.groups.group.size()};
    // Bucket the nodes by entity, all dimensions in one list.
    std::array<std::size_t, 3> first{0, entity_count[0], entity_count[0] + entity_count[1]};
    std::vector<std::vector<Index>> nodes(first[2] + entity_count[2]);
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      const auto dimension = static_cast<std::size_t>(model_.node_dimension[v]);
      nodes[first[dimension] + static_cast<std::size_t>(model_.node_entity[v])].push_back(
          static_cast<Index>(v));
    }
    std::size_t blocks = 0;
    for (const auto& block : nodes) blocks += block.empty() ? 0 : 1;
    text("$Nodes\n");
    line(blocks, mesh_.points.size(), mesh_.points.empty() ? 0 : 1, mesh_.points.size());
    for (std::size_t dimension = 0; dimension < 3; ++dimension) {
      for (std::size_t i = 0; i < entity_count[dimension]; ++i) {
        const std::vector<Index>& block = nodes[first[dimension] + i];
        if (block.empty()) continue;
        line(dimension, i + 1, 0, block.size());
        for (const Index v : block) line(std::int64_t{v} + 1);
        for (const Index v : block) coordinates(point(v));
      }
    }
    text("$EndNodes\n");
  }

  void open_block(std::size_t dimension, std::size_t entity, int type, std::size_t size) {
    line(dimension, entity, type, size);
  }
  template <class... Nodes>
  void element_4_1(Nodes... nodes) {
    integer(++elements_);
    (..., node(nodes));
    text("\n");
  }

  /// Faces of region s with the given number of corners.
  std::size_t count_faces(std::size_t s, int corners) const {
    std::size_t count = 0;
    for (const Index f : model_.faces_of_region.row(static_cast<Index>(s)))
      count += corner_count(mesh_.faces[static_cast<std::size_t>(f)]) == corners ? 1 : 0;
    return count;
  }

  void elements_4_1() {
    const std::size_t surfaces = model_.groups.group.size();
    std::size_t blocks = mesh_.tagged_points.size() + model_.curves.size();
    for (std::size_t s = 0; s < surfaces; ++s)
      for (const int corners : {3, 4}) blocks += count_faces(s, corners) > 0 ? 1 : 0;
    const std::size_t total = mesh_.tagged_points.size() + mesh_.edges.size() + mesh_.faces.size();
    text("$Elements\n");
    line(blocks, total, total == 0 ? 0 : 1, total);
    for (std::size_t p = 0; p < mesh_.tagged_points.size(); ++p) {
      open_block(0, p + 1, type_point, 1);
      element_4_1(mesh_.tagged_points[p].point);
    }
    for (std::size_t c = 0; c < model_.curves.size(); ++c) {
      open_block(1, c + 1, type_line, model_.curves[c].edges.size());
      for (const Index e : model_.curves[c].edges) {
        const OutputEdge& edge = mesh_.edges[static_cast<std::size_t>(e)];
        element_4_1(edge.a, edge.b);
      }
    }
    for (std::size_t s = 0; s < surfaces; ++s)
      for (const int corners : {3, 4}) surface_block(s, corners);
    text("$EndElements\n");
    LPQ_ASSERT(elements_ == total);
  }

  void surface_block(std::size_t s, int corners) {
    const std::size_t count = count_faces(s, corners);
    if (count == 0) return;
    open_block(2, s + 1, corners == 4 ? type_quad : type_triangle, count);
    for (const Index f : model_.faces_of_region.row(static_cast<Index>(s))) {
      const Face& face = mesh_.faces[static_cast<std::size_t>(f)];
      if (corner_count(face) != corners) continue;
      if (corners == 4) {
        element_4_1(face[0], face[1], face[2], face[3]);
      } else {
        element_4_1(face[0], face[1], face[2]);
      }
    }
  }

  const OutputMesh& mesh_;
  MshModel model_;
  std::string out_;
  std::size_t elements_ = 0;  // element tags given so far
};

}  // namespace

std::string write_msh(const OutputMesh& mesh, MshVersion version) {
  MshWriter writer(mesh);
  return version == MshVersion::v2_2 ? writer.version_2_2() : writer.version_4_1();
}

}  // namespace lpq
