// The optimiser: descent, resuming, staying inside, small cases, and the paper's chain.
#include "lpcvt/optimizer.h"

#include <set>

#include "field/make_fields.h"
#include "lpcvt/seeds.h"
#include "mesh/quality.h"
#include "mesh/validate.h"
#include "support/domain_data.h"
#include "support/lp_problem.h"

namespace lpq {
namespace {

using namespace lpq_test;
using namespace lpq::test;

BoundaryMesh plate() {
  return boundary_of(
      {divided({{0, 0}, {1, 0}, {1, 0.75}, {0, 1}}, 0.1), reversed(circle({0.4, 0.4}, 0.15, 10))});
}

LpOptimizer started(const BoundaryMesh& boundary, const Fields& fields,
                    const std::vector<Vec2>& seeds, const LpOptions& options = {}) {
  auto result = LpOptimizer::start(boundary, fields, seeds, options);
  REQUIRE(result.has_value());
  return *std::move(result);
}

void check_descent(const LpOptimizer& optimizer) {
  const auto& values = optimizer.energy_history();
  for (std::size_t k = 1; k < values.size(); ++k) CHECK(values[k] < values[k - 1]);
  CHECK(optimizer.gradient_norm_history().size() == values.size());
  CHECK(optimizer.energy() == values.back());
}

}  // namespace

TEST_CASE("the energy falls and the mesh stays a valid Delaunay triangulation") {
  const BoundaryMesh boundary = plate();
  const Fields fields = constant_fields(boundary, 0.2, 0.1);
  LpOptimizer optimizer = started(boundary, fields, scattered(boundary, 60, 4));
  for (int k = 0; k < 8; ++k) {
    optimizer.step(10);
    CHECK(validate(optimizer.mesh()).empty());
  }
  check_descent(optimizer);
  CHECK(optimizer.energy() < 0.5 * optimizer.energy_history().front());
  CHECK(optimizer.iterations() <= 80);
  // The energy reported is that of the mesh handed out.
  EnergyWorkspace work;
  const double again = lp_energy(optimizer.mesh(), fields, {}, work, {});
  CHECK(std::abs(again / optimizer.energy() - 1) < 1e-12);
}

TEST_CASE("step(10) is ten times step(1); a copy goes its own way and the same") {
  const BoundaryMesh boundary = plate();
  const Fields fields = constant_fields(boundary, 0.2, 0.1);
  LpOptimizer a = started(boundary, fields, scattered(boundary, 50, 9)), b = a;
  a.step(10);
  for (int k = 0; k < 10; ++k) b.step(1);
  CHECK(a.energy_history() == b.energy_history());
  CHECK(a.mesh().points == b.mesh().points);
  LpOptimizer c = a;
  c.step(7);
  a.step(3);
  a.step(4);
  CHECK(a.energy_history() == c.energy_history());
  CHECK(a.mesh().triangles == c.mesh().triangles);
}

TEST_CASE("hasty moves that leave the domain are refused, not accepted") {
  const BoundaryMesh boundary = plate();
  const Fields fields = constant_fields(boundary, 0.2, 0.1);
  LpOptions options;
  options.max_move = 50;
  options.lbfgs.first_move = 1;
  LpOptimizer optimizer = started(boundary, fields, scattered(boundary, 60, 4, 3), options);
  optimizer.step(60);
  CHECK(optimizer.refusals() > 0);
  CHECK(validate(optimizer.mesh()).empty());
  check_descent(optimizer);
}

TEST_CASE("no interior point, and one") {
  const BoundaryMesh boundary = boundary_of({divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.5)});
  const Fields fields = constant_fields(boundary, 0, 0.5);
  LpOptimizer none_free = started(boundary, fields, {});
  CHECK(none_free.step(5) == LpStatus::converged);
  CHECK(none_free.energy() > 0);
  LpOptimizer one = started(boundary, fields, {{0.3, 0.4}});
  one.step(80);
  CHECK(distance(one.mesh().points.back(), {0.5, 0.5}) < 1e-3);
}

TEST_CASE("seeds on top of each other are an error") {
  const BoundaryMesh boundary = plate();
  const Fields fields = constant_fields(boundary, 0, 0.1);
  const std::vector<Vec2> twice{{0.1, 0.1}, {0.1, 0.1}};
  CHECK_FALSE(LpOptimizer::start(boundary, fields, twice).has_value());
}

TEST_CASE("a change of unit by a power of two changes no bit") {
  const BoundaryMesh boundary = plate();
  const auto seeds = scattered(boundary, 60, 12);
  auto small_seeds = seeds;
  for (Vec2& p : small_seeds) p = 0x1p-7 * p;
  const BoundaryMesh small = scaled(boundary, 0x1p-7);
  const Fields fields = constant_fields(boundary, 0.2, 0.1);
  const Fields small_fields = constant_fields(small, 0.2, 0.1 * 0x1p-7);
  LpOptimizer a = started(boundary, fields, seeds);
  LpOptimizer b = started(small, small_fields, small_seeds);
  a.step(30);
  b.step(30);
  CHECK(a.energy_history() == b.energy_history());
  for (std::size_t i = 0; i < a.mesh().points.size(); ++i)
    CHECK(0x1p-7 * a.mesh().points[i] == b.mesh().points[i]);
}

TEST_CASE("the paper's chain: isotropic start, p = 6, 80 iterations", "[slow]") {
  const auto root = std::filesystem::path(LPQ_SHARED_DATA) / "domains";
  for (const char* name : {"hood", "disc", "annulus", "platehole", "star", "gear"}) {
    const auto path = root / (std::string(name) + ".json");
    if (!std::filesystem::exists(path)) {
      WARN("SKIPPED: " << name << " because " << root << " is absent");
      continue;
    }
    const auto domain = make_domain(read_domain(path));
    REQUIRE(domain.has_value());
    const auto boundary = sample_boundary(*domain);
    REQUIRE(boundary.has_value());
    FieldOptions field_options;
    field_options.size = domain->h;
    const auto fields = make_fields(*boundary, field_options);
    REQUIRE(fields.has_value());
    LpOptimizer optimizer = started(*boundary, *fields, isotropic_seeds(*boundary, *fields));
    const double before = tau(optimizer.mesh());
    optimizer.step(80);
    check_descent(optimizer);
    CHECK(validate(optimizer.mesh()).empty());
    const double after = tau(optimizer.mesh());
    WARN(name << ": tau " << before << " -> " << after << ", " << optimizer.evaluations()
              << " evaluations");
    CHECK(after > 0.955);
  }
}

}  // namespace lpq
