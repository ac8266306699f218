// See short_sides.h.
#include "shell/shape/short_sides.h"

#include <algorithm>

#include "shell/shape/smoother.h"

namespace lpq {
namespace {

constexpr double short_share = 0.05;
constexpr int rings = 2, steps = 30, most_rounds = 8;
constexpr double poor = 0.3;  // eta
constexpr double least_gain = 1.1;

/// Squared, of the sides of all faces over the longest of the face.
double shortest_share(const ShellMesh& mesh) {
  double share = 1;
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f) {
    const SquaredSides sides = squared_sides(mesh, f);
    share = std::min(share, sides.most > 0 ? sides.least / sides.most : 0);
  }
  return share;
}

bool lengthen(const ShapeGround& ground, const SmoothOptions& options, ShapePatch& patch) {
  ShapeSmoother smoother(ground, patch.roles, options, patch.mesh);
  const ShapeSmoother::Verdict before = smoother.verdict();
  const double share = shortest_share(patch.mesh);
  for (int round = 0; round < most_rounds; ++round) {
    smoother.descend_mean_ratio(smoother.part_above(0), steps, 0);
    if (shortest_share(patch.mesh) >= short_share * short_share) break;
  }
  patch.roles = smoother.freedom().roles();
  const ShapeSmoother::Verdict after = smoother.verdict();
  return after.tangled <= before.tangled && after.worst >= std::min(poor, before.worst) &&
         shortest_share(patch.mesh) > least_gain * share;
}

}  // namespace

bool has_short_side(const ShellMesh& mesh, Index f, double share) {
  const SquaredSides sides = squared_sides(mesh, f);
  return sides.least < share * share * sides.most;
}

Index lengthen_sides(const ShapeGround& ground, const SmoothOptions& options, ShellMesh& mesh,
                     std::vector<VertexRole>& roles) {
  const Csr<Index> stars = faces_at_vertices(mesh);
  Index places = 0;
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f) {
    if (corner_count(mesh.faces[f]) < 4 || !has_short_side(mesh, f, short_share)) continue;
    ShapePatch patch = take_patch(mesh, roles, stars, faces_around(mesh, stars, f, rings));
    if (!lengthen(ground, options, patch)) continue;
    put_back(patch, mesh, roles);
    ++places;
  }
  return places;
}

}  // namespace lpq
