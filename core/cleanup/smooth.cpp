#include "cleanup/smooth.h"

#include <algorithm>

#include "cleanup/descent.h"
#include "cleanup/mesh_part.h"
#include "cleanup/quad_topology.h"
#include "mesh/quality.h"

namespace lpq {
namespace {

constexpr double guarded_floor = 0.5;  // faces better than this may fall to it
constexpr double lifted_eta = 0.15;    // faces below are smoothed locally before all others
constexpr int lifting_rings = 2, lifting_steps = 25;
// Faces still below (needle corners) are left alone; more of them where the descent got stuck.
constexpr double pinned_below[] = {0.02, 0.1, 0.3};

// A face that is not strictly convex counts as -1.
double guarded_eta(const QuadMesh& mesh, const Face& face) {
  return is_strictly_convex(mesh.points, face) ? face_eta(mesh.points, face) : -1;
}

// Puts the vertices of every face that is now worse than `least` back to where they were, again and
// again while that spoils other faces; everything goes back if this does not settle.
void take_back(QuadMesh& mesh, const std::vector<Vec2>& before, const std::vector<double>& least) {
  constexpr int rounds = 20;
  for (int round = 0; round < rounds; ++round) {
    bool spoilt = false;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      if (guarded_eta(mesh, mesh.faces[f]) >= least[f]) continue;
      spoilt = true;
      for (int k = 0; k < corner_count(mesh.faces[f]); ++k)
        mesh.points[mesh.faces[f][k]] = before[mesh.faces[f][k]];
    }
    if (!spoilt) return;
  }
  mesh.points = before;
}

std::vector<double> all_etas(const QuadMesh& mesh) {
  std::vector<double> etas;
  etas.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) etas.push_back(guarded_eta(mesh, face));
  return etas;
}

// No face may end below the worst that touched it at the start, nor be asked to stay above
// `guarded_floor`.
std::vector<double> least_allowed(const QuadMesh& mesh, const std::vector<double>& etas) {
  std::vector<double> at_vertex(mesh.points.size(), guarded_floor), least(mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (int k = 0; k < corner_count(mesh.faces[f]); ++k)
      at_vertex[mesh.faces[f][k]] = std::min(at_vertex[mesh.faces[f][k]], std::max(0.0, etas[f]));
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    least[f] = guarded_floor;
    for (int k = 0; k < corner_count(mesh.faces[f]); ++k)
      least[f] = std::min(least[f], at_vertex[mesh.faces[f][k]]);
    if (etas[f] < 0) least[f] = -1;
  }
  return least;
}

// Nearly flat faces allow only tiny steps, and a line search over the whole mesh would have to obey
// them all: so these are smoothed first, each with its neighbours alone.
void lift_worst(QuadMesh& mesh, std::vector<double>& etas, const std::vector<double>& targets,
                const EtaEnergyOptions& energy) {
  std::vector<Index> seeds;
  for (std::size_t f = 0; f < etas.size(); ++f)
    if (etas[f] >= 0 && etas[f] < lifted_eta) seeds.push_back(static_cast<Index>(f));
  if (seeds.empty()) return;
  const Csr<Index> stars = faces_at_vertices(mesh);
  for (const std::vector<Index>& cluster : face_clusters(mesh, stars, seeds, lifting_rings)) {
    MeshPart part = extract_part(mesh, stars, cluster);
    const std::vector<double> sizes = vertex_sizes(part.mesh);
    const std::vector<double> unit = own_inverse_squares(part.mesh.faces, part.mesh.points);
    std::vector<double> target, old;
    for (const Index f : cluster) {
      target.push_back(etas[f] < 0 ? 0 : targets[f]);
      old.push_back(etas[f]);
    }
    descend(part.mesh, sizes, lifting_steps,
            [&](std::span<const Vec2> points, std::span<Vec2> gradient) {
              return mean_ratio_energy(part.mesh.faces, points, unit, {}, gradient);
            });
    descend(part.mesh, sizes, lifting_steps,
            [&](std::span<const Vec2> points, std::span<Vec2> gradient) {
              return eta_energy(part.mesh.faces, points, target, energy, gradient);
            });
    const std::vector<double> now = all_etas(part.mesh);
    const auto worst = [](const std::vector<double>& e) {
      return *std::min_element(e.begin(), e.end());
    };
    if (worst(now) <= worst(old)) continue;
    put_back(part, mesh);
    for (std::size_t i = 0; i < cluster.size(); ++i) etas[cluster[i]] = now[i];
  }
}

