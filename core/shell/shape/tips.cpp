// See tips.h.
#include "shell/shape/tips.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/sort_numbers.h"
#include "shell/shape/cover.h"
#include "shell/shape/mend.h"

namespace lpq {
namespace {

// Of the mean side of the nearest quad: places farther off are tips; what is beyond the lower bound
// is to become less in all.
constexpr double far_off = 0.33, near_enough = 0.3;
constexpr int rings_that_move[] = {3, 2, 1};  // fewer where more would uncover other places
constexpr double poor = 0.4;                  // eta that quads may fall to
constexpr double slack = 0.005;               // of a worse one
constexpr int most_passes = 6;                // the later ones for what the first uncovered
// A mesh that is too coarse all over stays as it is.
constexpr std::size_t most_tips = 1000;
constexpr double most_faces = 0.25;  // of all, that have tips
constexpr int most_trials = 1000;
constexpr std::size_t places_in_a_step = 100000;

}  // namespace

class TipReacher::Run {
 public:
  Run(const Charted& charted, const ShapeGround& ground, const SmoothOptions& options,
      ShellMesh& mesh, std::vector<VertexRole>& roles)
      : face_(charted.features.face),
        places_(places_to_cover(charted)),
        ground_(ground),
        options_(options),
        mesh_(mesh),
        roles_(roles),
        stars_(mesh) {}

  bool step() {
    if (pass_ == most_passes) return false;
    if (!cover_ && tips_.empty()) begin_pass();
    if (cover_) return find_some();
    if (next_ < tips_.size() && trials_ < most_trials) {
      reach(tips_[next_++]);
      return true;
    }
    return end_pass();
  }

  Index reached() const { return reached_; }

 private:
  struct Tip {
    const PlaceToCover* at = nullptr;
    Cover::Gap gap;
  };

  void begin_pass() {
    cover_.emplace(mesh_);
    gap_ = {0, 0};
    places_at_.assign(mesh_.faces.size(), {});
    next_ = 0;
    reached_before_ = reached_;
  }

  /// Notes of some more places which quad is nearest; in the end the farthest tips come first.
  bool find_some() {
    const std::size_t end = std::min(places_.size(), next_ + places_in_a_step);
    for (; next_ < end && tips_.size() <= most_tips; ++next_) look_at(places_[next_]);
    if (tips_.size() > most_tips) return finish();
    if (next_ < places_.size()) return true;
    if (are_everywhere()) return finish();
    cover_.reset();
    next_ = 0;
    sort_values(tips_, [](const Tip& a, const Tip& b) {
      return a.gap.distance != b.gap.distance ? a.gap.distance > b.gap.distance : a.at < b.at;
    });
    return !tips_.empty() || finish();
  }

  void look_at(const PlaceToCover& at) {
    gap_ = cover_->at(at.point, gap_.face);
    if (mesh_.face[gap_.face] != face_[at.place.triangle]) return;
    places_at_[gap_.face].push_back(&at);
    if (gap_.distance > far_off) tips_.push_back({&at, gap_});
  }

  /// Round a thin rod every quad is a chord that cuts off more than a good quad does.
  bool are_everywhere() const {
    std::vector<char> has_tip(mesh_.faces.size(), 0);
    double count = 0;
    for (const Tip& tip : tips_) count += !std::exchange(has_tip[tip.gap.face], 1);
    return count > most_faces * static_cast<double>(mesh_.faces.size());
  }

  bool end_pass() {
    tips_.clear();
    return reached_ == reached_before_ ? finish() : ++pass_ < most_passes;
  }

  bool finish() {
    pass_ = most_passes;
    cover_.reset();
    return false;
  }

  void reach(const Tip& tip) {
    for (const int rings : rings_that_move) {
      const ShapePatch patch =
          take_patch(mesh_, roles_, stars_, faces_around(mesh_, stars_, tip.gap.face, rings));
      if (Cover(patch.mesh).at(tip.at->point).distance <= far_off) return;  // by what others did
      const auto better = best_move(tip, patch);
      if (!better) continue;
      put_back(*better, mesh_, roles_);
      ++reached_;
      return;
    }
  }

