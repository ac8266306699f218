// L-BFGS on the positions of the free vertices. The triangulation follows the points by flips; only
// when an inverted triangle shows that some vertex jumped over its neighbours is it asked whether
// the vertex is still inside and a triangulation built from scratch. As long as no triangle is
// inverted, no vertex can have left: the triangles still cover the same domain exactly once. That
// is the test of section 3.3.1, for nothing. Cost per evaluation O(#V).
#include "lpcvt/optimizer.h"

#include <utility>

#include "delaunay/delaunay.h"

namespace lpq {
namespace {

// A limit on each coordinate that keeps the length of the move within the limit.
constexpr double per_coordinate = 0.70710678118654752;

std::vector<double> coordinates(std::span<const Vec2> points) {
  std::vector<double> x;
  x.reserve(2 * points.size());
  for (const Vec2 p : points) x.insert(x.end(), {p.x, p.y});
  return x;
}

std::span<const Vec2> free_points(const TriMesh& mesh) {
  return std::span<const Vec2>(mesh.points).subspan(static_cast<std::size_t>(mesh.fixed));
}

}  // namespace

Result<LpOptimizer> LpOptimizer::start(const BoundaryMesh& boundary, const Fields& fields,
                                       std::span<const Vec2> seeds, const LpOptions& options) {
  Result<TriMesh> mesh = triangulate(boundary, seeds);
  if (!mesh) return mesh.error();
  return LpOptimizer(boundary, fields, options, std::move(*mesh));
}

LpOptimizer::LpOptimizer(const BoundaryMesh& boundary, const Fields& fields,
                         const LpOptions& options, TriMesh mesh)
    : boundary_(&boundary),
      fields_(&fields),
      options_(options),
      mesh_(std::move(mesh)),
      positions_(free_points(mesh_).begin(), free_points(mesh_).end()),
      gradient_(mesh_.points.size()),
      lbfgs_(coordinates(positions_), options.lbfgs, std::vector<double>(2 * positions_.size())) {
  lbfgs_.step(0, [this](auto x, auto g) { return evaluate(x, g); });
  remember_hints();
}

LpStatus LpOptimizer::step(int n) {
  const auto objective = [this](std::span<const double> x, std::span<double> g) {
    return evaluate(x, g);
  };
  for (int i = 0; i < n && status() == LpStatus::running; ++i) {
    set_move_limits();
    lbfgs_.step(1, objective);
    if (lbfgs_.status() == LbfgsStatus::stalled) {
      // The last trial was refused: go back to the accepted point.
      std::vector<double> unused(lbfgs_.x().size());
      evaluate(lbfgs_.x(), unused);
    }
    remember_hints();
  }
  return status();
}

LpStatus LpOptimizer::status() const {
  switch (lbfgs_.status()) {
    case LbfgsStatus::converged: return LpStatus::converged;
    case LbfgsStatus::stagnated: return LpStatus::stagnated;
    case LbfgsStatus::stalled: return LpStatus::stalled;
    case LbfgsStatus::running: break;
  }
  return lbfgs_.iterations() >= options_.max_iterations ? LpStatus::iteration_limit
                                                        : LpStatus::running;
}

Evaluation LpOptimizer::evaluate(std::span<const double> x, std::span<double> gradient) {
  for (std::size_t i = 0; i < positions_.size(); ++i) positions_[i] = {x[2 * i], x[2 * i + 1]};
  const EvalStatus moved = move_mesh(positions_);
  if (moved != EvalStatus::ok) {
    ++refusals_;
    return {0, moved};
  }
  const double energy = lp_energy(mesh_, *fields_, options_.energy, workspace_, gradient_);
  const std::size_t fixed = static_cast<std::size_t>(mesh_.fixed);
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    gradient[2 * i] = gradient_[fixed + i].x;
    gradient[2 * i + 1] = gradient_[fixed + i].y;
  }
  return {energy, EvalStatus::ok};
}

EvalStatus LpOptimizer::move_mesh(std::span<const Vec2> positions) {
  if (!mesh_is_valid_) return rebuild(positions);
  const UpdateResult result = update(mesh_, positions, &update_workspace_);
  if (result.status == UpdateStatus::flipped) return EvalStatus::ok;
  mesh_is_valid_ = false;
  return rebuild(positions);
}

EvalStatus LpOptimizer::rebuild(std::span<const Vec2> positions) {
  if (!all_inside(positions)) return EvalStatus::outside_domain;
  Result<TriMesh> mesh = triangulate(*boundary_, positions);
  if (!mesh) return EvalStatus::degenerate;  // two vertices met, or one is on a wall
  mesh_ = std::move(*mesh);
  mesh_is_valid_ = true;
  return EvalStatus::ok;
}

// Can every vertex be reached from its last accepted position without crossing a wall? (The far
// side of a wall inside the domain is as forbidden as the outside.)
bool LpOptimizer::all_inside(std::span<const Vec2> positions) const {
  for (std::size_t i = 0; i < hints_.size(); ++i)
    if (fields_->walk(positions[i], hints_[i]) == none) return false;
  return true;
}

void LpOptimizer::remember_hints() {
  if (workspace_.hints.size() != mesh_.points.size()) return;  // not even the start was computable
  hints_.assign(workspace_.hints.begin() + mesh_.fixed, workspace_.hints.end());
}

// The limit follows the size field along the vertex's way.
void LpOptimizer::set_move_limits() {
  const std::span<double> limits = lbfgs_.move_limits();
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const double h = workspace_.metric[static_cast<std::size_t>(mesh_.fixed) + i].h;
    limits[2 * i] = limits[2 * i + 1] = per_coordinate * options_.max_move * h;
  }
}

}  // namespace lpq
