// See seams.h.
#include "shell/seams.h"

#include <algorithm>
#include <optional>

#include "shell/ball.h"
#include "shell/coarse_ground.h"
#include "shell/place.h"
#include "shell/rework.h"
#include "shell/shape/descent.h"
#include "shell/shape/outside.h"
#include "shell/stars.h"
#include "shell/window.h"

namespace lpq {
namespace {

constexpr double seam_radius = 13;  // in mesh sizes
constexpr double knot_radius = 18;  // far enough to see what irregular vertices could cancel
constexpr int seam_passes = 2, knot_passes = 2, knot_passes_of_high_effort = 4;
constexpr double margin = 1.5;  // around a window, for vertices between those that stay
constexpr double smallest_radius = 3.5;
constexpr double shrink = 0.7;         // of a window without a good map
constexpr double covered_share = 0.5;  // of the radius: what a window has dealt with
// Triangles in windows without a map, for each of the surface: what noise consists of has none, and
// other shapes stay under 401.
constexpr double most_in_vain = 800, some_triangles = 1000;

/// A feature with one face on both sides: windows may look across.
bool lies_inside(const Charted& charted, Index e) {
  const Index twin = charted.mesh.twins[e];
  const std::vector<Index>& face = charted.features.face;
  return twin != none && face[triangle_of(e)] == face[triangle_of(twin)];
}

std::vector<char> barrier_of(const Charted& charted) {
  std::vector<char> barrier = charted.features.half_edges();
  for (Index e = 0; e < static_cast<Index>(barrier.size()); ++e)
    if (barrier[e] && lies_inside(charted, e)) barrier[e] = 0;
  return barrier;
}

}  // namespace

class SeamFinisher::Run {
 public:
  Run(const Charted& charted, const Options& options, ShellMesh mesh)
      : coarse_(wants_coarse_ground(charted) ? std::make_unique<CoarseGround>(charted) : nullptr),
        charted_(coarse_ ? coarse_->charted() : charted),
        options_(options),
        passes_(seam_passes +
                (options.effort == Effort::high ? knot_passes_of_high_effort : knot_passes)),
        mesh_(std::move(mesh)),
        barrier_(barrier_of(charted_)),
        balls_(charted_.mesh, barrier_),
        windows_(charted_.mesh, charted_.cross, charted_.size),
        outside_(charted_.mesh, charted_.features, charted_.size),
        rim_(mesh_.points.size(), 0),
        seed_(options.seed) {
    for (std::size_t v = 0; v < charted_.nodes.points.size(); ++v) rim_[v] = mesh_.is_free(v);
    if (coarse_) {
      before_ = mesh_;
      coarse_->lower(mesh_);
    }
    find_stars();
    want_rims();
  }

  /// One window after the other over the vertices that want one.
  bool step() {
    if (pass_ == passes_) return false;
    while (next_ < wanted_.size()) {
      const Index v = wanted_[next_++];
      if (covered_[v] || mesh_.places[v].triangle == none) continue;
      if (pass_ < seam_passes)
        open_window(v, Rework::seam, seam_radius);
      else
        open_window(v, Rework::knot, knot_radius);
      return true;
    }
    end_pass();
    return pass_ < passes_;
  }

  double share() const {
    const double of_pass =
        wanted_.empty() ? 0 : static_cast<double>(next_) / static_cast<double>(wanted_.size());
    return (pass_ + of_pass) / passes_;
  }
  const SeamStats& stats() const { return stats_; }
  ShellMesh take() {
    if (coarse_) coarse_->raise(before_, mesh_);
    return std::move(mesh_);
  }

 private:
  void end_pass() {
    ++pass_;
    wanted_.clear();
    next_ = 0;
    if (pass_ >= seam_passes) {
      sweep_dead();
      find_stars();
    }
    if (pass_ < seam_passes)
      want_rims();
    else if (pass_ < passes_)
      want_knots();
    rim_.assign(mesh_.points.size(), 0);
  }

  void find_stars() { stars_.emplace(mesh_, charted_.mesh.triangle_count()); }

  /// The free vertices on cuts at first, then on the borders of windows.
  void want_rims() {
    for (std::size_t v = 0; v < rim_.size(); ++v)
      if (rim_[v]) wanted_.push_back(static_cast<Index>(v));
    rim_.assign(rim_.size(), 0);
    covered_.assign(mesh_.points.size(), 0);
  }

  /// Free vertices where other than four quads meet.
  void want_knots() {
    std::vector<Index> valence(mesh_.points.size(), 0);
    for (const Face& face : mesh_.faces)
      for (const Index v : face)
        if (v != none) ++valence[v];
    for (std::size_t v = 0; v < valence.size(); ++v)
      if (mesh_.is_free(v) && valence[v] != 4) wanted_.push_back(static_cast<Index>(v));
    covered_.assign(mesh_.points.size(), 0);
  }

