// The promises of the README, on small domains: the boundary comes back bit for bit; all quads, or
// a plain reason why not; nothing wrong is presented as right.
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "pipeline/finish.h"
#include "pipeline/mesh_domain.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

const Options kept{.keep_boundary = true};

void require_promises(const DomainInput& input, const Outcome& outcome) {
  REQUIRE(check_output(outcome.mesh).empty());
  CHECK(outcome.report.quality.triangles == 0);
  std::size_t node = 0;
  for (const Loop& loop : input.regions[0].loops)
    for (const Vec2 p : loop) CHECK(outcome.mesh.points[node++] == p);
  CHECK(outcome.mesh.fixed == static_cast<Index>(node));
  // 4 Q = 2 E_int + B, hence by Euler Q = interior vertices + B/2 - chi
  const auto chi = 2 - static_cast<Index>(input.regions[0].loops.size());
  CHECK(outcome.report.quality.quads ==
        outcome.report.interior_vertices + outcome.mesh.fixed / 2 - chi);
}

}  // namespace

TEST_CASE("every shape keeps its boundary and gets quads only") {
  for (const DomainInput& input : {square(1, 0.1), l_shape(0.05), disc(0.1), annulus(0.08),
                                   plate_with_hole(0.08), hood(0.08)}) {
    const auto outcome = mesh_domain(input, kept);
    REQUIRE(outcome);
    require_promises(input, *outcome);
    CHECK(outcome->report.quality.eta_mean > 0.8);
    CHECK(outcome->report.quality.eta_min > 0);
  }
}

TEST_CASE("an aligned square is meshed perfectly") {
  const auto outcome = mesh_domain(square(1, 0.1), kept);
  REQUIRE(outcome);
  CHECK(outcome->report.quality.quads == 100);
  CHECK(outcome->report.quality.eta_min > 0.999);
  CHECK(outcome->report.quality.regular_vertices == 81);
}

TEST_CASE("the paper's chain keeps the same promises") {
  for (const DomainInput& input : {square(1, 0.1), plate_with_hole(0.08), hood(0.08)}) {
    Options options = kept;
    options.method = Method::paper;
    const auto outcome = mesh_domain(input, options);
    REQUIRE(outcome);
    require_promises(input, *outcome);
    const auto& energies = outcome->report.energy_history;
    REQUIRE(energies.size() > 10);
    CHECK(std::is_sorted(energies.rbegin(), energies.rend()));
  }
}

TEST_CASE("an odd boundary is refused with its count, or cured when that is allowed") {
  DomainInput input = domain_of({{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}});
  const auto refused = mesh_domain(input, kept);
  REQUIRE(!refused);
  CHECK(refused.error().code == ErrorCode::odd_boundary);
  CHECK(refused.error().message.find('5') != std::string::npos);

  Options allowed = kept;
  allowed.allow_added_point = true;
  const auto cured = mesh_domain(input, allowed);
  REQUIRE(cured);
  CHECK(cured->report.quality.triangles == 0);
  CHECK(cured->mesh.fixed == 6);

  Options dominant = kept;
  dominant.elements = Elements::quad_dominant;
  const auto mixed = mesh_domain(input, dominant);
  REQUIRE(mixed);
  CHECK(mixed->report.quality.triangles % 2 == 1);
  CHECK(check_output(mixed->mesh).empty());
}

TEST_CASE("the refined boundary holds every given vertex and an even count") {
  DomainInput input = domain_of({{{0, 0}, {3, 0}, {3, 1}, {1.4, 2}, {0, 1}}});
  for (const double size : {1.0, 0.3, 0.07}) {
    const auto outcome = mesh_domain(input, {.size = size});
    REQUIRE(outcome);
    CHECK(check_output(outcome->mesh).empty());
    CHECK(outcome->report.quality.triangles == 0);
    CHECK(outcome->mesh.fixed % 2 == 0);
    for (const Vec2 corner : input.regions[0].loops[0])
      CHECK(std::count(outcome->mesh.points.begin(), outcome->mesh.points.end(), corner) == 1);
  }
}

TEST_CASE("where points of the boundary all but coincide, that is why there is no mesh") {
  OutputMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}, {std::nextafter(0.5, 1.0), 0.5}};
  mesh.fixed = 6;
  const auto told = [&](Vec2 place) { return no_valid_mesh(mesh, {{"It is bent.", 0, 0, place}}); };
  CHECK(told({0.55, 0.5}).code == ErrorCode::touching);
  CHECK(told({0.55, 0.5}).where.x == 0.55);
  CHECK(told({0.9, 0.9}).code == ErrorCode::no_valid_mesh);
  mesh.points[5] = {0.5000001, 0.5};
  CHECK(told({0.55, 0.5}).code == ErrorCode::no_valid_mesh);
}