// Sizes of the vertices, 0 for those of faces with eta below the bound; such faces count no more.
std::vector<double> pin_worst(const QuadMesh& mesh, double bound, std::vector<double>& targets) {
  std::vector<double> sizes = vertex_sizes(mesh);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (guarded_eta(mesh, mesh.faces[f]) >= bound) continue;
    targets[f] = 0;
    for (int k = 0; k < corner_count(mesh.faces[f]); ++k)
      if (const Index v = mesh.faces[f][k]; v >= mesh.fixed) sizes[v - mesh.fixed] = 0;
  }
  return sizes;
}

std::vector<Vec2> at_centres(const QuadMesh& mesh, const Fields& fields,
                             const std::vector<Vec2>& values) {
  std::vector<Vec2> result;
  if (values.empty()) return result;
  Index hint = none;
  for (const Face& face : mesh.faces)
    result.push_back(fields.interpolate(values, centre_of(mesh.points, face), hint));
  return result;
}

}  // namespace

std::vector<double> target_inverse_squares(const QuadMesh& mesh, const Fields& fields) {
  std::vector<double> result;
  result.reserve(mesh.faces.size());
  Index hint = none;
  for (const Face& face : mesh.faces) {
    const double h = fields.size(centre_of(mesh.points, face), hint);
    result.push_back(1 / (h * h));
  }
  return result;
}

std::vector<double> size_shares(const QuadMesh& mesh, const Fields& fields) {
  std::vector<double> result;
  result.reserve(mesh.faces.size());
  Index hint = none;
  for (const Face& face : mesh.faces)
    result.push_back(share_at_slope(fields.slope(centre_of(mesh.points, face), hint)));
  return result;
}

std::vector<Vec2> target_pulls(const QuadMesh& mesh, const Fields& fields) {
  return at_centres(mesh, fields, fields.pull);
}

std::vector<Vec2> target_stretches(const QuadMesh& mesh, const Fields& fields) {
  return at_centres(mesh, fields, fields.stretch);
}

void smooth_eta(QuadMesh& mesh, const Fields& fields, const SmoothOptions& options) {
  EtaEnergyOptions energy{.size_weight = options.size_weight,
                          .area_weight = options.area_weight,
                          .rounding = options.rounding,
                          .floor_deviation = 1 - options.eta_floor};
  std::vector<double> etas = all_etas(mesh);
  const std::vector<double> least = least_allowed(mesh, etas);
  const std::vector<Vec2> before = mesh.points;
  std::vector<double> targets = target_inverse_squares(mesh, fields);
  if (options.lift) lift_worst(mesh, etas, targets, energy);
  const std::vector<Vec2> pulls = target_pulls(mesh, fields);
  const std::vector<double> shares = size_shares(mesh, fields);
  const std::vector<Vec2> stretches = target_stretches(mesh, fields);
  energy.size_share = shares;
  energy.stretch = stretches;
  int left = options.iterations;
  for (const double bound : pinned_below) {
    if (left <= 0) break;
    const std::vector<double> sizes = pin_worst(mesh, bound, targets);
    left -= descend(mesh, sizes, left, [&](std::span<const Vec2> points, std::span<Vec2> gradient) {
      return eta_energy(mesh.faces, points, targets, energy, gradient, pulls);
    });
  }
  take_back(mesh, before, least);
}

}  // namespace lpq
