// Other meshes that a run's own is compared with: grids, and those of sizes a little off.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "catch.h"
#include "pipeline/finish.h"
#include "pipeline/mesh_domain.h"
#include "pipeline/session.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

Loop polygon(double radius, int corners) {
  Loop loop;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    loop.push_back(radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return loop;
}

Outcome meshed(const DomainInput& input, const Options& options, const UserFields& user = {}) {
  auto outcome = mesh_domain(input, options, {}, nullptr, user);
  REQUIRE(outcome);
  CHECK(check_output(outcome->mesh).empty());
  return std::move(*outcome);
}

/// Keeps the mesher from comparing: sizes are the caller's.
UserFields alone(double h) {
  UserFields user;
  user.size = [h](Vec2) { return h; };
  return user;
}

// What is lacking, as where meshes are compared.
double lacking(const Report& report) {
  return 1 - report.quality.eta_mean + 0.01 * (100 - report.quality.four_valent_percent) +
         std::max(0.0, 0.2 - report.quality.eta_min) + Options{}.size_weight * report.size.off;
}

bool has_stage(const DomainInput& input, const Options& options, Stage stage) {
  auto mesher = Mesher::start(input, options);
  REQUIRE(mesher);
  bool seen = false;
  while (mesher->stage() != Stage::done) {
    REQUIRE(mesher->step());
    seen |= mesher->stage() == stage;
  }
  return seen;
}

}  // namespace

TEST_CASE("right-angled outlines get grids, whatever the size") {
  const DomainInput input =
      domain_of({{{0, 0}, {3.1, 0}, {3.1, 1.27}, {1.13, 1.27}, {1.13, 2.9}, {0, 2.9}}});
  for (double h = 0.06; h < 0.4; h += 0.037) {
    INFO("h " << h);
    const Report report = meshed(input, {.size = h}).report;
    CHECK(report.quality.four_valent_percent == 100);
    CHECK(report.quality.eta_mean > 0.95);
    CHECK(report.size.p90 < 1.3);
    CHECK(report.size.p10 > 0.75);
  }
}

TEST_CASE("rings that are not wide get rows from border to border") {
  const DomainInput input = domain_of({polygon(1, 30), polygon(0.75, 20)});
  double with = 0, without = 0;
  for (double h = 0.045; h < 0.13; h += 0.017) {
    with += lacking(meshed(input, {.size = h}).report);
    without += lacking(meshed(input, {.size = h}, alone(h)).report);
  }
  CHECK(with < 0.7 * without);
}

TEST_CASE("a comparison never ends with a worse mesh") {
  int better = 0;
  for (const double h : {0.09, 0.13, 0.17})
    for (const DomainInput& input : {disc(h), annulus(h), plate_with_hole(h), hood(h), l_shape(h)})
      for (const Effort effort : {Effort::normal, Effort::high}) {
        auto mesher = Mesher::start(input, {.size = h, .keep_boundary = true, .effort = effort});
        REQUIRE(mesher);
        while (mesher->stage() != Stage::compare && mesher->stage() != Stage::done)
          REQUIRE(mesher->step());
        const double before = lacking(mesher->report());
        while (mesher->stage() != Stage::done) REQUIRE(mesher->step());
        CHECK(lacking(mesher->report()) <= before);
        better += lacking(mesher->report()) < before;
        CHECK(check_output(mesher->output()).empty());
      }
  CHECK(better > 10);
}

TEST_CASE("who decides on sizes or directions gets no others") {
  const DomainInput input = annulus(0.1);
  const Options options{.size = 0.1, .keep_boundary = true};
  CHECK(has_stage(input, options, Stage::compare));
  DomainInput sized = input;
  sized.sizes = {{{0.6, 0}, 0.05}};
  CHECK_FALSE(has_stage(sized, options, Stage::compare));
  DomainInput guided = input;
  guided.guides = {{{0.5, 0}, {0.8, 0.4}}};
  CHECK_FALSE(has_stage(guided, options, Stage::compare));
  Options paper = options;
  paper.method = Method::paper;
  CHECK_FALSE(has_stage(input, paper, Stage::compare));
  Options isotropic = options;
  isotropic.seeds = Seeds::isotropic;
  CHECK_FALSE(has_stage(input, isotropic, Stage::compare));
}