TEST_CASE("a fallback that would need too many elements does not hide the ones after it") {
  // The dart has a mesh only once quads may be cut; before that smaller sizes are tried.
  DomainInput input = domain_of({{{0.07506245432243641, 0.09769340827937052},
                                  {-0.8776261113230013, 0.4340306028241725},
                                  {-0.0931017031594634, -0.29259320277150114},
                                  {-0.07166958583514722, -0.3965852933124271}}});
  const DomainInput square_beside = square(1, 0.025);
  input.regions.push_back(square_beside.regions[0]);
  for (Vec2& p : input.regions[1].loops[0]) p = p + Vec2{3, 0};
  const auto outcome = mesh_domain(input, {.keep_boundary = true, .max_elements = 2000});
  REQUIRE(outcome);
  CHECK(check_output(outcome->mesh).empty());
  CHECK(outcome->report.attempts > 1);
  CHECK(outcome->report.energy_history.empty() ==
        (outcome->report.chain.find("L_p") == std::string::npos));
  Index adapted = 0;
  for (const Warning& warning : outcome->report.warnings)
    adapted += warning.code == ErrorCode::adapted && warning.where.has_point;
  CHECK(adapted == 1);
}

TEST_CASE("quads beside a kept edge that is long for the size are told with what helps") {
  const DomainInput input = domain_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const auto outcome = mesh_domain(input, {.size = 0.02, .keep_boundary = true});
  REQUIRE(outcome);
  REQUIRE(!outcome->report.warnings.empty());
  for (const Warning& warning : outcome->report.warnings)
    CHECK(warning.message.find("long for the size") != std::string::npos);
}

TEST_CASE("triangles may stay, but not where pairs of them are good quads") {
  DomainInput input = domain_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  input.polylines.push_back({{{0.25, 0.5}, {0.75, 0.5}}, ""});
  const auto outcome =
      mesh_domain(input, {.keep_boundary = true, .elements = Elements::quad_dominant});
  REQUIRE(outcome);
  CHECK(outcome->report.quality.quads == 2);
  CHECK(outcome->report.quality.eta_mean > 0.6);
}

TEST_CASE("sizes that make no sense are refused before any work") {
  const auto code = [](double size) {
    const auto outcome = mesh_domain(square(1, 0.1), {.size = size});
    return outcome ? ErrorCode::no_valid_mesh : outcome.error().code;
  };
  CHECK(code(-1) == ErrorCode::bad_size);
  CHECK(code(NAN) == ErrorCode::bad_size);
  CHECK(code(INFINITY) == ErrorCode::bad_size);
  CHECK(code(5) == ErrorCode::bad_size);
  CHECK(code(1e-9) == ErrorCode::too_many_elements);

  // Small all over, or in a place that nobody looks at first.
  const std::function<double(Vec2)> functions[] = {
      [](Vec2) { return 1e-7; }, [](Vec2 p) { return 0.05 * std::abs(p.x - 0.3) + 1e-9; }};
  for (const auto& size : functions) {
    UserFields user;
    user.size = size;
    const auto refused = mesh_domain(square(1, 0.1), {.max_elements = 100000}, {}, nullptr, user);
    REQUIRE(!refused.has_value());
    CHECK(refused.error().code == ErrorCode::too_many_elements);
  }

  const Loop far{{1e15, 1e15}, {1e15 + 8, 1e15}, {1e15 + 8, 1e15 + 8}, {1e15, 1e15 + 8}};
  DomainInput input;
  input.regions.push_back({"", {far}, {}});
  const auto outcome = mesh_domain(input, {.size = 0.1});
  REQUIRE(!outcome.has_value());
  CHECK(outcome.error().code == ErrorCode::lost_precision);
  CHECK(mesh_domain(input, {.size = 4}).has_value());
}

TEST_CASE("a size that is wrong at a point is refused at that point of the caller's") {
  UserFields user;
  user.sizes = {{{0.75, 0.5}, -1}};
  const auto outcome = mesh_domain(square(3, 0.1), {}, {}, nullptr, user);
  REQUIRE(!outcome.has_value());
  CHECK(outcome.error().code == ErrorCode::bad_size);
  CHECK(outcome.error().where.x == 0.75);
  CHECK(outcome.error().where.y == 0.5);
}

