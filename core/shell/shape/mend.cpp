// See mend.h.
#include "shell/shape/mend.h"

#include <algorithm>

#include "base/sort_numbers.h"
#include "shell/shape/refills.h"
#include "shell/shape/short_sides.h"

namespace lpq {
namespace {

constexpr int rings = 2;
constexpr int smoothed_rings = 5, covered_rings = 3;  // of patches that cover the mesh
constexpr int mean_ratio_rounds = 6, mean_ratio_steps = 15, eta_steps = 40;
constexpr double eta_tolerance = 1e-4;
constexpr double good = 0.98;         // eta; patches without worse quads have nothing to gain
constexpr double least_moved = 0.02;  // eta; worse quads stay as they are while others move
// Of the longest side of a face: a side that is shorter still grows.
constexpr double shortest_side = 0.03;
// Of the mesh size: a change of connectivity adds no side that is shorter, however good its angles.
constexpr double vanished_side = 1e-4;
// Energy that a change of connectivity must save: about one quad of eta 0.55 made good. A pair of
// irregular vertices is not worth less.
constexpr double least_saving = 1;
// Of all faces, beside a few: where more are bad, mending one by one is not the remedy.
constexpr double most_seeds = 0.02;
constexpr std::size_t some_seeds = 100;

bool is_better(const ShapeSmoother::Verdict& a, const ShapeSmoother::Verdict& b, double saving) {
  if (a.tangled != b.tangled) return a.tangled < b.tangled;
  return a.energy < b.energy - saving && a.worst >= b.worst;
}

bool has_short_side(const ShellMesh& mesh) {
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f)
    if (has_short_side(mesh, f, shortest_side)) return true;
  return false;
}

}  // namespace

class Mender::Run {
 public:
  Run(const ShapeGround& ground, const SmoothOptions& options, ShellMesh& mesh,
      std::vector<VertexRole>& roles)
      : ground_(ground),
        options_(options),
        mesh_(mesh),
        roles_(roles),
        stars_(mesh),
        seeds_left_(some_seeds +
                    static_cast<std::size_t>(most_seeds * static_cast<double>(mesh.faces.size()))),
        covered_(mesh.faces.size(), 0) {}

  bool mend_next(double bound, bool refill) {
    // New faces come last, and may be seeds again; every change saves energy.
    while (next_ < static_cast<Index>(mesh_.faces.size()) && seeds_left_ > 0) {
      const Index f = next_++;
      if (mesh_.faces[f][0] == none || signed_eta(ground_, mesh_, f) >= bound) continue;
      mend(f, refill);
      --seeds_left_;
      return true;
    }
    sweep_unused(mesh_, roles_);
    return false;
  }

  bool smooth_next() {
    while (next_ < static_cast<Index>(covered_.size()) && covered_[next_]) ++next_;
    if (next_ == static_cast<Index>(covered_.size())) return false;
    smooth_around(next_);
    return true;
  }

  double share() const {
    return mesh_.faces.empty()
               ? 1
               : static_cast<double>(next_) / static_cast<double>(mesh_.faces.size());
  }
  const MendStats& stats() const { return stats_; }

 private:
  using Verdict = ShapeSmoother::Verdict;

  void smooth_around(Index f) {
    for (const Index g : faces_around(f, covered_rings)) covered_[g] = 1;
    ShapePatch patch = take_patch(mesh_, roles_, stars_, faces_around(f, smoothed_rings));
    ShapeSmoother smoother(ground_, patch.roles, options_, patch.mesh);
    const Verdict before = smoother.verdict();
    if (before.worst >= good) return;
    smoother.descend_eta(smoother.part_above(least_moved), eta_steps, eta_tolerance, evenness);
    if (!is_better(smoother.verdict(), before, 0)) return;
    patch.roles = smoother.freedom().roles();
    put_back(patch, mesh_, roles_);
  }

  Verdict verdict(ShapePatch& patch) const {
    return ShapeSmoother(ground_, patch.roles, options_, patch.mesh).verdict();
  }

  Verdict smooth(ShapePatch& patch) const { return smooth_patch(ground_, options_, patch); }

  std::vector<Index> faces_around(Index f, int width) const {
    return lpq::faces_around(mesh_, stars_, f, width);
  }

  Index count_vanished_sides(const ShellMesh& mesh) const {
    Index count = 0;
    for (const Face& face : mesh.faces) {
      const double least = vanished_side * ground_.size_at(mesh.places[face[0]]);
      for (int k = 0, n = corner_count(face); k < n; ++k)
        count += distance(mesh.points[face[(k + 1) % n]], mesh.points[face[k]]) < least;
    }
    return count;
  }

  void mend(Index f, bool refill) {
    ShapePatch best = take_patch(mesh_, roles_, stars_, faces_around(f, rings));
    std::vector<ShapePatch> tries;
    if (refill || signed_eta(ground_, mesh_, f) < 0)
      tries = refills(ground_, best, index_of(f, best.faces));
    Verdict least = verdict(best);
    const Index vanished = count_vanished_sides(best.mesh);
    bool better = false;
    ShapePatch moved = best;
    if (const Verdict now = smooth(moved); is_better(now, least, 0)) {
      best = std::move(moved);
      least = now;
      better = true;
    }
    for (ShapePatch& patch : tries) {
      const Verdict now = smooth(patch);
      if (!is_better(now, least, best.changed ? 0 : least_saving)) continue;
      if (count_vanished_sides(patch.mesh) > vanished) continue;
      best = std::move(patch);
      least = now;
      better = true;
    }
    if (!better) return;
    ++(best.changed ? stats_.refilled : stats_.moved);
    put_back(best, mesh_, roles_);
    if (best.changed) stars_.update(mesh_, best);
  }

  const ShapeGround& ground_;
  SmoothOptions options_;
  ShellMesh& mesh_;
  std::vector<VertexRole>& roles_;
  FaceStars stars_;
  Index next_ = 0;  // face
  std::size_t seeds_left_;
  std::vector<char> covered_;  // #F
  MendStats stats_;
};

Mender::Mender(const ShapeGround& ground, const SmoothOptions& options, ShellMesh& mesh,
               std::vector<VertexRole>& roles)
    : run_(std::make_unique<Run>(ground, options, mesh, roles)) {}
Mender::~Mender() = default;

bool Mender::mend_next(double bound, bool refill) { return run_->mend_next(bound, refill); }
bool Mender::smooth_next() { return run_->smooth_next(); }
double Mender::share() const { return run_->share(); }
const MendStats& Mender::stats() const { return run_->stats(); }

ShapeSmoother::Verdict smooth_patch(const ShapeGround& ground, const SmoothOptions& options,
                                    ShapePatch& patch, double area_factor) {
  ShapeSmoother smoother(ground, patch.roles, options, patch.mesh);
  if (smoother.verdict().worst < 0) smoother.untangle(smoother.part_above(-1));
  // Steps are short where sides are: sides that nearly vanished grow round by round.
  for (int round = 0; round < mean_ratio_rounds; ++round) {
    smoother.descend_mean_ratio(smoother.part_above(0), mean_ratio_steps, 0);
    if (!has_short_side(patch.mesh)) break;
  }
  smoother.descend_eta(smoother.part_above(0), eta_steps, eta_tolerance, area_factor);
  patch.roles = smoother.freedom().roles();
  return smoother.verdict();
}

}  // namespace lpq
