// See smaller.h.
#include "shell/smaller.h"

#include <algorithm>

#include "shell/place.h"
#include "shell/space_tree.h"
#include "surface/size_field.h"

namespace lpq {
namespace {

constexpr double smaller = 0.6;
constexpr double reach = 1.5;  // mesh sizes around a fault

/// Marks vertices of a surface near points. Each is marked once: what a part of the tree holds is
/// not looked at again when all of it is.
class NearVertices {
 public:
  explicit NearVertices(std::span<const Vec3> points)
      : points_(points), tree_(boxes_of(points), points), is_marked_(tree_.root() + 1, 0) {}

  void mark(Vec3 centre, double radius, std::span<char> marks) {
    mark(tree_.root(), centre, radius, marks);
  }

 private:
  static std::vector<Box3> boxes_of(std::span<const Vec3> points) {
    std::vector<Box3> boxes;
    for (const Vec3 p : points) boxes.push_back({p, p});
    return boxes;
  }

  void mark(Index i, Vec3 centre, double radius, std::span<char> marks) {
    const SpaceTree::Node& node = tree_.node(i);
    if (is_marked_[i] || !(squared_distance(node.box, centre) < radius * radius)) return;
    if (node.left != none) {
      mark(node.left, centre, radius, marks);
      mark(node.right, centre, radius, marks);
      is_marked_[i] = is_marked_[node.left] && is_marked_[node.right];
      return;
    }
    is_marked_[i] = 1;
    for (const Index v : tree_.items(node)) {
      if (distance(points_[v], centre) < radius) marks[v] = 1;
      is_marked_[i] = is_marked_[i] && marks[v];
    }
  }

  std::span<const Vec3> points_;
  SpaceTree tree_;
  std::vector<char> is_marked_;  // #nodes  and all below them
};

}  // namespace

bool make_smaller(const SurfaceMesh& mesh, std::span<const Fault> faults, bool widely,
                  double growth, std::span<double> size) {
  NearVertices vertices(mesh.points);
  std::vector<char> meant(size.size(), 0);
  for (const Fault& fault : faults) {
    if (fault.place.triangle == none || widely)
      for (const Index v : fault.everywhere) meant[v] = 1;
    if (fault.place.triangle == none) continue;
    for (const Index v : mesh.triangles[fault.place.triangle]) meant[v] = 1;
    const Vec3 centre = point_at(mesh, fault.place);
    const double radius = reach * size_at(mesh.triangles, fault.place, size);
    vertices.mark(centre, radius, meant);
  }
  if (std::count(meant.begin(), meant.end(), 1) == 0) return false;
  for (std::size_t v = 0; v < meant.size(); ++v)
    if (meant[v]) size[v] *= smaller;
  limit_surface_growth(mesh, growth, size);
  return true;
}

}  // namespace lpq
