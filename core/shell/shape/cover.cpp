// See cover.h.
#include "shell/shape/cover.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shell/place.h"
#include "shell/shape/patch.h"
#include "shell/triangle_places.h"

namespace lpq {
namespace {

constexpr double long_edge = 0.15;        // of the mesh size
constexpr double between_points = 0.3;    // of the mesh size
constexpr double needle = 0.2;            // height over the longest side
constexpr double most_steps = 1000;       // along a side
constexpr double least_share = 1.0 / 12;  // of three corners' sizes, for one that is far smaller
constexpr double tie = 1e-9;              // of equal distances

class PlaceFinder {
 public:
  explicit PlaceFinder(const Charted& charted)
      : mesh_(charted.mesh), features_(charted.features), size_(charted.size) {}

  std::vector<PlaceToCover> run() {
    take_vertices();
    take_middles();
    for (Index t = 0; t < mesh_.triangle_count(); ++t) take_inside(t);
    return std::move(places_);
  }

 private:
  void add(const SurfacePlace& place) { places_.push_back({place, point_at(mesh_, place)}); }

  double length_of(Index a, Index b) const { return distance(mesh_.points[a], mesh_.points[b]); }

  void take_vertices() {
    std::vector<char> passed(mesh_.points.size());
    for (Index i = 0; i < features_.edges.count(); ++i)
      if (features_.is_feature(i))
        for (const Index v : features_.edges.ends[i]) passed[v] = 1;
    for (Index e = 0; e < 3 * mesh_.triangle_count(); ++e) {
      const Index v = mesh_.triangles[triangle_of(e)][e % 3];
      if (passed[v]) continue;
      passed[v] = 1;
      SurfacePlace place{triangle_of(e), {0, 0, 0}};
      place.weight[e % 3] = 1;
      add(place);
    }
  }

  void take_middles() {
    for (Index i = 0; i < features_.edges.count(); ++i) {
      const auto [a, b] = features_.edges.ends[i];
      if (features_.is_feature(i) || length_of(a, b) < long_edge * size_[a]) continue;
      const Index e = features_.edges.half_edges.row(i)[0];
      SurfacePlace place{triangle_of(e), {0.5, 0.5, 0.5}};
      place.weight[(e + 2) % 3] = 0;
      add(place);
    }
  }

  /// The middle of a triangle that is not small, or several points; of a needle no more than its
  /// share.
  void take_inside(Index t) {
    const auto [a, b, c] = mesh_.triangles[t];
    const double longest = std::max({length_of(a, b), length_of(b, c), length_of(c, a)});
    // A fine corner alone does not make the whole triangle full of places.
    const double size = std::max(size_[a], least_share * (size_[a] + size_[b] + size_[c]));
    const double step = between_points * size;
    if (longest <= step) return;
    const Vec3 p = mesh_.points[a];
    const double double_area = length(cross(mesh_.points[b] - p, mesh_.points[c] - p));
    if (double_area < needle * longest * longest) {
      visit_places({p, mesh_.points[b], mesh_.points[c]}, step, t,
                   [&](const std::array<double, 3>& weight, double) {
                     add({t, {weight[0], weight[1], weight[2]}});
                   });
      return;
    }
    const int n = std::max(3, static_cast<int>(std::min(longest / step, most_steps)) + 1);
    for (int i = 1; i < n; ++i)
      for (int j = 1; i + j < n; ++j) add({t, {1.0 * i / n, 1.0 * j / n, 1.0 * (n - i - j) / n}});
  }

  const SurfaceMesh& mesh_;
  const SurfaceFeatures& features_;
  std::span<const double> size_;
  std::vector<PlaceToCover> places_;
};

double mean_side(const ShellMesh& mesh, const Face& face) {
  const int n = corner_count(face);
  double sum = 0;
  for (int k = 0; k < n; ++k) sum += distance(mesh.points[face[k]], mesh.points[face[(k + 1) % n]]);
  return n > 0 ? sum / n : 0;
}

}  // namespace

std::vector<PlaceToCover> places_to_cover(const Charted& charted) {
  return PlaceFinder(charted).run();
}

Cover::Cover(const ShellMesh& mesh)
    : mesh_(mesh),
      fans_(face_fans(mesh)),
      nearest_(fans_.points, fans_.triangles),
      stars_(faces_at_vertices(mesh)) {
  Index first = 0;
  for (const Face& face : mesh.faces) {
    fan_of_.push_back(first);
    first += corner_count(face);
    side_.push_back(mean_side(mesh, face));
  }
}

Cover::Gap Cover::at(Vec3 p, Index hint) const {
  const NearestTriangle::Hit hit = nearest_.find(p, fan_of_[hint]);
  const Index face = fans_.face[hit.triangle];
  const double d = std::sqrt(hit.squared_distance);
  Index smallest = face;
  for (const Index v : mesh_.faces[face]) {
    if (v == none || distance(mesh_.points[v], p) > (1 + tie) * d) continue;
    for (const Index f : stars_.row(v))
      if (side_[f] < side_[smallest]) smallest = f;
  }
  return {smallest, d / side_[smallest]};
}

}  // namespace lpq
