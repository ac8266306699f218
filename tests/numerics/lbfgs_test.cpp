// L-BFGS: known minima, strict descent, refused regions, caps, resumability, scale invariance.
#include "numerics/lbfgs.h"

#include <cmath>
#include <limits>
#include <vector>

#include "base/rng.h"
#include "catch.h"

namespace lpq {
namespace {

const auto rosenbrock = [](std::span<const double> x, std::span<double> g) -> Evaluation {
  double value = 0;
  for (double& gi : g) gi = 0;
  for (std::size_t i = 0; i + 1 < x.size(); i += 2) {
    const double a = 1 - x[i], b = x[i + 1] - x[i] * x[i];
    value += a * a + 100 * b * b;
    g[i] = -2 * a - 400 * x[i] * b;
    g[i + 1] = 200 * b;
  }
  return {value, EvalStatus::ok};
};

// 1/2 sum c_i (x_i - t_i)^2 with curvatures over four decades.
struct Quadratic {
  std::vector<double> curvature, target;
  explicit Quadratic(std::size_t n) {
    Rng rng(7);
    for (std::size_t i = 0; i < n; ++i) {
      curvature.push_back(std::pow(10.0, rng.between(-2, 2)));
      target.push_back(rng.between(-1, 1));
    }
  }
  Evaluation operator()(std::span<const double> x, std::span<double> g) const {
    double value = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double d = x[i] - target[i];
      value += 0.5 * curvature[i] * d * d;
      g[i] = curvature[i] * d;
    }
    return {value, EvalStatus::ok};
  }
};

void check_strict_descent(const Lbfgs& lbfgs) {
  const std::vector<double>& values = lbfgs.value_history();
  for (std::size_t k = 1; k < values.size(); ++k) CHECK(values[k] < values[k - 1]);
  CHECK(values.size() == static_cast<std::size_t>(lbfgs.iterations()) + 1);
  CHECK(lbfgs.gradient_norm_history().size() == values.size());
  CHECK(values.back() == lbfgs.value());
}

}  // namespace

TEST_CASE("a quadratic is minimised to the gradient tolerance") {
  for (const std::size_t n : {1u, 2u, 3u, 5u, 64u, 301u}) {
    const Quadratic f(n);
    Lbfgs lbfgs(std::vector<double>(n, 0.0), {.value_tolerance = 0});
    CHECK(lbfgs.step(2000, f) == LbfgsStatus::converged);
    for (std::size_t i = 0; i < n; ++i) CHECK(std::abs(lbfgs.x()[i] - f.target[i]) < 1e-6);
    check_strict_descent(lbfgs);
  }
}

TEST_CASE("Rosenbrock's valley is followed to its end") {
  for (const int memory : {1, 3, 7, 50}) {
    Lbfgs lbfgs({-1.2, 1.0, 0.5, -3.0}, {.memory = memory, .value_tolerance = 0});
    CHECK(lbfgs.step(1000, rosenbrock) == LbfgsStatus::converged);
    for (const double x : lbfgs.x()) CHECK(std::abs(x - 1) < 1e-6);
    check_strict_descent(lbfgs);
    CHECK(lbfgs.evaluations() < 2 * lbfgs.iterations() + 20);
  }
}

TEST_CASE("step(10) is ten times step(1), and a copy goes the same way") {
  Lbfgs a({-1.2, 1.0, 2.0, 2.0}), b = a;
  for (int round = 0; round < 3; ++round) {
    a.step(10, rosenbrock);
    for (int i = 0; i < 10; ++i) b.step(1, rosenbrock);
    CHECK(a.x() == b.x());
    CHECK(a.value_history() == b.value_history());
    CHECK(a.evaluations() == b.evaluations());
    b = Lbfgs(a);
  }
}

TEST_CASE("a refused region is never entered and the constrained minimum is approached") {
  // Minimise |x - (2, 0)|^2 where |x| >= 1 is refused: the best admissible point is (1, 0).
  bool entered = false;
  const auto f = [&](std::span<const double> x, std::span<double> g) -> Evaluation {
    if (x[0] * x[0] + x[1] * x[1] >= 1) return {1e300, EvalStatus::outside_domain};
    const double d = x[0] - 2;
    g[0] = 2 * d;
    g[1] = 2 * x[1];
    return {d * d + x[1] * x[1], EvalStatus::ok};
  };
  Lbfgs lbfgs({-0.5, 0.0});
  while (lbfgs.status() == LbfgsStatus::running) {
    lbfgs.step(1, f);
    entered = entered || lbfgs.x()[0] * lbfgs.x()[0] + lbfgs.x()[1] * lbfgs.x()[1] >= 1;
  }
  CHECK_FALSE(entered);
  CHECK(lbfgs.x()[0] > 0.99);
  CHECK(lbfgs.iterations() < 200);
  check_strict_descent(lbfgs);
}

