#include "patches/remesh.h"

#include <utility>

#include "cleanup/smooth.h"
#include "patches/refit.h"
#include "patches/search.h"

namespace lpq {
namespace {

constexpr int nearest_targets = 6;  // irregular vertices that a patch tries to take in
constexpr int most_rings = 12;
constexpr std::uint64_t patch_stream = 5;  // of random numbers
// Annealing: irregularity that one refill may add, the share of the temperature left at the end of
// a pass, and how far random patches reach.
constexpr double annealing_weight = 2, coolest = 0.4;
constexpr int random_targets = 4, random_rings = 3;
// The search ends early where patches hardly ever help, as in outlines full of needles: after this
// many tries in a pass, when fewer than one in `worth_trying` was accepted (usual: one in six).
constexpr Index enough_tries = 1000, worth_trying = 20;

// Patches from the star of v along the ways to the nearest irregular vertices.
Refit refit_towards_others(Refitter& refitter, Search& search, Index v, const RefitRule& rule) {
  PatchGrowth& patch = refitter.patch();
  patch.clear();
  patch.add_star(v);
  search.start(v);
  Refit result = refitter.refit(rule);
  for (int found = 0; found < nearest_targets && result == Refit::rejected; ++found) {
    const Index other = search.next(2 * static_cast<std::size_t>(rule.largest));
    if (other == none) return result;
    for (Index u = other; u != none; u = search.parent(u)) patch.add_star(u);
    result = refitter.refit(rule);
  }
  return result;
}

// Patches of more and more rings round v.
Refit refit_rings(Refitter& refitter, Index v, const RefitRule& rule) {
  PatchGrowth& patch = refitter.patch();
  patch.clear();
  patch.add_star(v);
  Refit result = Refit::rejected;
  for (int ring = 0; ring < most_rings && result == Refit::rejected; ++ring) {
    const std::size_t before = patch.faces().size();
    patch.add_ring();
    if (patch.faces().size() == before) break;
    result = refitter.refit(rule);
  }
  return result;
}

// The star of v, the ways to some irregular vertices near it, some rings round all this.
void grow_at_random(PatchGrowth& patch, Search& search, Index v, Index largest, Rng& rng) {
  patch.clear();
  patch.add_star(v);
  search.start(v);
  for (std::uint64_t wanted = rng.below(random_targets); wanted > 0;) {
    const Index other = search.next(2 * static_cast<std::size_t>(largest));
    if (other == none) break;
    if (rng.below(3) == 0) continue;
    for (Index u = other; u != none; u = search.parent(u)) patch.add_star(u);
    --wanted;
  }
  for (std::uint64_t rings = rng.below(random_rings); rings > 0; --rings)
    if (static_cast<Index>(patch.faces().size()) < largest) patch.add_ring();
}

}  // namespace

PatchRemesher::PatchRemesher(QuadMesh mesh, const Fields& fields, const PatchOptions& options)
    : mesh_(std::move(mesh)),
      ideal_(mesh_),
      fields_(&fields),
      options_(options),
      rng_(options.seed, patch_stream) {
  if (!done()) begin_pass();
}

void PatchRemesher::begin_pass() {
  queue_.clear();
  queued_.assign(mesh_.vertex_count(), 0);
  next_ = 0;
  tried_ = refilled_ = 0;
  for (Index v = 0; v < mesh_.vertex_count(); ++v)
    if (mesh_.valence(v) > 0 && !ideal_.is_regular(mesh_, v)) {
      queue_.push_back(v);
      queued_[v] = 1;
    }
  if (options_.passes[pass_].temperature > 0) {
    const double trials = options_.passes[pass_].trials * static_cast<double>(queue_.size());
    all_trials_ = trials_ = static_cast<Index>(trials);
  }
}

void PatchRemesher::end_pass() {
  QuadMesh mesh = std::move(mesh_).compact();
  smooth_eta(mesh, *fields_,
             {.iterations = options_.smoothing,
              .size_weight = options_.energy.size_weight,
              .area_weight = options_.energy.area_weight,
              .eta_floor = 1 - options_.energy.floor_deviation,
              .rounding = options_.energy.rounding});
  mesh_ = QuadTopology(std::move(mesh));
  ++pass_;
  if (!done()) begin_pass();
}

void PatchRemesher::note_changes(const Refitter& refitter) {
  ++stats_.refilled;
  ++refilled_;
  queued_.resize(mesh_.vertex_count(), 0);
  for (const Index w : refitter.changed())
    if (!queued_[w] && !ideal_.is_regular(mesh_, w)) {
      queued_[w] = 1;
      queue_.push_back(w);
    }
}

void PatchRemesher::refit_in_order(Refitter& refitter, Search& search, int seeds) {
  const RefitRule rule{.largest = options_.passes[pass_].largest};
  for (int i = 0; i < seeds && next_ < queue_.size(); ++next_) {
    const Index v = queue_[next_];
    queued_[v] = 0;
    if (mesh_.valence(v) == 0 || ideal_.is_regular(mesh_, v)) continue;
    ++i;
    Refit result = refit_towards_others(refitter, search, v, rule);
    if (result != Refit::done) result = refit_rings(refitter, v, rule);
    if (result == Refit::done) note_changes(refitter);
  }
  tried_ += refitter.tried();
  gave_up_ = tried_ > enough_tries && refilled_ * worth_trying < tried_;
  if (gave_up_)
    pass_ = options_.passes.size();
  else if (next_ == queue_.size())
    end_pass();
}

void PatchRemesher::refit_at_random(Refitter& refitter, Search& search, int trials) {
  const PatchPass& pass = options_.passes[pass_];
  for (int i = 0; i < trials && trials_ > 0 && !queue_.empty(); ++i, --trials_) {
    const std::size_t at = rng_.below(queue_.size());
    const Index v = queue_[at];
    if (mesh_.valence(v) == 0 || ideal_.is_regular(mesh_, v)) {
      queued_[v] = 0;
      queue_[at] = queue_.back();
      queue_.pop_back();
      continue;
    }
    const double share = static_cast<double>(trials_) / all_trials_;
    const RefitRule rule{.largest = pass.largest,
                         .temperature = pass.temperature * (coolest + (1 - coolest) * share),
                         .extra_weight = annealing_weight,
                         .rng = &rng_};
    grow_at_random(refitter.patch(), search, v, pass.largest, rng_);
    if (refitter.refit(rule) == Refit::done) note_changes(refitter);
  }
  if (trials_ == 0 || queue_.empty()) end_pass();
}

bool PatchRemesher::step(int seeds) {
  if (done()) return false;
  Refitter refitter(mesh_, ideal_, *fields_, options_);
  Search search(mesh_, ideal_);
  if (options_.passes[pass_].temperature > 0)
    refit_at_random(refitter, search, seeds);
  else
    refit_in_order(refitter, search, seeds);
  stats_.tried += refitter.tried();
  return !done();
}

QuadMesh PatchRemesher::mesh() const {
  QuadTopology copy = mesh_;
  return std::move(copy).compact();
}

}  // namespace lpq
