// The energies against central differences, and what they are at known shapes.
#include "catch.h"
#include "cleanup/descent.h"
#include "cleanup/shape_energy.h"
#include "field/field.h"
#include "mesh/quality.h"
#include "support/cleanup_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

// Largest difference between the gradient and central differences, over the largest component.
template <class Energy>
double gradient_error(QuadMesh mesh, Energy energy) {
  std::vector<Vec2> gradient(mesh.points.size()), unused(mesh.points.size());
  REQUIRE(energy(mesh, gradient).status == EvalStatus::ok);
  double error = 0, largest = 0;
  const double step = 1e-5;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    for (double Vec2::*axis : {&Vec2::x, &Vec2::y}) {
      const double at = mesh.points[v].*axis;
      mesh.points[v].*axis = at + step;
      const double above = energy(mesh, unused).value;
      mesh.points[v].*axis = at - step;
      const double below = energy(mesh, unused).value;
      mesh.points[v].*axis = at;
      const double slope = (above - below) / (2 * step);
      error = std::max(error, std::abs(slope - gradient[v].*axis));
      largest = std::max(largest, std::abs(slope));
    }
  return error / largest;
}

QuadMesh with_triangle() {
  QuadMesh mesh = shaken(grid(5, 4), 0.2, 7);
  const Face last = mesh.faces.back();
  mesh.faces.back() = {last[0], last[1], last[2], none};
  mesh.faces.push_back({last[0], last[2], last[3], none});
  return mesh;
}

}  // namespace

TEST_CASE("gradients agree with central differences") {
  const QuadMesh mesh = with_triangle();
  const std::vector<double> unit(mesh.faces.size(), 1.3);
  for (const double epsilon : {0.0, 0.3}) {
    const double error = gradient_error(mesh, [&](const QuadMesh& m, std::span<Vec2> gradient) {
      return mean_ratio_energy(m.faces, m.points, unit, {.epsilon = epsilon}, gradient);
    });
    CHECK(error < 1e-7);
  }
  for (const double weight : {0.0, 0.02, 1.0}) {
    const double error = gradient_error(mesh, [&](const QuadMesh& m, std::span<Vec2> gradient) {
      return eta_energy(m.faces, m.points, unit, {.size_weight = weight}, gradient);
    });
    CHECK(error < 1e-6);
  }
  std::vector<Vec2> pull(mesh.faces.size());
  for (std::size_t f = 0; f < pull.size(); f += 2) pull[f] = {0.3, -0.6};
  CHECK(gradient_error(mesh, [&](const QuadMesh& m, std::span<Vec2> gradient) {
          return eta_energy(m.faces, m.points, unit, {.pull_weight = 3}, gradient, pull);
        }) < 1e-6);
}

TEST_CASE("a stretched face has the energy of what it is made") {
  const QuadMesh mesh = with_triangle();
  const std::vector<double> unit(mesh.faces.size(), 1.3);
  std::vector<Vec2> stretch;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    stretch.push_back({0.1 * static_cast<double>(f % 3), -0.15});
  CHECK(gradient_error(mesh, [&](const QuadMesh& m, std::span<Vec2> gradient) {
          return mean_ratio_energy(m.faces, m.points, unit, {.stretch = stretch}, gradient);
        }) < 1e-7);
  const EtaEnergyOptions options{.area_weight = 0.2, .stretch = stretch};
  CHECK(gradient_error(mesh, [&](const QuadMesh& m, std::span<Vec2> gradient) {
          return eta_energy(m.faces, m.points, unit, options, gradient);
        }) < 1e-6);
  double sum = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    std::vector<Vec2> points, gradient(mesh.points.size());
    for (const Vec2 p : mesh.points) points.push_back(stretched(p, stretch[f]));
    sum += eta_energy({&mesh.faces[f], 1}, points, {&unit[f], 1}, {.area_weight = 0.2}, gradient)
               .value;
  }
  std::vector<Vec2> gradient(mesh.points.size());
  CHECK(eta_energy(mesh.faces, mesh.points, unit, options, gradient).value == Approx(sum));
}

