// Laws of the energy: known values, invariance, continuity across a flip, areas, Gauss.
#include "lpcvt/energy.h"

#include "support/lp_problem.h"
#include "voronoi/clipped.h"

namespace lpq {
namespace {

using namespace lpq_test;
using namespace lpq::test;

BoundaryMesh plate() {
  return boundary_of(
      {divided({{0, 0}, {1, 0}, {1, 0.75}, {0, 1}}, 0.2), reversed(circle({0.4, 0.4}, 0.15, 8))});
}

double energy_at(const BoundaryMesh& boundary, const std::vector<Vec2>& interior,
                 const Fields& fields, const EnergyOptions& options, EnergyWorkspace& work) {
  return lp_energy(triangulated(boundary, interior), fields, options, work, {});
}

template <class Map>
BoundaryMesh mapped(BoundaryMesh boundary, Map map) {
  for (Vec2& p : boundary.points) p = map(p);
  boundary.world = boundary.points;
  return boundary;
}

template <class Map>
std::vector<Vec2> mapped(std::vector<Vec2> points, Map map) {
  for (Vec2& p : points) p = map(p);
  return points;
}

}  // namespace

TEST_CASE("p = 2 is the second moment of the cells, summed from their polygons") {
  const BoundaryMesh boundary = plate();
  const double h = 0.2;
  const TriMesh mesh = triangulated(boundary, scattered(boundary, 30, 3));
  EnergyWorkspace work;
  const double energy = lp_energy(mesh, constant_fields(boundary, 0.37, h), {.p = 2}, work, {});
  ClippedVoronoi voronoi;
  clip_voronoi(mesh, voronoi);
  double moment = 0, area = 0;
  for (const FanTriangle& fan : voronoi.cells.values) {
    const Vec2 u = voronoi.vertices[fan.c1].point - mesh.points[fan.site];
    const Vec2 v = voronoi.vertices[fan.c2].point - mesh.points[fan.site];
    moment += cross(u, v) / 12 * (dot(u, u) + dot(v, v) + dot(u, v));
  }
  for (const double a : work.cell_area) area += a;
  CHECK(std::abs(energy * h * h * h * h / moment - 1) < 1e-12);
  CHECK(std::abs(area / mesh_area(mesh) - 1) < 1e-12);
}

TEST_CASE("a square grid has a known energy") {
  // Inner cells are squares of side h: 2 int_{-1/2}^{1/2} x^p dx = 2^(1-p) / (p + 1) each.
  const BoundaryMesh boundary = boundary_of({divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.125)});
  std::vector<Vec2> interior;
  for (int j = 1; j < 8; ++j)
    for (int i = 1; i < 8; ++i) interior.push_back({0.125 * i, 0.125 * j});
  const Fields fields = constant_fields(boundary, 0, 0.125);
  for (const double p : {2.0, 6.0, 20.0}) {
    EnergyWorkspace work;
    std::vector<Vec2> gradient(boundary.points.size() + interior.size());
    lp_energy(triangulated(boundary, interior), fields, {.p = p}, work, gradient);
    const double cell = std::pow(2.0, 1 - p) / (p + 1);
    for (std::size_t i = boundary.points.size(); i < gradient.size(); ++i) {
      CHECK(std::abs(work.cell_energy[i] / cell - 1) < 1e-12);
      CHECK(length(gradient[i]) < 1e-12);  // the paper's global minimum (Fig. 12) is stationary
    }
  }
}

