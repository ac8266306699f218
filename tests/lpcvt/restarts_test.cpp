// Exchanges of points: the price that makes counts comparable, what is proposed, what is kept, and
// starts of a wrong count that end with the right one.
#include "lpcvt/restarts.h"

#include <algorithm>

#include "lpcvt/seeds.h"
#include "mesh/validate.h"
#include "support/lp_problem.h"

namespace lpq {
namespace {

using namespace lpq_test;
using namespace lpq::test;

BoundaryMesh square_of(int n) {
  return boundary_of({divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1.0 / n)});
}

std::vector<Vec2> grid_of(int n, double jitter = 0, std::uint64_t seed = 1) {
  Rng rng(seed);
  std::vector<Vec2> points;
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) {
      const double dx = jitter * rng.between(-1, 1), dy = jitter * rng.between(-1, 1);
      points.push_back({(i + dx) / n, (j + dy) / n});
    }
  return points;
}

double energy_of(const TriMesh& mesh, const Fields& fields, double p, EnergyWorkspace& work) {
  EnergyOptions options;
  options.p = p;
  return lp_energy(mesh, fields, options, work, {});
}

BoundaryMesh plate() {
  return boundary_of(
      {divided({{0, 0}, {1, 0}, {1, 0.75}, {0, 1}}, 0.1), reversed(circle({0.4, 0.4}, 0.15, 10))});
}

LpRestarts started(const BoundaryMesh& boundary, const Fields& fields,
                   const std::vector<Vec2>& seeds, int rounds, const LpOptions& options = {}) {
  auto result = LpRestarts::start(boundary, fields, seeds, options, {.rounds = rounds});
  REQUIRE(result.has_value());
  return *std::move(result);
}

void finish(LpRestarts& run) {
  while (run.step(7) == LpStatus::running) CHECK(validate(run.mesh()).empty());
}

}  // namespace

TEST_CASE("a grid of squares costs what it should, and least where its side is the size") {
  for (const double p : {2.0, 3.5, 6.0, 20.0}) {
    double costs[5] = {};
    for (int n = 8; n <= 12; ++n) {
      const BoundaryMesh boundary = square_of(n);
      const Fields fields = constant_fields(boundary, 0, 0.1);
      EnergyWorkspace work;
      const TriMesh mesh = triangulated(boundary, grid_of(n));
      const double energy = energy_of(mesh, fields, p, work);
      if (n == 10) CHECK(std::abs(energy / square_cell_energy(p) - 100) < 1e-3);
      costs[n - 8] = priced_energy(energy, n * n, p);  // every cell counts, those at walls in parts
    }
    CHECK(std::min_element(costs, costs + 5) == costs + 2);
  }
}

TEST_CASE("gaps get a point and crowds lose one, apart from each other, until the count is right") {
  const BoundaryMesh boundary = plate();
  const Fields fields = constant_fields(boundary, 0.2, 0.1);
  const TriMesh mesh = triangulated(boundary, scattered(boundary, 70, 5));
  EnergyWorkspace work;
  energy_of(mesh, fields, 6, work);
  for (const Index most : {1, 2, 5, 50})
    for (const Index missing : {-60, -2, -1, 0, 1, 3, 60}) {
      const Exchange exchange = propose_exchange(mesh, work, 6, most, missing);
      const Index inserted = static_cast<Index>(exchange.inserted.size());
      const Index removed = static_cast<Index>(exchange.removed.size());
      CHECK(exchange.size() > 0);
      CHECK(std::max(inserted, removed) <= most);
      CHECK(inserted - removed <= std::max<Index>(0, missing));
      if (missing < 0) CHECK(removed - inserted <= -missing);
      std::vector<Vec2> places = exchange.inserted;
      for (const Index v : exchange.removed) {
        CHECK(v >= mesh.fixed);
        places.push_back(mesh.points[v]);
      }
      for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) CHECK(distance(places[i], places[k]) > 0.29);
      const std::vector<Vec2> after = points_after(mesh, exchange);
      CHECK(static_cast<Index>(after.size()) ==
            static_cast<Index>(mesh.points.size()) - mesh.fixed + inserted - removed);
      CHECK(triangulate(boundary, after).has_value());
    }
}

