// See coarse_ground.h.
#include "shell/coarse_ground.h"

#include "field/field.h"
#include "shell/nearby_places.h"
#include "shell/place.h"
#include "surface/frames.h"
#include "surface/size_field.h"

namespace lpq {
namespace {

// What is mapped in windows, by factors that cost n^1.5, is 30 times the surface's triangles
// altogether. Four surfaces of 363,000 to 1.29 million had the stage 4 to 45 times as fast.
constexpr Index least_triangles = 100'000;
constexpr double least_for_a_quad = 40;
// Sides of coarse triangles in mesh sizes, at most: about a dozen to a quad, as many as surfaces of
// ordinary fineness have.
constexpr double longest_side = 0.6;

std::vector<double> longest_sides(const Charted& charted) {
  std::vector<double> longest;
  longest.reserve(charted.size.size());
  for (const double h : charted.size) longest.push_back(longest_side * h);
  return longest;
}

SurfaceFeatures features_of(const CoarseSurface& coarse, const SurfaceFeatures& fine) {
  SurfaceFeatures features;
  features.edges = surface_edges(coarse.mesh.triangles, coarse.mesh.vertex_count());
  features.kind.assign(features.edges.ends.size(), FeatureKind::smooth);
  for (std::size_t e = 0; e < coarse.feature.size(); ++e)
    if (coarse.feature[e]) features.kind[features.edges.edge_of[e]] = FeatureKind::marked;
  for (const Index v : coarse.vertex) features.corner.push_back(fine.corner[v]);
  for (const Index t : coarse.triangle) features.face.push_back(fine.face[t]);
  features.face_count = fine.face_count;
  return features;
}

Vec3 centroid_of(const SurfaceMesh& mesh, Index t) {
  const auto [a, b, c] = mesh.triangles[t];
  return (1.0 / 3) * (mesh.points[a] + mesh.points[b] + mesh.points[c]);
}

}  // namespace

bool wants_coarse_ground(const Charted& charted) {
  const double triangles = charted.mesh.triangle_count();
  return triangles >= least_triangles &&
         triangles >= least_for_a_quad * surface_capacity(charted.mesh, charted.size);
}

CoarseGround::CoarseGround(const Charted& fine)
    : fine_(fine),
      coarse_(coarsen(fine.mesh, fine.features.half_edges(), longest_sides(fine))),
      features_(features_of(coarse_, fine.features)) {
  for (const Index v : coarse_.vertex) size_.push_back(fine.size[v]);
  carry_crosses();
}

/// From the triangle of the fine surface that is nearest to the middle, turned as its axes are.
void CoarseGround::carry_crosses() {
  const NearbyPlaces on_fine(fine_.mesh, fine_.features.face);
  for (Index t = 0; t < coarse_.mesh.triangle_count(); ++t) {
    Tri around = coarse_.mesh.triangles[t];
    for (Index& v : around) v = coarse_.vertex[v];
    const SurfacePlace place =
        on_fine.nearest(centroid_of(coarse_.mesh, t), features_.face[t], around);
    const Vec3 x = axes_of(fine_.mesh, place.triangle).x;
    const TriangleAxes axes = axes_of(coarse_.mesh, t);
    const Vec2 turned{dot(x, axes.x), dot(x, axes.y)};
    cross_.z.push_back(complex_product(cross_of(turned), fine_.cross.z[place.triangle]));
  }
}

Charted CoarseGround::charted() const {
  return {coarse_.mesh, features_,   cross_,       size_,
          fine_.atlas,  fine_.lines, fine_.curves, fine_.nodes};
}

void CoarseGround::lower(ShellMesh& mesh) const {
  const NearbyPlaces on_coarse(coarse_.mesh, features_.face);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Index t = mesh.places[v].triangle;
    if (t == none) continue;
    Tri around = fine_.mesh.triangles[t];
    for (Index& w : around) w = coarse_.home[w];
    mesh.places[v] = on_coarse.nearest(mesh.points[v], fine_.features.face[t], around);
  }
}

void CoarseGround::raise(const ShellMesh& before, ShellMesh& mesh) const {
  const NearbyPlaces on_fine(fine_.mesh, fine_.features.face);
  std::size_t next = 0;  // of the vertices before
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (!mesh.is_free(v)) {
      while (before.is_free(next)) ++next;
      mesh.places[v] = before.places[next++];
      continue;
    }
    const Index t = mesh.places[v].triangle;
    if (t == none) continue;
    Tri around = coarse_.mesh.triangles[t];
    for (Index& w : around) w = coarse_.vertex[w];
    mesh.places[v] = on_fine.nearest(mesh.points[v], features_.face[t], around);
    mesh.points[v] = point_at(fine_.mesh, mesh.places[v]);
  }
}

}  // namespace lpq
