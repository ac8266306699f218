// See shape.h.
#include "shell/shape/shape.h"

#include <algorithm>

#include "shell/shape/mend.h"
#include "shell/shape/smoother.h"

namespace lpq {
namespace {

constexpr int rounds = 3;              // of the descent over all vertices, anchored anew
constexpr double guarded_floor = 0.5;  // faces better than this may fall to it
// Faces still below (needle corners) are left alone; more of them where the descent got stuck.
constexpr double pinned_below[] = {0.02, 0.1, 0.3};
// Of the iterations asked for: a descent that made fewer may have got stuck somewhere.
constexpr double stalled_share = 0.6;
// Faces below are mended: before the descent over all those that would hold it up, after it those
// that a person would see.
constexpr double flat = 0.4, poor = 0.45;

/// No face may end below the worst that touched it, nor be asked to stay above the floor.
std::vector<double> least_allowed(const ShellMesh& mesh, const std::vector<double>& etas) {
  std::vector<double> at_vertex(mesh.points.size(), guarded_floor), least(mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (const Index v : mesh.faces[f])
      if (v != none) at_vertex[v] = std::min(at_vertex[v], std::max(0.0, etas[f]));
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    least[f] = guarded_floor;
    for (const Index v : mesh.faces[f])
      if (v != none) least[f] = std::min(least[f], at_vertex[v]);
    if (etas[f] < 0) least[f] = -1;
  }
  return least;
}

/// Puts the vertices of every face that is now worse than `least` back to where they were, again
/// and again while that spoils other faces; everything goes back if this does not settle.
void take_back(const ShellMesh& mesh, const std::vector<Freedom::State>& before,
               const std::vector<double>& least, ShapeSmoother& smoother) {
  constexpr int most = 200;
  for (int i = 0; i < most; ++i) {
    bool spoilt = false;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      if (smoother.judge(static_cast<Index>(f)) >= least[f]) continue;
      spoilt = true;
      for (const Index v : mesh.faces[f])
        if (v != none) smoother.restore(v, before[v]);
    }
    if (!spoilt) return;
  }
  smoother.restore(before);
}

int smooth_all(const ShapeGround& ground, const SmoothOptions& options, ShellMesh& mesh,
               std::vector<VertexRole>& roles) {
  ShapeSmoother smoother(ground, roles, options, mesh);
  int all = 0;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<double> least = least_allowed(mesh, smoother.judge_all());
    const std::vector<Freedom::State> before = smoother.states();
    int left = options.iterations / rounds;
    for (const double bound : pinned_below)
      if (left > 0) left -= smoother.descend_eta(smoother.part_above(bound), left);
    take_back(mesh, before, least, smoother);
    const int done = options.iterations / rounds - left;
    all += done;
    if (done == 0) break;
  }
  roles = smoother.freedom().roles();
  return all;
}

/// Nodes exactly where their roles say, so that what lies beside them is known.
void settle_nodes(const ShapeGround& ground, const std::vector<VertexRole>& roles,
                  ShellMesh& mesh) {
  std::vector<Index> sliding;
  for (std::size_t v = 0; v < roles.size(); ++v)
    if (roles[v].kind == VertexRole::Kind::slides) sliding.push_back(static_cast<Index>(v));
  Freedom(ground, roles, mesh).anchor(sliding);
}

Index count_tangled(const ShapeGround& ground, const ShellMesh& mesh) {
  Index count = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    count += signed_eta(ground, mesh, static_cast<Index>(f)) < 0;
  return count;
}

}  // namespace

ShapeStats optimise_shape(const Charted& charted, const SmoothOptions& options, ShellMesh& mesh) {
  const ShapeGround ground(charted);
  std::vector<VertexRole> roles = vertex_roles(charted, ground.tracks, mesh);
  settle_nodes(ground, roles, mesh);
  ShapeStats stats;
  stats.tangled_before = count_tangled(ground, mesh);
  stats.refilled += mend_worst(ground, options, flat, true, mesh, roles).refilled;
  stats.iterations = smooth_all(ground, options, mesh, roles);
  if (stats.iterations < stalled_share * options.iterations)
    smooth_patches(ground, options, mesh, roles);
  stats.refilled += mend_worst(ground, options, poor, false, mesh, roles).refilled;
  stats.tangled_after = count_tangled(ground, mesh);
  return stats;
}

}  // namespace lpq
