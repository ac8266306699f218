// See short_sides.h.
#include "shell/shape/short_sides.h"

#include <algorithm>

#include "shell/shape/smoother.h"

namespace lpq {
namespace {

constexpr double short_share = 0.05, enough = short_share * short_share;
constexpr int rings = 2, steps = 30, most_rounds = 8;
constexpr double poor = 0.3;  // eta
constexpr double least_flatness = 0.7;

/// Squared, of the sides of all faces over the longest of the face.
double shortest_share(const ShellMesh& mesh) {
  double share = 1;
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f) {
    const SquaredSides sides = squared_sides(mesh, f);
    share = std::min(share, sides.most > 0 ? sides.least / sides.most : 0);
  }
  return share;
}

/// Does the surface bend little enough within each face that it is seen from one side?
bool is_plain(const ShapeGround& ground, const ShellMesh& mesh) {
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f)
    if (ground.outside.flatness(mesh, f) < least_flatness) return false;
  return true;
}

bool lengthen(const ShapeGround& ground, const SmoothOptions& options, ShapePatch& patch) {
  ShapeSmoother smoother(ground, patch.roles, options, patch.mesh);
  const ShapeSmoother::Verdict before = smoother.verdict();
  if (before.worst < 0 || !is_plain(ground, patch.mesh)) return false;
  for (int round = 0; round < most_rounds && shortest_share(patch.mesh) < enough; ++round)
    smoother.descend_mean_ratio(smoother.part_above(0), steps, 0);
  patch.roles = smoother.freedom().roles();
  return shortest_share(patch.mesh) >= enough &&
         smoother.verdict().worst >= std::min(poor, before.worst);
}

}  // namespace

bool has_short_side(const ShellMesh& mesh, Index f, double share) {
  const SquaredSides sides = squared_sides(mesh, f);
  return sides.least < share * share * sides.most;
}

bool SideLengthener::step() {
  const auto count = static_cast<Index>(mesh_.faces.size());
  while (next_ < count &&
         (corner_count(mesh_.faces[next_]) < 4 || !has_short_side(mesh_, next_, short_share)))
    ++next_;
  if (next_ == count) return false;
  ShapePatch patch = take_patch(mesh_, roles_, stars_, faces_around(mesh_, stars_, next_++, rings));
  if (lengthen(ground_, options_, patch)) {
    put_back(patch, mesh_, roles_);
    ++places_;
  }
  return true;
}

}  // namespace lpq