TEST_CASE("without rounds it is the optimiser; a perfect grid is left as it is") {
  const BoundaryMesh boundary = plate();
  const Fields fields = constant_fields(boundary, 0.2, 0.1);
  const std::vector<Vec2> seeds = scattered(boundary, 60, 4);
  LpRestarts run = started(boundary, fields, seeds, 0);
  finish(run);
  auto plain = LpOptimizer::start(boundary, fields, seeds);
  REQUIRE(plain.has_value());
  CHECK(plain->step(1000) == run.status());
  CHECK(plain->energy_history() == run.energy_history());
  CHECK(plain->gradient_norm_history() == run.gradient_norm_history());
  CHECK(plain->mesh().points == run.mesh().points);

  const BoundaryMesh square = square_of(10);
  const Fields level = constant_fields(square, 0, 0.1);
  LpRestarts perfect = started(square, level, grid_of(10), 5);
  finish(perfect);
  CHECK(perfect.rounds().empty());
  const std::vector<Vec2> grid = grid_of(10);
  for (std::size_t i = 0; i < grid.size(); ++i)
    CHECK(distance(perfect.mesh().points[perfect.mesh().fixed + i], grid[i]) < 1e-6);
}

TEST_CASE("kept rounds lower the priced energy, others are undone; the boundary never moves") {
  const BoundaryMesh boundary = plate();
  const Fields fields = fields_of(
      boundary, [](Vec2 p) { return 0.5 * p.x; }, [](Vec2 p) { return 0.07 + 0.05 * p.y; }, 30);
  LpRestarts run = started(boundary, fields, scattered(boundary, 120, 8), 12);
  finish(run);
  int kept = 0;
  EnergyWorkspace work;
  double last = 1e300;
  for (const RestartRound& round : run.rounds()) {
    CHECK(round.inserted + round.removed > 0);
    if (!round.kept) continue;
    CHECK(round.priced_energy < last);
    last = round.priced_energy;
    ++kept;
  }
  CHECK(kept > 3);
  const TriMesh& mesh = run.mesh();
  const Index free_points = static_cast<Index>(mesh.points.size()) - mesh.fixed;
  const double energy = energy_of(mesh, fields, 6, work);
  CHECK(std::abs(priced_energy(energy, free_points, 6) / last - 1) < 1e-12);
  CHECK(run.energy_history().back() == run.energy());
  CHECK(run.iterations() <= run.max_iterations());
  for (std::size_t i = 0; i < boundary.points.size(); ++i)
    CHECK(mesh.points[i] == boundary.points[i]);
}

TEST_CASE("ten iterations are ten times one, and a copy goes the same way, across exchanges") {
  const BoundaryMesh boundary = plate();
  const Fields fields = constant_fields(boundary, 0.2, 0.1);
  LpOptions options;
  options.max_iterations = 12;
  LpRestarts a = started(boundary, fields, scattered(boundary, 40, 9), 4, options), b = a;
  while (a.step(10) == LpStatus::running) {
    for (int k = 0; k < 10; ++k) b.step(1);
    const LpRestarts c = b;
    b = c;
    CHECK(a.mesh().points == b.mesh().points);
  }
  finish(b);
  CHECK(a.rounds().size() > 1);
  CHECK(a.energy_history() == b.energy_history());
  CHECK(a.mesh().triangles == b.mesh().triangles);
}

TEST_CASE("a square with points too few or too many ends with as many as it should have") {
  const BoundaryMesh boundary = square_of(10);
  const Fields fields = constant_fields(boundary, 0, 0.1);
  int perfect = 0, right = 0, perfect_without = 0, starts = 0;
  for (const int wrong : {-12, -6, -3, -1, 0, 1, 3, 6, 12})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      std::vector<Vec2> seeds = grid_of(10, 0.3, seed);
      Rng rng(seed);
      for (int k = 0; k < -wrong; ++k)
        seeds.erase(seeds.begin() +
                    static_cast<int>(rng.between(0, 1) * static_cast<double>(seeds.size())));
      for (int k = 0; k < wrong; ++k)
        seeds.push_back({rng.between(0.06, 0.94), rng.between(0.06, 0.94)});
      ++starts;
      for (const int rounds : {0, 30}) {
        LpRestarts run = started(boundary, fields, seeds, rounds);
        finish(run);
        const Index count = static_cast<Index>(run.mesh().points.size()) - run.mesh().fixed;
        const bool grid = run.energy() / square_cell_energy(6) < 100.5 && count == 81;
        if (rounds == 0) {
          perfect_without += grid;
        } else {
          perfect += grid;
          right += std::abs(count - 81) <= 1;
        }
      }
    }
  WARN(perfect << " of " << starts << " perfect, " << perfect_without
               << " without restarts; right counts: " << right);
  CHECK(right == starts);
  CHECK(perfect >= 0.75 * starts);
  CHECK(perfect >= 2 * perfect_without);
}

}  // namespace lpq
