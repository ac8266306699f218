// Quadrature: exactness up to the declared degree against factorials, symmetry, positivity.
#include "numerics/quadrature.h"

#include <cmath>

#include "catch.h"
#include "numerics/power.h"

namespace lpq {
namespace {

double factorial(int n) {
  double product = 1;
  for (int k = 2; k <= n; ++k) product *= k;
  return product;
}

}  // namespace

TEST_CASE("Gauss-Legendre integrates x^k exactly up to degree 2 n - 1") {
  for (int n = 1; n <= 24; ++n) {
    const auto nodes = gauss_legendre(n);
    REQUIRE(nodes.size() == static_cast<std::size_t>(n));
    for (int k = 0; k <= 2 * n - 1; ++k) {
      double sum = 0;
      for (const SegmentNode& node : nodes) sum += node.weight * integer_power(node.position, k);
      CHECK(std::abs(sum * (k + 1) - 1) < 1e-13);
    }
    for (int i = 0; i < n; ++i) {
      const SegmentNode a = nodes[static_cast<std::size_t>(i)];
      const SegmentNode b = nodes[static_cast<std::size_t>(n - 1 - i)];
      CHECK(a.weight > 0);
      CHECK(std::abs(a.position + b.position - 1) < 1e-15);
      CHECK(std::abs(a.weight - b.weight) < 1e-14);
      if (i > 0) CHECK(nodes[static_cast<std::size_t>(i - 1)].position < a.position);
    }
  }
}

TEST_CASE("the triangle rule integrates u^a v^b exactly up to its degree") {
  for (int degree = 0; degree <= 22; ++degree) {
    const auto nodes = triangle_rule(degree);
    for (const TriangleNode& node : nodes) {
      CHECK(node.weight > 0);
      CHECK((node.u > 0 && node.v > 0 && node.u + node.v < 1));
    }
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b) {
        double sum = 0;
        for (const TriangleNode& node : nodes)
          sum += node.weight * integer_power(node.u, a) * integer_power(node.v, b);
        // Twice a! b! / (a + b + 2)!: the weights are those of unit area.
        const double exact = 2 * factorial(a) * factorial(b) / factorial(a + b + 2);
        CHECK(std::abs(sum / exact - 1) < 2e-13);
      }
  }
}

}  // namespace lpq