TEST_CASE("translation, a right angle and the unit of length leave the energy alone") {
  const BoundaryMesh boundary = plate();
  const auto interior = scattered(boundary, 40, 5);
  const auto theta = [](Vec2 p) { return 0.2 + 0.3 * p.x; };
  const auto size = [](Vec2 p) { return 0.2 + 0.05 * p.y; };
  for (const double p : {2.0, 5.0, 6.0}) {
    EnergyWorkspace work;
    const double energy =
        energy_at(boundary, interior, fields_of(boundary, theta, size), {.p = p}, work);

    const Vec2 shift{0.3, -0.2};
    const auto move = [&](Vec2 x) { return x + shift; };
    const auto back = [&](Vec2 x) { return x - shift; };
    const BoundaryMesh there = mapped(boundary, move);
    const Fields shifted = fields_of(
        there, [&](Vec2 x) { return theta(back(x)); }, [&](Vec2 x) { return size(back(x)); });
    EnergyWorkspace fresh;
    CHECK(std::abs(energy_at(there, mapped(interior, move), shifted, {.p = p}, fresh) / energy -
                   1) < 1e-9);

    const auto turn = [](Vec2 x) { return perpendicular(x); };
    const auto unturn = [](Vec2 x) { return -perpendicular(x); };
    const BoundaryMesh turned = mapped(boundary, turn);
    // Crosses have a right angle's symmetry: turning them as well changes nothing.
    const Fields turned_fields = fields_of(
        turned, [&](Vec2 x) { return theta(unturn(x)); }, [&](Vec2 x) { return size(unturn(x)); });
    EnergyWorkspace third;
    CHECK(std::abs(energy_at(turned, mapped(interior, turn), turned_fields, {.p = p}, third) /
                       energy -
                   1) < 1e-9);

    const double unit = 0x1p-11;
    const auto shrink = [&](Vec2 x) { return unit * x; };
    const BoundaryMesh small = mapped(boundary, shrink);
    const Fields small_fields = fields_of(
        small, [&](Vec2 x) { return theta((1 / unit) * x); },
        [&](Vec2 x) { return unit * size((1 / unit) * x); });
    EnergyWorkspace fourth;
    CHECK(energy_at(small, mapped(interior, shrink), small_fields, {.p = p}, fourth) == energy);
  }
}

TEST_CASE("the energy is continuous and differentiable across a Delaunay flip") {
  // A site walks through the circle of three others; the flip happens at t = 0.
  const BoundaryMesh boundary = boundary_of({divided({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, 1)});
  const auto sites = [](double t) {
    return std::vector<Vec2>{{0.6, 0}, {0, 0.6}, {-0.6, 0}, {0.12 * t, -0.6 + t}};
  };
  const Fields fields = constant_fields(boundary, 0.3, 1);
  for (const double p : {2.0, 6.0}) {
    const auto at = [&](double t, std::vector<Vec2>& gradient) {
      EnergyWorkspace work;
      const TriMesh mesh = triangulated(boundary, sites(t));
      gradient.resize(mesh.points.size());
      return lp_energy(mesh, fields, {.p = p}, work, gradient);
    };
    for (const double step : {1e-4, 1e-6, 1e-8}) {
      std::vector<Vec2> before, after;
      const double low = at(-step, before), high = at(step, after);
      CHECK(std::abs(high - low) <= 20 * step * high);
      for (std::size_t i = 0; i < before.size(); ++i)
        CHECK(length(after[i] - before[i]) <= 100 * step * high);
    }
  }
}

TEST_CASE("Gauss integration gives the closed form's energy and gradient") {
  const BoundaryMesh boundary = plate();
  const TriMesh mesh = triangulated(boundary, scattered(boundary, 60, 5, 2));
  const Fields fields = fields_of(
      boundary, [](Vec2 p) { return p.x; }, [](Vec2 p) { return 0.2 + 0.1 * p.y; });
  for (int p = 2; p <= 20; p += 2) {
    EnergyWorkspace work;
    std::vector<Vec2> closed(mesh.points.size()), gauss(mesh.points.size());
    const double a = lp_energy(mesh, fields, {.p = 1.0 * p}, work, closed);
    const double b = lp_energy(mesh, fields, {.p = 1.0 * p, .gauss = true}, work, gauss);
    CHECK(std::abs(a / b - 1) < 1e-12);
    double largest = 0;
    for (const Vec2 g : gauss) largest = std::max(largest, length(g));
    for (std::size_t i = 0; i < gauss.size(); ++i)
      CHECK(length(closed[i] - gauss[i]) <= 1e-11 * largest);
  }
}

TEST_CASE("a workspace that has seen another mesh changes no bit") {
  const BoundaryMesh boundary = plate();
  const Fields fields = constant_fields(boundary, 0.1, 0.2);
  EnergyWorkspace used, fresh;
  energy_at(boundary, scattered(boundary, 90, 1), fields, {.p = 4}, used);
  const auto interior = scattered(boundary, 20, 2);
  CHECK(energy_at(boundary, interior, fields, {.p = 6}, used) ==
        energy_at(boundary, interior, fields, {.p = 6}, fresh));
}

TEST_CASE("no interior site: the energy of the boundary cells alone") {
  const BoundaryMesh boundary = plate();
  EnergyWorkspace work;
  CHECK(energy_at(boundary, {}, constant_fields(boundary, 0, 0.2), {}, work) > 0);
}

}  // namespace lpq