  /// The largest that can be around the vertex.
  void open_window(Index v, Rework kind, double largest_radius) {
    const double h = charted_.size[charted_.mesh.triangles[mesh_.places[v].triangle][0]];
    for (double radius = largest_radius; radius >= smallest_radius && !is_in_vain();
         radius *= shrink) {
      const Ball ball = balls_.ball(mesh_.places[v].triangle, (radius + margin) * h, margin * h);
      auto window = windows_.open(mesh_, *stars_, ball);
      if (!window) {
        stats_.in_vain += static_cast<double>(ball.triangles.size());
        continue;
      }
      ++stats_.windows;
      const Vec3 centre = mesh_.points[v];
      if (auto quads = rework(*window, kind, options_, seed_++)) {
        const ShellMesh part = lifted(*window, *quads);
        if (tangled(part) <= tangled_now(window->faces)) {
          ++stats_.accepted;
          put_back(*window, quads->fixed, part);
        }
      }
      cover(ball, centre, covered_share * radius * h);
      return;
    }
  }

  /// What the ball has near its centre needs no window of its own in this pass.
  void cover(const Ball& ball, Vec3 centre, double radius) {
    covered_.resize(mesh_.points.size(), 0);
    for (const Index t : ball.triangles)
      stars_->for_each_vertex_in(t, [&](Index v) {
        if (distance(mesh_.points[v], centre) < radius) covered_[v] = 1;
      });
  }

  bool is_in_vain() const {
    return stats_.in_vain > most_in_vain * (charted_.mesh.triangle_count() + some_triangles);
  }

  /// The quads on the surface, each as a part of the window's face.
  ShellMesh lifted(const Window& window, const QuadMesh& quads) const {
    ShellMesh part;
    Index hint = none;
    for (std::size_t v = 0; v < quads.points.size(); ++v) {
      const bool fixed = v < static_cast<std::size_t>(quads.fixed);
      part.places.push_back(fixed ? mesh_.places[window.vertex[v]]
                                  : place_on(window.chart, window.fields, quads.points[v], hint));
      part.points.push_back(fixed ? mesh_.points[window.vertex[v]]
                                  : point_at(charted_.mesh, part.places.back()));
    }
    part.faces = quads.faces;
    part.face.assign(quads.faces.size(), mesh_.face[window.faces[0]]);
    return part;
  }

  /// Quads that are not convex as the surface sees them: where it bends over itself within one, a
  /// good quad in the plane may be none.
  Index tangled(const ShellMesh& part) const {
    Index count = 0;
    for (Index f = 0; f < static_cast<Index>(part.faces.size()); ++f) count += is_tangled(part, f);
    return count;
  }
  Index tangled_now(const std::vector<Index>& faces) const {
    return static_cast<Index>(
        std::count_if(faces.begin(), faces.end(), [&](Index f) { return is_tangled(mesh_, f); }));
  }
  bool is_tangled(const ShellMesh& mesh, Index f) const {
    return !is_strictly_convex(corners_of(mesh, f), outside_.at(mesh, f));
  }

  /// `part`: lifted, the first `fixed` vertices are the window's own.
  void put_back(const Window& window, Index fixed, const ShellMesh& part) {
    for (const Index f : window.faces) mesh_.faces[f] = {none, none, none, none};
    for (std::size_t v = window.quads.fixed; v < window.vertex.size(); ++v)
      mesh_.places[window.vertex[v]].triangle = none;
    std::vector<Index> number(window.vertex.begin(), window.vertex.begin() + fixed);
    for (std::size_t v = fixed; v < part.points.size(); ++v) {
      number.push_back(static_cast<Index>(mesh_.points.size()));
      mesh_.places.push_back(part.places[v]);
      mesh_.points.push_back(part.points[v]);
      mesh_.pins.push_back(Pin::free);
      rim_.push_back(0);
    }
    for (const Index v : window.vertex) rim_[v] = 0;
    for (Index v = 0; v < fixed; ++v) rim_[number[v]] = mesh_.is_free(number[v]);
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      const auto [a, b, c, d] = part.faces[f];
      mesh_.faces.push_back({number[a], number[b], number[c], number[d]});
      mesh_.face.push_back(part.face[f]);
    }
    stars_->update(mesh_);
  }

  void sweep_dead() {
    std::vector<char> alive;
    for (const SurfacePlace& place : mesh_.places) alive.push_back(place.triangle != none);
    sweep(mesh_, alive);
  }

  std::unique_ptr<CoarseGround> coarse_;  // where the surface is too fine
  Charted charted_;                       // on the coarse ground, if there is one
  Options options_;
  int passes_;  // over the seams, then over the knots
  ShellMesh mesh_;
  ShellMesh before_;           // with places on the fine surface; empty where that is the ground
  std::vector<char> barrier_;  // #half-edges
  BallFinder balls_;
  WindowMaker windows_;
  Outside outside_;
  std::optional<ShellStars> stars_;  // of mesh_
  int pass_ = 0;
  std::vector<Index> wanted_;  // vertices that want a window in this pass, ascending
  std::size_t next_ = 0;       // of them
  std::vector<char> covered_;  // #V  by windows of this pass
  std::vector<char> rim_;      // #V  free vertices on the borders of windows
  std::uint64_t seed_;         // of the search in the next window
  SeamStats stats_;
};

SeamFinisher::SeamFinisher(const Charted& charted, const Options& options, ShellMesh mesh)
    : run_(std::make_unique<Run>(charted, options, std::move(mesh))) {}
SeamFinisher::~SeamFinisher() = default;

bool SeamFinisher::step() { return run_->step(); }
double SeamFinisher::share() const { return run_->share(); }
const SeamStats& SeamFinisher::stats() const { return run_->stats(); }
ShellMesh SeamFinisher::take() { return run_->take(); }

}  // namespace lpq
