// A session can be stepped, left, taken back and copied without any change in what it computes.
#include "pipeline/session.h"

#include <algorithm>

#include "catch.h"
#include "pipeline/iterate_log.h"
#include "pipeline/mesh_domain.h"
#include "pipeline/snapshot.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

const Options paper{.keep_boundary = true, .method = Method::paper, .iterations = 30};
const Options restarted{
    .keep_boundary = true, .method = Method::paper, .iterations = 30, .restarts = 3};

Session started(const DomainInput& input, const Options& options = paper) {
  auto session = Session::start(input, options);
  REQUIRE(session);
  return std::move(*session);
}

void finish(Session& session) {
  while (session.mesher().stage() != Stage::done) REQUIRE(session.step(7));
}

double polygon_area(std::span<const Vec2> polygon) {
  double twice = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    twice += cross(polygon[k] - polygon[0], polygon[(k + 1) % polygon.size()] - polygon[0]);
  return twice / 2;
}

}  // namespace

TEST_CASE("a session ends where the batch run ends, however it is stepped") {
  const DomainInput input = hood(0.08);
  const auto batch = mesh_domain(input, paper);
  REQUIRE(batch);
  Session by_one = started(input), by_seven = started(input);
  while (by_one.mesher().stage() != Stage::done) REQUIRE(by_one.step());
  finish(by_seven);
  CHECK(by_one.mesher().report().hash == batch->report.hash);
  CHECK(by_seven.mesher().report().hash == batch->report.hash);
  CHECK(by_one.ticks() == by_seven.ticks());
}

void check_iterates(const Options& options) {
  Trace trace;
  const DomainInput input = disc(0.1);
  const auto batch = mesh_domain(input, options, {}, &trace);
  REQUIRE(batch);
  REQUIRE(trace.iterates.size() > 10);
  Session session = started(input, options);
  REQUIRE(session.step());
  for (std::size_t k = 0; k < trace.iterates.size(); ++k) {
    REQUIRE(session.step());
    CHECK(trace.iterates[k].iteration == static_cast<int>(k) + 1);
    CHECK(trace.iterates[k].mesh.points == session.mesher().triangles().points);
    CHECK(trace.iterates[k].mesh.triangles == session.mesher().triangles().triangles);
  }
  CHECK(trace.iterates.size() + 1 == batch->report.energy_history.size());
  CHECK(trace.iterates.back().mesh.points == trace.triangles.points);
  finish(session);
  CHECK(session.mesher().report().hash == batch->report.hash);
}

TEST_CASE("a traced run keeps the mesh of every iteration, as a session shows it") {
  check_iterates(paper);
  check_iterates(restarted);
}

TEST_CASE("without L_p there are no iterations to keep") {
  Trace trace;
  REQUIRE(mesh_domain(disc(0.1), {}, {}, &trace));
  CHECK(trace.iterates.empty());
}

TEST_CASE("a log of iterations that grows too large keeps every second, fourth, ... of them") {
  TriMesh mesh;
  mesh.points.resize(10);
  IterateLog log(75);  // seven meshes
  for (int k = 1; k <= 20; ++k) log.add(k, mesh);
  log.add(20, mesh);
  std::vector<int> kept;
  for (const Iterate& one : log.take()) kept.push_back(one.iteration);
  CHECK(kept == std::vector<int>{4, 8, 12, 16, 20});
}

void check_going_back(const Options& options) {
  Session session = started(disc(0.1), options);
  std::vector<std::vector<Vec2>> seen{triangle_layer(session.mesher()).points};
  while (session.mesher().stage() != Stage::done) {
    REQUIRE(session.step());
    seen.push_back(triangle_layer(session.mesher()).points);
  }
  const int last = session.ticks();
  for (const int k : {last, 0, 1, 17, 16, last - 1, 2, 31, last}) {
    REQUIRE(session.restore(k));
    CHECK(session.ticks() == k);
    CHECK(triangle_layer(session.mesher()).points == seen[static_cast<std::size_t>(k)]);
  }
  CHECK_FALSE(session.restore(-1));
  CHECK(session.ticks() == last);
}

