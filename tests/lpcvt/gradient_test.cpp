// The gradient of the energy against central differences, in every kind of neighbourhood.
#include "support/gradient.h"

#include <vector>

#include "lpcvt/energy.h"
#include "support/lp_problem.h"

namespace lpq {
namespace {

using namespace lpq_test;
using namespace lpq::test;

struct Case {
  const char* name;
  BoundaryMesh boundary;
  std::vector<Vec2> interior;
  double h;
};

double wave(Vec2 p) { return 0.3 + 0.4 * p.x - 0.7 * p.y + 0.2 * p.x * p.y; }

// Interior points scattered at random: cells of all shapes, many of them cut by walls.
Case square_case(int count, int hug, std::uint64_t seed) {
  BoundaryMesh b = boundary_of({divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.2)});
  auto interior = scattered(b, count, seed, hug);
  return {"square", std::move(b), std::move(interior), 0.2};
}

Case concave_case() {
  BoundaryMesh b = boundary_of(
      {divided({{0, 0}, {1, 0}, {1, 0.35}, {0.45, 0.4}, {0.9, 0.9}, {0, 1}, {0.2, 0.5}}, 0.17)});
  auto interior = scattered(b, 25, 4);
  return {"concave", std::move(b), std::move(interior), 0.15};
}

Case holes_case() {
  BoundaryMesh b =
      boundary_of({divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.25),
                   reversed(circle({0.4, 0.45}, 0.2, 9)), reversed(circle({0.78, 0.75}, 0.13, 5))});
  auto interior = scattered(b, 30, 6);
  return {"holes", std::move(b), std::move(interior), 0.15};
}

Case wall_case() {
  BoundaryMesh b = boundary_of({divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.25)});
  const std::vector<Vec2> wall{{0.2, 0.3}, {0.5, 0.55}, {0.8, 0.5}, {0.7, 0.8}};
  add_wall(b, wall);
  auto interior = scattered(b, 30, 8);
  return {"interior wall", std::move(b), std::move(interior), 0.15};
}

// Long walls with points close to them: several cells meet each wall, trees of obtuse triangles.
Case narrow_case() {
  BoundaryMesh b = boundary_of({{{0, 0}, {1, 0}, {1, 0.2}, {0, 0.25}}});
  auto interior = scattered(b, 14, 3, 3);
  return {"narrow channel", std::move(b), std::move(interior), 0.15};
}

Case sharp_case() {
  BoundaryMesh b = boundary_of({{{0, 0}, {1, 0.1}, {0.95, 0.4}}});
  auto interior = scattered(b, 9, 12);
  return {"sharp corner", std::move(b), std::move(interior), 0.1};
}

Vec2 sheared(Vec2 p) { return {0.5 - 0.3 * p.x + 0.1 * p.y, -0.2 + 0.4 * p.y * p.x}; }

Fields with_stretch(Fields fields, Vec2 (*mu)(Vec2)) {
  for (const Vec2 p : fields.background.points) fields.stretch.push_back(mu(p));
  return fields;
}

double error_of(const Case& c, const Fields& fields, const EnergyOptions& options) {
  const TriMesh start = triangulated(c.boundary, c.interior);
  EnergyWorkspace work;
  std::vector<Vec2> gradient(start.points.size());
  lp_energy(start, fields, options, work, gradient);
  std::vector<double> x, g;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    if (i < static_cast<std::size_t>(start.fixed)) {
      CHECK(gradient[i] == Vec2{});
      continue;
    }
    x.insert(x.end(), {start.points[i].x, start.points[i].y});
    g.insert(g.end(), {gradient[i].x, gradient[i].y});
  }
  TriMesh mesh = start;
  const auto value = [&](const std::vector<double>& at) {
    std::vector<Vec2> points;
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) points.push_back({at[i], at[i + 1]});
    mesh = start;
    REQUIRE(update(mesh, points).status == UpdateStatus::flipped);
    return lp_energy(mesh, fields, options, work, {});
  };
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < x.size(); ++i) all.push_back(i);
  return gradient_error(value, x, g, all, {1e-6 * c.h, 1e-5 * c.h, 1e-7 * c.h, 1e-8 * c.h});
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  cases.push_back(square_case(40, 1, 2));
  cases.push_back(square_case(30, 4, 5));
  cases.push_back(concave_case());
  cases.push_back(holes_case());
  cases.push_back(wall_case());
  cases.push_back(narrow_case());
  cases.push_back(sharp_case());
  return cases;
}

}  // namespace

TEST_CASE("the gradient equals central differences") {
  int clipped = 0;
  for (const Case& c : all_cases()) {
    ClippedDual dual;
    clip_dual(triangulated(c.boundary, c.interior), dual);
    for (const Index s : dual.sheet) clipped += s >= 0;
    const Fields constant = constant_fields(c.boundary, 0.3, c.h);
    const Fields varying =
        fields_of(c.boundary, wave, [&](Vec2 p) { return c.h * (1 + 0.5 * p.x - 0.2 * p.y); });
    for (const double p : {2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
      CAPTURE(c.name, p);
      if (p == 2 || p == 6) CHECK(error_of(c, constant, {.p = p}) < 1e-6);
      CHECK(error_of(c, varying, {.p = p}) < 1e-6);
    }
    CHECK(error_of(c, varying, {.p = 6, .gauss = true}) < 1e-6);
    CHECK(error_of(c, varying, {.p = 4.5}) < 1e-6);
    const Fields stretched = with_stretch(varying, sheared);
    for (const double p : {2.0, 5.0, 6.0}) CHECK(error_of(c, stretched, {.p = p}) < 1e-6);
    // Without the metric's terms it is the gradient of another function: the switch is real.
    CHECK(error_of(c, varying, {.p = 6, .metric_gradient = false}) > 1e-4);
    CHECK(error_of(c, constant, {.p = 6, .metric_gradient = false}) < 1e-6);
  }
  CHECK(clipped > 30);  // the cases do reach the walls
}

TEST_CASE("a stretched plane has the energy of the plane that it is made") {
  Case c = square_case(40, 1, 2);
  const Vec2 mu{0.25, -0.1};
  const Fields stretch = with_stretch(constant_fields(c.boundary, 0.3, c.h), [](Vec2) {
    return Vec2{0.25, -0.1};
  });
  // Away from the walls, with the cells as they are in the plane.
  TriMesh mesh = triangulated(c.boundary, c.interior);
  EnergyWorkspace work;
  lp_energy(mesh, stretch, {}, work, {});
  const std::vector<double> energy = work.cell_energy;
  const std::vector<double> area = work.cell_area;
  for (Vec2& p : mesh.points) p = stretched(p, mu);
  for (Vec2& p : work.dual.vertices) p = stretched(p, mu);
  work.stretch.clear();
  integrate_energy(mesh, {}, work, {});
  for (std::size_t v = 0; v < energy.size(); ++v) {
    CHECK(work.cell_energy[v] == Approx(energy[v]));
    CHECK(work.cell_area[v] == Approx(area[v]));
  }
}

}  // namespace lpq