TEST_CASE("where nothing is lacking nothing is compared") {
  CHECK_FALSE(has_stage(square(1, 0.1), {.size = 0.1, .keep_boundary = true}, Stage::compare));
}

TEST_CASE("a comparison takes one step each, and shows the best mesh so far") {
  const DomainInput input = annulus(0.11);
  auto session = Session::start(input, {.size = 0.11, .keep_boundary = true});
  REQUIRE(session);
  while (session->mesher().stage() != Stage::compare) REQUIRE(session->step());
  int steps = 0;
  double least = 1e9;
  while (session->mesher().stage() == Stage::compare) {
    const double now = lacking(session->mesher().report());
    CHECK(now <= least);
    least = now;
    CHECK(quad_quality(session->mesher().quads()).eta_mean ==
          session->mesher().report().quality.eta_mean);
    REQUIRE(session->step());
    ++steps;
  }
  CHECK(session->mesher().stage() == Stage::done);
  CHECK(steps == 4);
  const Report& end = session->mesher().report();
  CHECK(lacking(end) <= least);
  CHECK(output_hash(session->mesher().output()) == end.hash);
  const int ticks = session->ticks();
  REQUIRE(session->restore(ticks - 2));
  REQUIRE(session->step(2));
  CHECK(session->mesher().report().hash == end.hash);
}

TEST_CASE("a trace is that of the mesh that is kept") {
  for (const double h : {0.1, 0.12, 0.14, 0.16, 0.18}) {
    Trace trace;
    const auto outcome = mesh_domain(annulus(h), {.size = h, .keep_boundary = true}, {}, &trace);
    REQUIRE(outcome);
    const QuadQuality recorded = quad_quality(trace.quads.back().mesh);
    CHECK(recorded.eta_mean == outcome->report.quality.eta_mean);
    // its triangles are those that the matching merged
    const std::string& chain = outcome->report.chain;
    INFO(chain);
    if (chain.find("matching") == std::string::npos) continue;
    CHECK(trace.quads.front().name == "matched");
    CHECK(tau(trace.triangles) == outcome->report.tau);
  }
}

TEST_CASE("a trace and a report know nothing of L_p where the chain without it is kept") {
  const DomainInput input = domain_of({polygon(1, 6)});
  int with = 0, without = 0;
  for (const int quads : {60, 150, 300, 600}) {
    Trace trace;
    const auto outcome = mesh_domain(input, {.quads = quads, .iterations = 10}, {}, &trace);
    REQUIRE(outcome);
    const Report& report = outcome->report;
    const bool optimised = report.chain.find("L_p") != std::string::npos;
    ++(optimised ? with : without);
    CHECK(report.energy_history.empty() == !optimised);
    CHECK(trace.iterates.empty() == !optimised);
    CHECK(tau(trace.triangles) == report.tau);
    std::int64_t cost = 0;
    for (const CostEdge& edge : trace.graph)
      if (trace.matching.mate[edge.u] == edge.v) cost += edge.cost;
    CHECK(cost == report.matching_cost);
  }
  CHECK(without > 0);
}

TEST_CASE("a grid with far fewer quads than are asked for is not the better mesh") {
  DomainInput input = domain_of({{{0, 0}, {2, 0}, {2, 1}, {0, 1}}});
  Loop hole = polygon(0.2, 24);
  for (Vec2& p : hole) p = p + Vec2{1, 0.5};
  input.regions[0].loops.push_back(hole);
  for (const int quads : {200, 300, 500, 800}) {
    const Report report = meshed(input, {.quads = quads}).report;
    INFO(quads << ": " << report.quality.quads);
    CHECK(std::abs(report.quality.quads - quads) <= 0.2 * quads);
    CHECK(report.warnings.empty());
  }
}