  /// The patch with one of the quad's corners on the tip, if that uncovers less than it covers.
  std::optional<ShapePatch> best_move(const Tip& tip, const ShapePatch& patch) {
    std::vector<const PlaceToCover*> near;
    for (const Index f : patch.faces)
      near.insert(near.end(), places_at_[f].begin(), places_at_[f].end());
    const auto before = verdict(patch);
    double least = uncovered(patch.mesh, near);
    std::optional<ShapePatch> best;
    const auto attempt = [&](const PlaceToCover& goal, Index v) {
      ShapePatch moved = patch;
      if (!put_on(goal, v, moved)) return;
      ++trials_;
      const auto after = smooth_patch(ground_, options_, moved);
      if (after.tangled > before.tangled || after.worst < std::min(before.worst - slack, poor))
        return;
      const double left = uncovered(moved.mesh, near);
      if (!(left < least)) return;
      least = left;
      best = std::move(moved);
    };
    for (const Index v : mesh_.faces[tip.gap.face]) {
      if (v == none) continue;
      attempt(*tip.at, v);
      if (!best) attempt(nearest(near, 0.5 * (mesh_.points[v] + tip.at->point)), v);
    }
    return best;
  }

  ShapeSmoother::Verdict verdict(const ShapePatch& patch) const {
    ShellMesh mesh = patch.mesh;
    return ShapeSmoother(ground_, patch.roles, options_, mesh).verdict();
  }

  /// By how much points are farther off than they should be, in all.
  static double uncovered(const ShellMesh& mesh, const std::vector<const PlaceToCover*>& near) {
    const Cover cover(mesh);
    double sum = 0;
    Cover::Gap gap{0, 0};
    for (const PlaceToCover* at : near) {
      gap = cover.at(at->point, gap.face);
      sum += std::max(0.0, gap.distance - near_enough);
    }
    return sum;
  }

  static const PlaceToCover& nearest(const std::vector<const PlaceToCover*>& near, Vec3 p) {
    return **std::min_element(near.begin(), near.end(),
                              [p](const PlaceToCover* a, const PlaceToCover* b) {
                                return distance(a->point, p) < distance(b->point, p);
                              });
  }

  static bool put_on(const PlaceToCover& tip, Index v, ShapePatch& patch) {
    const Index local = index_of(v, patch.vertex);
    if (patch.roles[local].kind != VertexRole::Kind::walks) return false;
    patch.mesh.places[local] = tip.place;
    patch.mesh.points[local] = tip.point;
    patch.roles[local].kind = VertexRole::Kind::fixed;
    return true;
  }

  const std::vector<Index>& face_;  // #T of the surface
  const std::vector<PlaceToCover> places_;
  const ShapeGround& ground_;
  const SmoothOptions& options_;
  ShellMesh& mesh_;
  std::vector<VertexRole>& roles_;
  const FaceStars stars_;
  std::vector<std::vector<const PlaceToCover*>>
      places_at_;  // #F  nearest to the face, when the pass began
  int pass_ = 0, trials_ = 0;
  Index reached_ = 0, reached_before_ = 0;  // the latter when the pass began
  std::optional<Cover> cover_;              // while tips are looked for
  Cover::Gap gap_;                          // of the place looked at last
  std::vector<Tip> tips_;                   // of this pass
  std::size_t next_ = 0;                    // place to look at, or tip to reach
};

TipReacher::TipReacher(const Charted& charted, const ShapeGround& ground,
                       const SmoothOptions& options, ShellMesh& mesh,
                       std::vector<VertexRole>& roles)
    : run_(std::make_unique<Run>(charted, ground, options, mesh, roles)) {}
TipReacher::~TipReacher() = default;

bool TipReacher::step() { return run_->step(); }
Index TipReacher::reached() const { return run_->reached(); }

}  // namespace lpq
