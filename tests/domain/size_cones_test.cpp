// What sizes at points ask of the plane around them.
#include "domain/size_cones.h"

#include <cmath>

#include "base/rng.h"
#include "catch.h"

using namespace lpq;

namespace {

std::vector<SizeSample> map_of_slope(double slope, int count, Rng& rng) {
  std::vector<SizeSample> samples;
  for (int i = 0; i < count; ++i) {
    const Vec2 p{rng.unit(), rng.unit()};
    samples.push_back({p, 0.01 + slope * std::abs(length(p - Vec2{0.5, 0.5}) - 0.3)});
  }
  return samples;
}

}  // namespace

TEST_CASE("an isolated size grows by half within three and a half of its lengths at most") {
  const std::vector<SizeSample> alone{{{0, 0}, 0.1}};
  for (const double growth : {0.2, 0.3, 0.5, 1.0, 10.0}) {
    const SizeCone cone = size_cones(alone, growth, 1e300)[0];
    CHECK(cone.slope <= growth);
    CHECK(cone.reach >= 0);
    CHECK(cone.at(0) == 0.1);
    CHECK(cone.at(0.35) <= 0.15 * (1 + 1e-12));
    CHECK(wider_than_growth({&cone, 1}, growth));
  }
  for (const double growth : {0.01, 0.08, 0.14})
    CHECK_FALSE(wider_than_growth(size_cones(alone, growth, 1e300), growth));
  CHECK_FALSE(wider_than_growth(size_cones(alone, 2, 0.05), 2));  // asks for nothing
}

TEST_CASE("a map of many sizes stays what it is") {
  Rng rng(7);
  for (const double growth : {0.3, 2.0}) {
    const std::vector<SizeSample> samples = map_of_slope(0.3, 800, rng);
    const std::vector<SizeCone> cones = size_cones(samples, growth, 0.1);
    for (std::size_t i = 0; i < cones.size(); ++i) {
      CHECK(cones[i].slope <= growth);
      for (const SizeSample& other : samples) {
        const double d = distance(other.position, cones[i].tip);
        if (d > cones[i].h)  // what is left is one rounding
          REQUIRE(cones[i].at(d) * (1 + 1e-12) >=
                  std::min({0.1, other.h, cones[i].h + growth * d}));
      }
    }
  }
}

TEST_CASE("a size that the growth overrules does not narrow the one that overrules it") {
  const std::vector<SizeSample> pair{{{0, 0}, 0.05}, {{0.2, 0}, 0.5}};
  const std::vector<SizeCone> cones = size_cones(pair, 0.5, 1e300);
  CHECK(cones[0].reach == size_cones({pair.data(), 1}, 0.5, 1e300)[0].reach);
}

TEST_CASE("the least of many cones is found among all") {
  Rng rng(3);
  std::vector<SizeCone> cones;
  for (int i = 0; i < 300; ++i)
    cones.push_back({{rng.unit(), rng.unit()},
                     0.01 + 0.1 * rng.unit(),
                     0.05 * rng.unit(),
                     0.1 + 2 * rng.unit()});
  const LeastCone least(cones);
  for (int i = 0; i < 300; ++i) {
    const Vec2 p{2 * rng.unit() - 0.5, 2 * rng.unit() - 0.5};
    double expected = 0.2;
    for (const SizeCone& cone : cones)
      expected = std::min(expected, cone.at(distance(p, cone.tip)));
    CHECK(least.at(p, 0.2) == expected);
  }
}
