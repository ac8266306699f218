// See quality.h.
#include "shell/quality.h"

#include <algorithm>
#include <cmath>

#include "numerics/elementary.h"
#include "shell/place.h"
#include "shell/sides.h"
#include "shell/topology.h"

namespace lpq {
namespace {

bool is_bent(const ShellMesh& mesh, const Face& face) {
  return has_reflex_corner(mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]],
                           mesh.points[face[3]]);
}

/// Vertices on edges of one face only.
std::vector<char> border_vertices(const ShellMesh& mesh) {
  std::vector<char> border(mesh.points.size(), 0);
  for_each_edge(sides_by_edge(mesh.faces), [&](std::span<const FaceSide> on_edge) {
    if (on_edge.size() == 1)
      for (const Index v : on_edge[0].ends) border[v] = 1;
  });
  return border;
}

std::vector<Index> valences_of(const ShellMesh& mesh) {
  std::vector<Index> valence(mesh.points.size(), 0);
  for (const Face& face : mesh.faces)
    for (int k = 0; k < corner_count(face); ++k) ++valence[face[k]];
  return valence;
}

}  // namespace

double quad_eta(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 side[4] = {b - a, c - b, d - c, a - d};
  double worst = 0;
  for (int k = 0; k < 4; ++k) {
    const Vec3 before = side[(k + 3) & 3];
    const double sine = length(cross(before, side[k]));
    const double cosine = std::abs(dot(before, side[k]));
    if (!(sine > 0)) return 0;
    worst = std::max(worst, arc_tangent(cosine, sine));
  }
  return std::max(1 - 2 / pi * worst, 0.0);
}

QuadQuality shell_quality(const ShellMesh& mesh) {
  QuadQuality quality;
  std::vector<double> etas;
  for (const Face& face : mesh.faces) {
    if (corner_count(face) == 3) {
      ++quality.triangles;
      continue;
    }
    const double eta = quad_eta(mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]],
                                mesh.points[face[3]]);
    if (is_bent(mesh, face)) ++quality.nonconvex;
    etas.push_back(eta);
    quality.eta_mean += eta;
    ++quality.eta_histogram[std::min(static_cast<int>(20 * eta), 19)];
  }
  quality.quads = static_cast<Index>(etas.size());
  if (!etas.empty()) {
    quality.eta_mean /= static_cast<double>(etas.size());
    std::sort(etas.begin(), etas.end());
    quality.eta_min = etas.front();
    quality.eta_p5 = percentile(etas, 0.05);
  }
  count_valences(valences_of(mesh), border_vertices(mesh), quality);
  return quality;
}

SizeFidelity shell_size_fidelity(const ShellMesh& mesh, std::span<const Tri> surface_triangles,
                                 std::span<const double> size) {
  const auto size_of = [&](Index v) { return size_at(surface_triangles, mesh.places[v], size); };
  std::vector<double> ratio;
  for_each_edge(sides_by_edge(mesh.faces), [&](std::span<const FaceSide> on_edge) {
    const auto [a, b] = on_edge[0].ends;
    ratio.push_back(distance(mesh.points[a], mesh.points[b]) / (0.5 * (size_of(a) + size_of(b))));
  });
  return size_fidelity(std::move(ratio));
}

}  // namespace lpq