TEST_CASE("NaN values and a refused start do not spread") {
  const auto nan_beyond_two = [](std::span<const double> x, std::span<double> g) -> Evaluation {
    g[0] = 2 * (x[0] - 3);
    if (x[0] > 2) return {std::numeric_limits<double>::quiet_NaN(), EvalStatus::ok};
    return {(x[0] - 3) * (x[0] - 3), EvalStatus::ok};
  };
  Lbfgs lbfgs({0.0});
  lbfgs.step(100, nan_beyond_two);
  CHECK(lbfgs.x()[0] <= 2);
  CHECK(lbfgs.x()[0] > 1.9);

  const auto refuse = [](std::span<const double>, std::span<double>) -> Evaluation {
    return {0, EvalStatus::degenerate};
  };
  Lbfgs refused({0.0});
  CHECK(refused.step(5, refuse) == LbfgsStatus::stalled);
  CHECK(refused.iterations() == 0);
}

TEST_CASE("no unknown moves more than its limit; the first move stays below its share") {
  const Quadratic f(20);
  std::vector<double> limit(20, 0.05);
  limit[3] = std::numeric_limits<double>::infinity();
  limit[4] = 0.001;
  const LbfgsOptions options{.value_tolerance = 0};
  Lbfgs lbfgs(std::vector<double>(20, 0.0), options, limit);
  std::vector<double> before = lbfgs.x();
  for (int k = 0; lbfgs.status() == LbfgsStatus::running && k < 3000; ++k) {
    lbfgs.step(1, f);
    // 1 + 2^-40: x + t d is rounded after the cap was computed.
    const double share = (k == 0 ? options.first_move : 1.0) * (1 + 0x1p-40);
    for (std::size_t i = 0; i < limit.size(); ++i)
      REQUIRE(std::abs(lbfgs.x()[i] - before[i]) <= share * limit[i] + 0x1p-50);
    before = lbfgs.x();
  }
  CHECK(lbfgs.status() == LbfgsStatus::converged);
}

TEST_CASE("a non-smooth value ends stagnated or stalled, never in a loop") {
  const auto f = [](std::span<const double> x, std::span<double> g) -> Evaluation {
    double value = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      value += std::abs(x[i] - 0.3) * static_cast<double>(i + 1);
      g[i] = (x[i] > 0.3 ? 1.0 : -1.0) * static_cast<double>(i + 1);
    }
    return {value, EvalStatus::ok};
  };
  Lbfgs lbfgs({1.0, -1.0, 2.0});
  const LbfgsStatus status = lbfgs.step(10000, f);
  CHECK((status == LbfgsStatus::stagnated || status == LbfgsStatus::stalled));
  CHECK(lbfgs.value() < 1e-3);
  check_strict_descent(lbfgs);
}

TEST_CASE("nothing to do: no unknowns, or a start at the minimum") {
  const auto zero = [](std::span<const double>, std::span<double>) { return Evaluation{}; };
  Lbfgs empty({});
  CHECK(empty.step(10, zero) == LbfgsStatus::converged);
  const Quadratic f(3);
  Lbfgs at_minimum(f.target);
  CHECK(at_minimum.step(10, f) == LbfgsStatus::converged);
  CHECK(at_minimum.iterations() == 0);
}

TEST_CASE("a change of unit by a power of two changes no bit") {
  const Quadratic f(9);
  const double unit = 0x1p+13;
  const auto scaled = [&](std::span<const double> x, std::span<double> g) {
    std::vector<double> plain(x.begin(), x.end());
    for (double& v : plain) v /= unit;
    const Evaluation result = f(plain, g);
    for (double& v : g) v /= unit;
    return result;
  };
  Lbfgs a(std::vector<double>(9, 0.5), {}, std::vector<double>(9, 0.1));
  Lbfgs b(std::vector<double>(9, 0.5 * unit), {}, std::vector<double>(9, 0.1 * unit));
  a.step(60, f);
  b.step(60, scaled);
  CHECK(a.value_history() == b.value_history());
  for (std::size_t i = 0; i < 9; ++i) CHECK(a.x()[i] * unit == b.x()[i]);
}

}  // namespace lpq
