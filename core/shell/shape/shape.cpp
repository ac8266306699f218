// See shape.h.
#include "shell/shape/shape.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "shell/shape/acute.h"
#include "shell/shape/mend.h"
#include "shell/shape/short_sides.h"
#include "shell/shape/smoother.h"
#include "shell/shape/tips.h"

namespace lpq {
namespace {

constexpr int rounds = 3;              // of the descent over all vertices, anchored anew
constexpr double tolerance = 1e-6;     // of that
constexpr double guarded_floor = 0.5;  // faces better than this may fall to it
// Faces still below (needle corners) are left alone; more of them where the descent got stuck.
constexpr double pinned_below[] = {0.02, 0.1, 0.3};
// Of the iterations asked for: a descent that made fewer may have got stuck somewhere.
constexpr double stalled_share = 0.2;
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
    if (etas[f] < 0) least[f] = etas[f];
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

/// The descent over all vertices, in steps of one that ends where it gets stuck.
class WholeDescent {
 public:
  WholeDescent(const ShapeGround& ground, const SmoothOptions& options,
               const std::vector<VertexRole>& roles, ShellMesh& mesh)
      : most_(options.iterations), mesh_(mesh), smoother_(ground, roles, options, mesh) {}

  bool step() {
    if (round_ == rounds) return false;
    if (bound_ == std::begin(pinned_below)) begin_round();
    if (left_ > 0)
      left_ -= smoother_.descend_eta(smoother_.part_above(*bound_), left_, tolerance, evenness);
    if (++bound_ == std::end(pinned_below)) end_round();
    return true;
  }

  double share() const { return static_cast<double>(round_) / rounds; }
  int iterations() const { return all_; }
  const std::vector<VertexRole>& roles() const { return smoother_.freedom().roles(); }

 private:
  void begin_round() {
    least_ = least_allowed(mesh_, smoother_.judge_all());
    before_ = smoother_.states();
    given_ = left_ = std::min(std::max(most_ / rounds, 1), most_ - all_);
  }

  void end_round() {
    take_back(mesh_, before_, least_, smoother_);
    all_ += given_ - left_;
    round_ = left_ == given_ ? rounds : round_ + 1;
    bound_ = std::begin(pinned_below);
  }

  int most_;  // iterations of all rounds
  const ShellMesh& mesh_;
  ShapeSmoother smoother_;
  int round_ = 0, given_ = 0, left_ = 0, all_ = 0;  // iterations: of this round, left of it, made
  const double* bound_ = std::begin(pinned_below);
  std::vector<double> least_;           // #F
  std::vector<Freedom::State> before_;  // #V
};

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

class ShapeFinisher::Run {
 public:
  Run(const Charted& charted, const SmoothOptions& options, ShellMesh mesh)
      : charted_(charted),
        options_(options),
        mesh_(std::move(mesh)),
        ground_(charted),
        roles_(vertex_roles(charted, ground_.tracks, mesh_)) {
    settle_nodes(ground_, roles_, mesh_);
    stats_.tangled_before = count_tangled(ground_, mesh_);
    mender_.emplace(ground_, options_, mesh_, roles_);
  }

  bool step() {
    switch (part_) {
      case Part::flat: return mender_->mend_next(flat, true) || end_flat();
      case Part::descent: return descent_->step() || end_descent();
      case Part::patches: return mender_->smooth_next() || begin_tips();
      case Part::tips: return tips_->step() || begin_poor();
      case Part::poor: return mender_->mend_next(poor, false) || end_poor();
      case Part::tips_again: return tips_->step() || end_tips();
      case Part::sides: return sides_->step() || finish();
      case Part::done: break;
    }
    return false;
  }

  double share() const {
    switch (part_) {
      case Part::flat: return 0.2 * mender_->share();
      case Part::descent: return 0.2 + 0.5 * descent_->share();
      case Part::patches: return 0.7 + 0.1 * mender_->share();
      case Part::tips: return 0.8;
      case Part::poor: return 0.8 + 0.15 * mender_->share();
      case Part::tips_again: return 0.95;
      case Part::sides: return 0.99;
      case Part::done: break;
    }
    return 1;
  }
  const ShapeStats& stats() const { return stats_; }
  ShellMesh take() { return std::move(mesh_); }

 private:
  enum class Part { flat, descent, patches, tips, poor, tips_again, sides, done };

  bool end_flat() {
    stats_.refilled += mender_->stats().refilled;
    mender_.reset();
    descent_.emplace(ground_, options_, roles_, mesh_);
    part_ = Part::descent;
    return true;
  }

  bool end_descent() {
    stats_.iterations = descent_->iterations();
    roles_ = std::vector<VertexRole>(descent_->roles());
    descent_.reset();
    if (stats_.iterations >= stalled_share * options_.iterations) return begin_tips();
    mender_.emplace(ground_, options_, mesh_, roles_);
    part_ = Part::patches;
    return true;
  }

  bool begin_tips() {
    mender_.reset();
    stats_.eased = ease_corners(charted_, ground_, options_, mesh_, roles_);
    tips_.emplace(charted_, ground_, options_, mesh_, roles_);
    part_ = Part::tips;
    return true;
  }

  bool begin_poor() {
    stats_.reached = tips_->reached();
    tips_.reset();
    mender_.emplace(ground_, options_, mesh_, roles_);
    part_ = Part::poor;
    return true;
  }

  bool end_poor() {
    stats_.refilled += mender_->stats().refilled;
    mender_.reset();
    tips_.emplace(charted_, ground_, options_, mesh_, roles_);
    part_ = Part::tips_again;
    return true;
  }

  bool end_tips() {
    stats_.reached += tips_->reached();
    tips_.reset();
    sides_.emplace(ground_, options_, mesh_, roles_);
    part_ = Part::sides;
    return true;
  }

  bool finish() {
    stats_.tangled_after = count_tangled(ground_, mesh_);
    part_ = Part::done;
    return false;
  }

  Charted charted_;
  SmoothOptions options_;
  ShellMesh mesh_;
  ShapeGround ground_;
  std::vector<VertexRole> roles_;
  std::optional<Mender> mender_;         // of the part that mends or smooths patches
  std::optional<WholeDescent> descent_;  // of the part between
  std::optional<TipReacher> tips_;       // of the parts for tips
  std::optional<SideLengthener> sides_;  // of the last part
  Part part_ = Part::flat;
  ShapeStats stats_;
};

ShapeFinisher::ShapeFinisher(const Charted& charted, const SmoothOptions& options, ShellMesh mesh)
    : run_(std::make_unique<Run>(charted, options, std::move(mesh))) {}
ShapeFinisher::~ShapeFinisher() = default;

bool ShapeFinisher::step() { return run_->step(); }
double ShapeFinisher::share() const { return run_->share(); }
const ShapeStats& ShapeFinisher::stats() const { return run_->stats(); }
ShellMesh ShapeFinisher::take() { return run_->take(); }

}  // namespace lpq
