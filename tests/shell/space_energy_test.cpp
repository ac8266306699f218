// The energies of quads in space have the gradients they say, and in a plane are those of the
// plane.
#include "shell/shape/space_energy.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "catch.h"
#include "cleanup/shape_energy.h"

using namespace lpq;

namespace {

SpaceQuad some_quad(Rng& rng) {
  SpaceQuad p{Vec3{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (Vec3& q : p) q += {rng.between(-0.2, 0.2), rng.between(-0.2, 0.2), rng.between(-0.2, 0.2)};
  return p;
}

/// Largest difference between a gradient and central differences.
template <class Energy>
double gradient_error(const SpaceQuad& p, Energy&& energy) {
  constexpr double step = 1e-6;
  SpaceQuad gradient{}, unused{};
  energy(p, gradient);
  double worst = 0;
  for (int k = 0; k < 4; ++k)
    for (double Vec3::*x : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      SpaceQuad a = p, b = p;
      a[k].*x -= step;
      b[k].*x += step;
      const double slope = (energy(b, unused) - energy(a, unused)) / (2 * step);
      worst = std::max(worst, std::abs(slope - gradient[k].*x));
    }
  return worst;
}

}  // namespace

TEST_CASE("energies in space have the gradients they say") {
  Rng rng(3);
  const Vec3 up{0, 0, 1};
  SpaceEtaOptions eta;
  eta.size_weight = 0.1;
  eta.area_weight = 0.2;
  eta.cover_weight = 0.3;
  for (int i = 0; i < 50; ++i) {
    const SpaceQuad p = some_quad(rng);
    CHECK(gradient_error(p, [&](const SpaceQuad& q, SpaceQuad& gradient) {
            return eta_energy(q, 1.3, up, eta, gradient).value;
          }) < 1e-5);
    CHECK(gradient_error(p, [&](const SpaceQuad& q, SpaceQuad& gradient) {
            return mean_ratio_energy(q, 1.3, up, {.epsilon = 0.1}, gradient).value;
          }) < 1e-5);
  }
}

TEST_CASE("in a plane the energies are those of the plane") {
  Rng rng(4);
  for (int i = 0; i < 50; ++i) {
    SpaceQuad p = some_quad(rng), unused{};
    std::vector<Vec2> flat, by_flat(4);
    for (Vec3& q : p) {
      q.z = 0;
      flat.push_back({q.x, q.y});
    }
    const Face face{0, 1, 2, 3};
    const double unit = 1.3;
    SpaceEtaOptions eta;
    eta.area_weight = 0.2;
    CHECK(eta_energy(p, unit, {0, 0, 1}, eta, unused).value ==
          Approx(eta_energy({&face, 1}, flat, {&unit, 1}, eta, by_flat).value).margin(1e-12));
    CHECK(mean_ratio_energy(p, unit, {0, 0, 1}, {}, unused).value ==
          Approx(mean_ratio_energy({&face, 1}, flat, {&unit, 1}, {}, by_flat).value));
  }
}
