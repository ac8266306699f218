// See smoother.h.
#include "shell/shape/smoother.h"

#include <algorithm>
#include <cmath>

#include "shell/quality.h"

namespace lpq {
namespace {

constexpr double turned = -0.5;  // in place of eta
// Of the cover term, for a quad of the largest size. With half of it the tips of surfaces with
// features as small as quads are cut off.
constexpr double cover_weight = 1;
// Flatness from which quads are made even: over tips and ridges that would fold some.
constexpr double flat = 0.93;
constexpr int untangling_rounds = 8, untangling_steps = 25;
constexpr double mean_ratio_tolerance = 1e-3;
// Of the longest: angles at the ends of such a side say nothing.
constexpr double vanished = 1e-9;

}  // namespace

SquaredSides squared_sides(const ShellMesh& mesh, Index f) {
  const Face& face = mesh.faces[f];
  const int n = corner_count(face);
  SquaredSides sides{1e300, 0};
  for (int k = 0; k < n; ++k) {
    const double side = squared_length(mesh.points[face[(k + 1) % n]] - mesh.points[face[k]]);
    sides = {std::min(sides.least, side), std::max(sides.most, side)};
  }
  return sides;
}

double signed_eta(const ShapeGround& ground, const ShellMesh& mesh, Index f) {
  if (mesh.faces[f][3] == none) return 1;
  const SpaceQuad p = corners_of(mesh, f);
  const SquaredSides sides = squared_sides(mesh, f);
  if (sides.least < vanished * vanished * sides.most) return -1;
  if (!is_strictly_convex(p, ground.outside.at(mesh, f))) return -1;
  if (ground.outside.is_turned(mesh, f)) return turned;
  return quad_eta(p[0], p[1], p[2], p[3]);
}

ShapeSmoother::ShapeSmoother(const ShapeGround& ground, std::vector<VertexRole> roles,
                             const SmoothOptions& options, ShellMesh& mesh)
    : ground_(ground),
      options_(options),
      mesh_(mesh),
      freedom_(ground, std::move(roles), mesh),
      descent_(mesh, freedom_),
      normal_(mesh.faces.size()),
      unit_(mesh.faces.size()),
      flat_(mesh.faces.size()) {}

std::vector<double> ShapeSmoother::judge_all() const {
  std::vector<double> etas;
  etas.reserve(mesh_.faces.size());
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) etas.push_back(judge(static_cast<Index>(f)));
  return etas;
}

ShapeSmoother::Verdict ShapeSmoother::verdict() const {
  Verdict result;
  const SpaceEtaOptions options = eta_options();
  for (Index f = 0; f < static_cast<Index>(mesh_.faces.size()); ++f) {
    const double eta = judge(f);
    if (eta < 0) ++(eta == turned ? result.tangled.turned : result.tangled.nonconvex);
    result.worst = std::min(result.worst, eta);
    if (eta < 0 || mesh_.faces[f][3] == none) continue;
    SpaceQuad unused{};
    const Vec3 outside = ground_.outside.at(mesh_, f);
    result.energy +=
        eta_energy(corners_of(mesh_, f), target_unit(f), outside, options, unused).value;
  }
  return result;
}

DescentPart ShapeSmoother::part_above(double bound) const {
  DescentPart part;
  std::vector<char> moves(mesh_.points.size(), 1);
  for (Index f = 0; f < static_cast<Index>(mesh_.faces.size()); ++f) {
    if (mesh_.faces[f][3] != none && judge(f) >= bound) {
      part.faces.push_back(f);
      continue;
    }
    for (const Index v : mesh_.faces[f])
      if (v != none) moves[v] = 0;
  }
  for (Index v = 0; v < static_cast<Index>(moves.size()); ++v)
    if (moves[v] && freedom_.unknowns(v) > 0) part.vertices.push_back(v);
  return part;
}

SpaceEtaOptions ShapeSmoother::eta_options() const {
  SpaceEtaOptions energy;
  energy.size_weight = options_.size_weight;
  energy.area_weight = options_.area_weight;
  energy.rounding = options_.rounding;
  energy.floor_deviation = 1 - options_.eta_floor;
  energy.cover_weight = cover_weight / (ground_.largest_size * ground_.largest_size);
  return energy;
}

/// 1/h^2 of the target size.
double ShapeSmoother::target_unit(Index f) const {
  double h = 0;
  for (const Index v : mesh_.faces[f]) h += 0.25 * ground_.size_at(mesh_.places[v]);
  return 1 / (h * h);
}

/// 1/h^2 that makes the face's own corners about 1.
double ShapeSmoother::own_unit(Index f) const {
  const SpaceQuad p = corners_of(mesh_, f);
  double sum = 0;
  for (int k = 0; k < 4; ++k) sum += squared_length(p[(k + 1) & 3] - p[k]);
  return sum > 0 ? 4 / sum : 0;
}

int ShapeSmoother::descend_eta(const DescentPart& part, int iterations, double tolerance,
                               double area_factor) {
  for (const Index f : part.faces) {
    normal_[f] = ground_.outside.at(mesh_, f);
    unit_[f] = target_unit(f);
    flat_[f] = ground_.outside.flatness(mesh_, f) > flat;
  }
  const SpaceEtaOptions energy = eta_options();
  SpaceEtaOptions even = energy;
  even.area_weight *= area_factor;
  const auto of_face = [&](Index f, const SpaceQuad& p, SpaceQuad& gradient) {
    return eta_energy(p, unit_[f], normal_[f], flat_[f] ? even : energy, gradient);
  };
  return descent_.run(part, iterations, tolerance, of_face);
}

int ShapeSmoother::descend_mean_ratio(const DescentPart& part, int iterations, double epsilon) {
  for (const Index f : part.faces) {
    normal_[f] = ground_.outside.at(mesh_, f);
    unit_[f] = own_unit(f);
  }
  const MeanRatioOptions energy{.epsilon = epsilon};
  const auto of_face = [&](Index f, const SpaceQuad& p, SpaceQuad& gradient) {
    return mean_ratio_energy(p, unit_[f], normal_[f], energy, gradient);
  };
  return descent_.run(part, iterations, mean_ratio_tolerance, of_face);
}

/// As in cleanup/untangle.cpp.
void ShapeSmoother::untangle(const DescentPart& part) {
  double shrink = 1;
  for (int round = 0; round < untangling_rounds; ++round, shrink *= epsilon_shrink) {
    double worst = 1e300;
    for (const Index f : part.faces)
      worst = std::min(
          worst, smallest_corner(corners_of(mesh_, f), own_unit(f), ground_.outside.at(mesh_, f)));
    const bool valid = worst > untangled_corner;
    const double epsilon = valid ? 0 : shrink * std::min(untangling_epsilon(worst), most_epsilon);
    descend_mean_ratio(part, untangling_steps, epsilon);
    if (valid) return;
  }
}

std::vector<Freedom::State> ShapeSmoother::states() const {
  std::vector<Freedom::State> result;
  for (std::size_t v = 0; v < mesh_.points.size(); ++v)
    result.push_back(freedom_.state(static_cast<Index>(v)));
  return result;
}

void ShapeSmoother::restore(const std::vector<Freedom::State>& states) {
  for (std::size_t v = 0; v < states.size(); ++v) restore(static_cast<Index>(v), states[v]);
}

}  // namespace lpq