TEST_CASE("sizes and guides are judged as given, whatever the scale of the domain") {
  const DomainInput small = square(0.001, 0.0001);
  const auto with = [&](std::vector<UserFields::SizeAt> sizes,
                        std::vector<UserFields::Guide> guides) {
    UserFields user;
    user.sizes = std::move(sizes);
    user.guides = std::move(guides);
    return mesh_domain(small, {.size = 0.0002}, {}, nullptr, user);
  };
  const auto plain = mesh_domain(small, {.size = 0.0002});
  REQUIRE(plain);
  // Far away, or of no consequence: as if they were not there.
  for (const UserFields::SizeAt& size :
       {UserFields::SizeAt{{1e308, 0}, 0.0002}, {{1e200, -1e308}, 1e-300}, {{0, 0}, 1e308}}) {
    const auto outcome = with({size}, {});
    REQUIRE(outcome);
    CHECK(outcome->report.quality.quads == plain->report.quality.quads);
  }
  CHECK(with({{{NAN, 0}, 0.1}}, {}).error().code == ErrorCode::non_finite);
  CHECK(with({{{1e308, 0}, -1}}, {}).error().where.x == 1e308);
  CHECK(with({{{0, 0}, INFINITY}}, {}).error().code == ErrorCode::bad_size);

  const auto far = with({}, {{{0, 0}, {1e308, 0}}});
  REQUIRE(!far);
  CHECK(far.error().code == ErrorCode::bad_option);
  CHECK(far.error().where.edge == 1);
  CHECK(far.error().message == "Point 1 of guide 0 is too far from the domain. Bring it nearer.");
  CHECK(with({}, {{{0, 0}, {INFINITY, 0}}}).error().code == ErrorCode::non_finite);

  // Too fine for any mesh, and for the unit frame of so large a domain.
  UserFields tiny;
  tiny.sizes = {{{5e99, 5e99}, 1e-300}};
  const auto refused = mesh_domain(square(1e100, 1e99), {}, {}, nullptr, tiny);
  REQUIRE(!refused);
  CHECK(refused.error().code == ErrorCode::lost_precision);
}

TEST_CASE("the target size is met") {
  const auto outcome = mesh_domain(plate_with_hole(0.05), kept);
  REQUIRE(outcome);
  CHECK(outcome->report.size.p10 > 0.75);
  CHECK(outcome->report.size.p90 < 1.35);
}

TEST_CASE("a size given on the boundary is met there, edges of the boundary included") {
  const DomainInput plate = domain_of({{{0, 0}, {2, 0}, {2, 1}, {0, 1}}});
  UserFields user;
  user.sizes = {{{1, 0}, 0.01}};
  const auto outcome = mesh_domain(plate, {.size = 0.1}, {}, nullptr, user);
  REQUIRE(outcome);
  CHECK(check_output(outcome->mesh).empty());
  double shortest = 1, at_sample = 1;
  for (const OutputEdge& e : outcome->mesh.edges) {
    const Vec2 a = outcome->mesh.points[e.a], b = outcome->mesh.points[e.b];
    shortest = std::min(shortest, distance(a, b));
    if (distance(midpoint(a, b), {1, 0}) < distance(a, b)) at_sample = distance(a, b);
  }
  CHECK(shortest > 0.007);
  CHECK(at_sample < 0.014);
  CHECK(outcome->report.size.p10 > 0.75);
  CHECK(outcome->report.size.p90 < 1.35);
  CHECK(outcome->report.quality.eta_mean > 0.9);
  // Kept, the points are the caller's, whatever sizes ask for.
  const auto kept_plate =
      mesh_domain(square(1, 0.1), kept, {}, nullptr, {.sizes = {{{0, 0}, 0.01}}});
  REQUIRE(kept_plate);
  CHECK(kept_plate->mesh.fixed == 40);
}

