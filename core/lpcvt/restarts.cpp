// See restarts.h.
#include "lpcvt/restarts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lpcvt/seeds.h"

namespace lpq {
namespace {

Index free_count(const TriMesh& mesh) {
  return static_cast<Index>(mesh.points.size()) - mesh.fixed;
}

}  // namespace

Result<LpRestarts> LpRestarts::start(const BoundaryMesh& boundary, const Fields& fields,
                                     std::span<const Vec2> seeds, const LpOptions& options,
                                     const RestartOptions& restarts) {
  auto optimizer = LpOptimizer::start(boundary, fields, seeds, options);
  if (!optimizer) return optimizer.error();
  return LpRestarts(boundary, fields, options, restarts, std::move(*optimizer));
}

LpRestarts::LpRestarts(const BoundaryMesh& boundary, const Fields& fields, const LpOptions& options,
                       const RestartOptions& restarts, LpOptimizer optimizer)
    : boundary_(&boundary),
      fields_(&fields),
      options_(options),
      restarts_(restarts),
      optimizer_(std::move(optimizer)) {
  record();
  open_ = restarts_.rounds > 0 || optimizer_.status() == LpStatus::running;
  if (restarts_.rounds == 0) return;
  expected_ = static_cast<Index>(std::floor(expected_interior_points(boundary, fields) + 0.5));
  const Index share = static_cast<Index>(restarts_.share * expected_);
  most_ = std::max({Index{1}, share, std::abs(expected_ - free_count(mesh())) / 4});
}

LpStatus LpRestarts::step(int n) {
  for (int i = 0; i < n && open_; ++i) iterate();
  return status();
}

int LpRestarts::max_iterations() const {
  // The start of each round and the way back from the last count as well.
  const int rounds = restarts_.rounds;
  return options_.max_iterations + rounds * (restarts_.iterations + 1) + (rounds > 0);
}

void LpRestarts::iterate() {
  if (optimizer_.status() == LpStatus::running) {
    optimizer_.step(1);
    record();
    if (restarts_.rounds == 0) open_ = optimizer_.status() == LpStatus::running;
    return;
  }
  const bool undone = !judge();
  open_ = exchange();
  if (open_ || undone) record();
}

// Was the round worth it? If not, back to where it began.
bool LpRestarts::judge() {
  if (!before_) return true;
  RestartRound& round = rounds_.back();
  round.priced_energy = priced(optimizer_);
  round.kept = round.priced_energy < priced(*before_);
  if (!round.kept) {
    optimizer_ = std::move(*before_);
    most_ = std::max(round.inserted, round.removed) / 2;
  }
  before_.reset();
  return round.kept;
}

bool LpRestarts::exchange() {
  if (static_cast<int>(rounds_.size()) == restarts_.rounds || most_ == 0) return false;
  const TriMesh& mesh = optimizer_.mesh();
  workspace_.hints.clear();  // vertices have other numbers than last time
  lp_energy(mesh, *fields_, options_.energy, workspace_, {});
  const Exchange exchange =
      propose_exchange(mesh, workspace_, options_.energy.p, most_, expected_ - free_count(mesh));
  if (exchange.size() == 0) return false;
  LpOptions options = options_;
  options.max_iterations = restarts_.iterations;
  auto next = LpOptimizer::start(*boundary_, *fields_, points_after(mesh, exchange), options);
  if (!next) return false;
  before_ = std::exchange(optimizer_, std::move(*next));
  rounds_.push_back(
      {static_cast<Index>(exchange.inserted.size()), static_cast<Index>(exchange.removed.size())});
  return true;
}

double LpRestarts::priced(const LpOptimizer& optimizer) const {
  return priced_energy(optimizer.energy(), free_count(optimizer.mesh()), options_.energy.p);
}

void LpRestarts::record() {
  if (optimizer_.energy_history().empty()) return;  // not even the start was computable
  energies_.push_back(optimizer_.energy());
  gradient_norms_.push_back(optimizer_.gradient_norm_history().back());
}

}  // namespace lpq
