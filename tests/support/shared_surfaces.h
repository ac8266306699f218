// Surfaces of the shared data, read by the simplest means: polygons become fans of triangles, equal
// points are one, triangles are oriented alike, and edges of other than two triangles are cut.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "mesh/surface_mesh.h"
#include "surface/frames.h"

namespace lpq_test {

/// Triangles without repeated corners or points out of range are oriented and joined at their
/// edges.
class SurfaceBuilder {
 public:
  lpq::SurfaceMesh build(std::vector<lpq::Vec3> points, const std::vector<lpq::Tri>& triangles,
                         const std::vector<lpq::Index>& groups = {}) {
    mesh_ = {};
    weld(points, triangles);
    std::set<std::array<lpq::Index, 3>> seen;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      lpq::Tri tri{of_[triangles[t][0]], of_[triangles[t][1]], of_[triangles[t][2]]};
      if (tri[0] == tri[1] || tri[1] == tri[2] || tri[2] == tri[0]) continue;
      auto key = tri;
      std::sort(key.begin(), key.end());
      if (!seen.insert(key).second) continue;
      mesh_.triangles.push_back(tri);
      mesh_.group.push_back(groups.empty() ? 0 : groups[t]);
    }
    orient();
    join();
    return mesh_;
  }

 private:
  using Key = std::pair<lpq::Index, lpq::Index>;

  void weld(const std::vector<lpq::Vec3>& points, const std::vector<lpq::Tri>& triangles) {
    std::vector<char> used(points.size(), 0);
    for (const lpq::Tri& tri : triangles)
      for (const lpq::Index v : tri) used[v] = 1;
    std::map<std::array<double, 3>, lpq::Index> known;
    of_.assign(points.size(), lpq::none);
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (!used[v]) continue;
      const lpq::Vec3 p = points[v];
      const auto [at, fresh] =
          known.insert({{p.x + 0.0, p.y + 0.0, p.z + 0.0}, mesh_.vertex_count()});
      if (fresh) mesh_.points.push_back(p);
      of_[v] = at->second;
    }
  }
  std::map<Key, std::vector<lpq::Index>> edges() const {
    std::map<Key, std::vector<lpq::Index>> result;
    for (lpq::Index e = 0; e < 3 * mesh_.triangle_count(); ++e)
      result[std::minmax(mesh_.origin(e), mesh_.target(e))].push_back(e);
    return result;
  }
  void orient() {
    const auto by_edge = edges();
    std::vector<char> done(mesh_.triangles.size(), 0);
    std::vector<char> turned(mesh_.triangles.size(), 0);
    const std::vector<lpq::Tri> before = mesh_.triangles;
    for (std::size_t seed = 0; seed < done.size(); ++seed) {
      std::vector<lpq::Index> stack{static_cast<lpq::Index>(seed)};
      if (done[seed]) continue;
      done[seed] = 1;
      while (!stack.empty()) {
        const lpq::Index t = stack.back();
        stack.pop_back();
        for (int k = 0; k < 3; ++k) {
          const lpq::Index a = before[t][k], b = before[t][(k + 1) % 3];
          const auto& sides = by_edge.at(std::minmax(a, b));
          if (sides.size() != 2) continue;
          const lpq::Index e = sides[0] / 3 == t ? sides[1] : sides[0], other = e / 3;
          if (done[other]) continue;
          done[other] = 1;
          turned[other] = turned[t] ^ (before[other][e % 3] == a);
          stack.push_back(other);
        }
      }
    }
    for (std::size_t t = 0; t < turned.size(); ++t)
      if (turned[t]) std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
  }
  void join() {
    mesh_.twins.assign(3 * mesh_.triangles.size(), lpq::none);
    for (const auto& [key, sides] : edges()) {
      if (sides.size() != 2 || mesh_.origin(sides[0]) == mesh_.origin(sides[1])) continue;
      mesh_.twins[sides[0]] = sides[1];
      mesh_.twins[sides[1]] = sides[0];
    }
  }

  lpq::SurfaceMesh mesh_;
  std::vector<lpq::Index> of_;
};

inline lpq::SurfaceMesh read_obj(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<lpq::Vec3> points;
  std::vector<lpq::Tri> triangles;
  std::vector<lpq::Index> groups;
  lpq::Index group = 0;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      lpq::Vec3 p;
      words >> p.x >> p.y >> p.z;
      points.push_back(p);
    } else if (word == "g") {
      ++group;
    } else if (word == "f") {
      std::vector<lpq::Index> corners;
      for (int i = 0; words >> word; corners.push_back(i))
        if ((i = std::stoi(word)) > 0)
          --i;
        else
          i += static_cast<int>(points.size());
      for (std::size_t k = 2; k < corners.size(); ++k) {
        triangles.push_back({corners[0], corners[k - 1], corners[k]});
        groups.push_back(group);
      }
    }
  }
  return SurfaceBuilder().build(std::move(points), triangles, groups);
}

/// Half-edges where the surface bends by more than `degrees`, where groups meet, and borders.
inline std::vector<char> sharp_edges(const lpq::SurfaceMesh& mesh, double degrees = 40) {
  const double least = std::cos(degrees * 3.14159265358979323846 / 180);
  std::vector<char> feature(mesh.twins.size(), 0);
  for (lpq::Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    const lpq::Index twin = mesh.twins[e];
    const lpq::Index t = lpq::triangle_of(e), o = lpq::triangle_of(twin);
    feature[e] = twin == lpq::none || mesh.group[t] != mesh.group[o];
    if (feature[e] || lpq::layout_of(mesh, t).area == 0 || lpq::layout_of(mesh, o).area == 0)
      continue;
    feature[e] = dot(axes_of(mesh, t).normal, axes_of(mesh, o).normal) < least;
  }
  return feature;
}

/// The .obj files of the shared surfaces, sorted; empty if they are absent.
inline std::vector<std::filesystem::path> shared_surfaces() {
  std::vector<std::filesystem::path> files;
  std::error_code missing;
  const auto root = std::filesystem::path(LPQ_SHARED_DATA) / "data" / "surfaces";
  for (const auto& entry : std::filesystem::directory_iterator(root, missing))
    if (entry.path().extension() == ".obj") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace lpq_test