TEST_CASE("a pull costs nothing along its cross, and most at 45 degrees from it") {
  const QuadMesh mesh = grid(3, 2);
  const std::vector<double> unit(mesh.faces.size(), 1.0);
  const auto cost = [&](Vec2 z) {
    std::vector<Vec2> gradient(mesh.points.size());
    const std::vector<Vec2> pull(mesh.faces.size(), z);
    const EtaEnergyOptions options{.pull_weight = 1};
    return (eta_energy(mesh.faces, mesh.points, unit, options, gradient, pull).value -
            eta_energy(mesh.faces, mesh.points, unit, options, gradient).value) /
           (4.0 * static_cast<double>(mesh.faces.size()));
  };
  CHECK(std::abs(cost({1, 0})) < 1e-12);
  CHECK(std::abs(cost({0, 1}) - 1) < 1e-12);
  CHECK(std::abs(cost({-1, 0}) - 2) < 1e-12);
  CHECK(std::abs(cost({-0.5, 0}) - 1) < 1e-12);
}

TEST_CASE("a face's size terms count by its share") {
  const QuadMesh mesh = with_triangle();
  const std::vector<double> unit(mesh.faces.size(), 1.3);
  std::vector<double> share;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    share.push_back(static_cast<double>(f % 3) * 0.5);
  const EtaEnergyOptions options{.size_weight = 0.3, .area_weight = 0.2, .size_share = share};
  const double error = gradient_error(mesh, [&](const QuadMesh& m, std::span<Vec2> gradient) {
    return eta_energy(m.faces, m.points, unit, options, gradient);
  });
  CHECK(error < 1e-6);
  std::vector<Vec2> gradient(mesh.points.size());
  double sum = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    sum += eta_energy({&mesh.faces[f], 1}, mesh.points, {&unit[f], 1},
                      {.size_weight = 0.3 * share[f], .area_weight = 0.2 * share[f]}, gradient)
               .value;
  CHECK(eta_energy(mesh.faces, mesh.points, unit, options, gradient).value == Approx(sum));
}

TEST_CASE("sizes count fully where the field is level and never less than a part") {
  CHECK(share_at_slope(0) == 1);
  double last = 1;
  for (double slope = 0.05; slope < 3; slope += 0.05) {
    const double share = share_at_slope(slope);
    CHECK(share <= last);
    CHECK(share > 0.2);
    last = share;
  }
}

TEST_CASE("the mean ratio is finite and its gradient right on tangled faces") {
  QuadMesh mesh = shaken(grid(4, 4), 1.5, 3);
  const std::vector<double> unit(mesh.faces.size(), 1.0);
  REQUIRE(smallest_corner(mesh.faces, mesh.points, unit) < 0);
  std::vector<Vec2> gradient(mesh.points.size());
  CHECK(mean_ratio_energy(mesh.faces, mesh.points, unit, {}, gradient).status ==
        EvalStatus::outside_domain);
  CHECK(eta_energy(mesh.faces, mesh.points, unit, {}, gradient).status ==
        EvalStatus::outside_domain);
  CHECK(gradient_error(mesh, [&](const QuadMesh& m, std::span<Vec2> g) {
          return mean_ratio_energy(m.faces, m.points, unit, {.epsilon = 0.4}, g);
        }) < 1e-6);
}

TEST_CASE("the eta energy of one quad brackets 1 - eta") {
  Rng rng(5);
  for (int i = 0; i < 200; ++i) {
    QuadMesh mesh = mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2, 3}}, 0);
    for (Vec2& p : mesh.points) p += {rng.between(-0.3, 0.3), rng.between(-0.3, 0.3)};
    const std::vector<double> unit{1};
    std::vector<Vec2> gradient(4);
    const Evaluation e =
        eta_energy(mesh.faces, mesh.points, unit, {.size_weight = 0, .floor_weight = 0}, gradient);
    const double loss = 1 - face_eta(mesh.points, mesh.faces[0]);
    if (e.status != EvalStatus::ok || loss == 1) continue;
    // max <= 8-norm <= 4^(1/8) max
    CHECK(e.value >= loss);
    CHECK(e.value <= 1.19 * loss + 2e-4);
  }
}

TEST_CASE("energies scale exactly with powers of two") {
  QuadMesh mesh = shaken(grid(4, 4), 0.2, 9), scaled = mesh;
  for (Vec2& p : scaled.points) p = 0.125 * p;
  const std::vector<double> unit(mesh.faces.size(), 1.0), small(mesh.faces.size(), 64.0);
  std::vector<Vec2> g(mesh.points.size()), h(mesh.points.size());
  CHECK(eta_energy(mesh.faces, mesh.points, unit, {}, g).value ==
        eta_energy(scaled.faces, scaled.points, small, {}, h).value);
  for (std::size_t v = 0; v < g.size(); ++v) CHECK(8.0 * g[v] == h[v]);
}