TEST_CASE("sizes that differ by twenty keep shapes, and shapes keep sizes") {
  // In one spot, and all around a hole (tests/fixtures/domains/twenty_to_one.json).
  const Loop hole = circle({1, 0.5}, 0.04, 50);
  const bool at_hole = GENERATE(false, true);
  const Loop outline{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  const DomainInput plate = at_hole ? domain_of({outline, hole}) : domain_of({outline});
  UserFields user;
  if (at_hole)
    for (const Vec2 p : hole) user.sizes.push_back({p, 0.005});
  else
    user.sizes = {{{0.4, 0.5}, 0.005}};
  const auto outcome = mesh_domain(plate, {.size = 0.1}, {}, nullptr, user);
  REQUIRE(outcome);
  CHECK(check_output(outcome->mesh).empty());
  CHECK(outcome->report.quality.eta_mean > 0.91);
  CHECK(outcome->report.quality.four_valent_percent > 97);
  CHECK(outcome->report.size.p10 > 0.75);
  CHECK(outcome->report.size.p90 < 1.35);
  CHECK(outcome->report.size.min > 0.2);
}

TEST_CASE("sizes grow gently, but not at any price", "[slow]") {
  const DomainInput plate = domain_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const auto quads = [&](double finest, double growth) {
    UserFields user;
    user.sizes = {{{0.5, 0.5}, finest}};
    const auto outcome = mesh_domain(plate, {.size = 0.1, .growth = growth}, {}, nullptr, user);
    REQUIRE(outcome);
    return outcome->report.quality.quads;
  };
  CHECK(quads(0.01, 0) == quads(0.01, 0.08));
  const Index steep = quads(1e-6, 0.3), chosen = quads(1e-6, 0), gentle = quads(1e-6, 0.08);
  CHECK(chosen < 0.8 * gentle);
  CHECK(chosen > steep + 2000);
  CHECK(chosen < steep + 8000);
}

TEST_CASE("a growth too small to mean anything is refused") {
  const auto outcome = mesh_domain(square(1, 0.1), {.growth = 1e-5});
  REQUIRE(!outcome.has_value());
  CHECK(outcome.error().code == ErrorCode::bad_option);
}

TEST_CASE("a caller's size and angle are followed") {
  UserFields user;
  user.size = [](Vec2 p) { return 0.04 + 0.06 * p.x; };
  user.angle = [](Vec2) { return 0.3; };
  const auto outcome = mesh_domain(square(1, 0.05), kept, {}, nullptr, user);
  REQUIRE(outcome);
  CHECK(check_output(outcome->mesh).empty());
}

TEST_CASE("L_p squares up the caller's own start: paper Fig. 12") {
  UserFields user;
  user.seeds = jittered_grid(11, 0.15, 1);
  const auto outcome = mesh_domain(square(1, 0.1), {.keep_boundary = true, .method = Method::paper},
                                   {}, nullptr, user);
  REQUIRE(outcome);
  require_promises(square(1, 0.1), *outcome);
  CHECK(outcome->report.seeds == 81);
  CHECK(outcome->report.chain.rfind("given + L_p", 0) == 0);
  CHECK(outcome->report.tau > 0.999);
  CHECK(outcome->report.quality.quads == 100);

  DomainInput carrying = square(1, 0.1);
  carrying.seeds = user.seeds;
  const Options paper{.keep_boundary = true, .method = Method::paper};
  CHECK(mesh_domain(carrying, paper)->report.hash == outcome->report.hash);
  carrying.seeds = {{0.5, 0.5}};
  CHECK(mesh_domain(carrying, paper, {}, nullptr, user)->report.hash == outcome->report.hash);
  CHECK(mesh_domain(carrying, paper)->report.seeds == 1);
  CHECK(mesh_domain(carrying, paper)->report.warnings.empty());
  carrying.seeds = {{0.5, 0.5}, {1.5, 0.5}, {1e300, 0}, {1, 0.5}};  // the last on the boundary
  const auto told = mesh_domain(carrying, paper)->report.warnings;
  REQUIRE(told.size() == 1);
  CHECK(told[0].code == ErrorCode::ignored);
  CHECK(told[0].message.find("2 of 4 start points lie outside") == 0);
  CHECK(told[0].where.x == 1.5);

  carrying.seeds = {{0.5, std::nan("")}};
  CHECK(mesh_domain(carrying, kept).error().code == ErrorCode::non_finite);
  user.seeds.push_back({0.5, std::nan("")});
  const auto refused = mesh_domain(square(1, 0.1), kept, {}, nullptr, user);
  REQUIRE(!refused);
  CHECK(refused.error().code == ErrorCode::non_finite);
}

TEST_CASE("a monitor can stop the run") {
  int calls = 0;
  const Monitor stop{[](const Progress&, void* user) { return ++*static_cast<int*>(user) < 3; },
                     &calls};
  const auto outcome =
      mesh_domain(plate_with_hole(0.05), {.keep_boundary = true, .method = Method::paper}, stop);
  REQUIRE(!outcome);
  CHECK(outcome.error().code == ErrorCode::cancelled);
  CHECK(calls == 3);
}

TEST_CASE("a quad that is convex by rounding alone is told of, and where it is") {
  OutputMesh mesh;
  mesh.points = {{0, 0}, {1, -1e-9}, {2, 0}, {1, 1}, {1, 2}, {0, 2}};
  mesh.faces = {{0, 1, 2, 3}, {0, 3, 4, 5}};
  const std::vector<Warning> told = tell_poor_quads(mesh);
  REQUIRE(told.size() == 1);
  CHECK(told[0].code == ErrorCode::bad_size);
  CHECK((told[0].where.has_point && told[0].where.x == 1));
  mesh.points[1].y = -0.5;
  CHECK(tell_poor_quads(mesh).empty());
  // Angles do not show it: a rectangle of 1 x 0.005.
  mesh.faces.pop_back();
  mesh.points[2] = {1, 0.005};
  mesh.points[1] = {1, 0};
  mesh.points[3] = {0, 0.005};
  const std::vector<Warning> flat = tell_poor_quads(mesh);
  REQUIRE(flat.size() == 1);
  CHECK(flat[0].message.find("shorter than 0.01 of the longest") != std::string::npos);
}
