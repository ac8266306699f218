// What must not change the mesh: the unit of length, the order, orientation and start of the loops,
// how the stepping is cut up, and running it again.
#include <algorithm>
#include <array>
#include <set>

#include "catch.h"
#include "pipeline/mesh_domain.h"
#include "pipeline/mesher.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

const Options kept{.keep_boundary = true};

Outcome run(const DomainInput& input, const Options& options = kept) {
  auto outcome = mesh_domain(input, options);
  REQUIRE(outcome);
  return *std::move(outcome);
}

// Faces as sets of corner coordinates: the mesh up to numbering.
std::set<std::array<std::pair<double, double>, 4>> geometry(const OutputMesh& mesh,
                                                            double scale = 1) {
  std::set<std::array<std::pair<double, double>, 4>> faces;
  for (const Face& face : mesh.faces) {
    std::array<std::pair<double, double>, 4> corners;
    for (int k = 0; k < 4; ++k) {
      const Vec2 p = mesh.points[face[k < corner_count(face) ? k : 0]];
      corners[k] = {p.x / scale, p.y / scale};
    }
    std::sort(corners.begin(), corners.end());
    faces.insert(corners);
  }
  return faces;
}

DomainInput scaled(DomainInput input, double factor) {
  for (Loop& loop : input.regions[0].loops)
    for (Vec2& p : loop) p = factor * p;
  input.h *= factor;
  return input;
}

}  // namespace

TEST_CASE("running twice gives the same bytes") {
  CHECK(run(plate_with_hole(0.06)).report.hash == run(plate_with_hole(0.06)).report.hash);
}

TEST_CASE("a power-of-two scale gives the same mesh, exactly") {
  const auto reference = geometry(run(hood(0.08)).mesh);
  for (const int exponent : {-40, -3, 1, 50}) {
    const double factor = std::ldexp(1.0, exponent);
    CHECK(geometry(run(scaled(hood(0.08), factor)).mesh, factor) == reference);
  }
}

TEST_CASE("an arbitrary unit of length changes nothing but the rounding") {
  const Outcome reference = run(plate_with_hole(0.08));
  for (const double factor : {1e-4, 1e-12, 25.4, 1e9}) {
    const Outcome other = run(scaled(plate_with_hole(0.08), factor));
    CHECK(10 * other.mesh.faces.size() > 9 * reference.mesh.faces.size());
    CHECK(other.report.quality.eta_mean > reference.report.quality.eta_mean - 0.05);
  }
}

TEST_CASE("loop order, orientation and start do not matter") {
  const DomainInput input = plate_with_hole(0.08);
  const auto reference = geometry(run(input).mesh);
  DomainInput other = input;
  auto& loops = other.regions[0].loops;
  std::swap(loops[0], loops[1]);
  CHECK(geometry(run(other).mesh) == reference);
  std::reverse(loops[0].begin(), loops[0].end());
  CHECK(geometry(run(other).mesh) == reference);
  std::rotate(loops[1].begin(), loops[1].begin() + 7, loops[1].end());
  CHECK(geometry(run(other).mesh) == reference);
}

TEST_CASE("how the iterations are cut up does not matter, nor does a copy in the middle") {
  Options options = kept;
  options.method = Method::paper;
  options.iterations = 20;
  const auto finish = [](Mesher mesher, int chunk) {
    while (mesher.stage() != Stage::done) REQUIRE(mesher.step(chunk));
    return mesher.report().hash;
  };
  auto mesher = Mesher::start(hood(0.08), options);
  REQUIRE(mesher);
  const auto reference = finish(*mesher, 1);
  CHECK(finish(*mesher, 7) == reference);
  REQUIRE(mesher->step());
  REQUIRE(mesher->step(5));
  const Mesher copy = *mesher;
  CHECK(finish(*mesher, 3) == reference);
  CHECK(finish(copy, 100) == reference);
}

TEST_CASE("far from the origin the mesh is still valid") {
  DomainInput input = square(1, 0.1);
  for (Vec2& p : input.regions[0].loops[0]) p = p + Vec2{1e9, -1e9};
  for (Vec2& p : input.regions[0].loops[0])
    p = {std::round(p.x * 1e3) / 1e3, std::round(p.y * 1e3) / 1e3};
  const auto outcome = mesh_domain(input, kept);
  if (outcome)
    CHECK(outcome->report.quality.triangles == 0);
  else
    CHECK((outcome.error().code == ErrorCode::lost_precision ||
           outcome.error().code == ErrorCode::no_valid_mesh));
}