TEST_CASE("going back shows exactly the points that were there") {
  check_going_back(paper);
  check_going_back(restarted);
}

TEST_CASE("restarts come by themselves where the count is ours, and are reported") {
  const DomainInput input = disc(0.1);
  const auto rounds = [&](Options options, const UserFields& user = {}) {
    const auto outcome = mesh_domain(input, options, {}, nullptr, user);
    REQUIRE(outcome);
    return outcome->report.lp_rounds.size();
  };
  const UserFields own{.seeds = {{0.1, 0.1}, {-0.2, 0.1}, {0, 0.3}}};
  CHECK(rounds({.seeds = Seeds::isotropic}) > 1);
  CHECK(rounds({.seeds = Seeds::isotropic, .restarts = 0}) == 0);
  CHECK(rounds({.seeds = Seeds::isotropic, .iterations = 20}) == 0);
  CHECK(rounds({.method = Method::paper}) == 0);
  CHECK(rounds({.method = Method::paper, .restarts = 2}) == 2);
  CHECK(rounds({}) == 0);
  CHECK(rounds({}, own) == 0);
  CHECK(rounds({.restarts = 3}, own) == 3);
}

TEST_CASE("a copy goes its own way") {
  Session session = started(plate_with_hole(0.1));
  REQUIRE(session.step(5));
  Session copy = session;
  finish(copy);
  CHECK(session.ticks() == 5);
  finish(session);
  CHECK(session.mesher().report().hash == copy.mesher().report().hash);
}

TEST_CASE("both fields can be seen before the first step") {
  Session session = started(disc(0.1));
  const CrossLayer crosses = cross_layer(session.mesher());
  const SizeLayer sizes = size_layer(session.mesher());
  REQUIRE(session.step());
  CHECK(!crosses.axis.empty());
  CHECK(crosses.axis == cross_layer(session.mesher()).axis);
  CHECK(sizes.h == size_layer(session.mesher()).h);
}

TEST_CASE("the layers of a session agree with the domain and with each other") {
  Session session = started(annulus(0.1));
  REQUIRE(session.step(4));
  const CellLayer cells = cell_layer(session.mesher());
  const TriangleLayer triangles = triangle_layer(session.mesher());
  double cell_area = 0, triangle_area = 0;
  for (Index c = 0; c < cells.polygons.rows(); ++c)
    cell_area += polygon_area(cells.polygons.row(c));
  for (const Tri& t : triangles.triangles) {
    const std::array<Vec2, 3> corners{triangles.points[t[0]], triangles.points[t[1]],
                                      triangles.points[t[2]]};
    triangle_area += polygon_area(corners);
  }
  CHECK(cell_area == Approx(triangle_area).epsilon(1e-12));
  CHECK(cells.energy == Approx(session.mesher().energy()).epsilon(1e-12));
  CHECK(matching_layer(session.mesher()).triangles.empty());
  CHECK(quad_layer(session.mesher()).faces.empty());

  finish(session);
  const MatchingLayer matching = matching_layer(session.mesher());
  for (std::size_t t = 0; t < matching.mate.size(); ++t) {
    REQUIRE(matching.mate[t] != none);
    CHECK(matching.mate[static_cast<std::size_t>(matching.mate[t])] == static_cast<Index>(t));
  }
  const QuadLayer quads = quad_layer(session.mesher());
  const QuadQuality& quality = session.mesher().report().quality;
  CHECK(static_cast<Index>(quads.faces.size()) == quality.quads);
  CHECK(*std::min_element(quads.eta.begin(), quads.eta.end()) == quality.eta_min);
  Index irregular = 0;
  for (std::size_t v = static_cast<std::size_t>(quads.fixed); v < quads.points.size(); ++v)
    irregular += quads.excess[v] != 0 ? 1 : 0;
  CHECK(irregular == quality.interior_vertices - quality.regular_vertices);
}
