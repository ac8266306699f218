// Nodes are the roots of Legendre's polynomial, found by Newton's method from Chebyshev's guess; on
// the triangle the square's product rule is collapsed onto one corner, whose Jacobian raises the
// degree in one direction by one.
#include "numerics/quadrature.h"

#include <algorithm>

#include "numerics/elementary.h"

namespace lpq {
namespace {

struct Legendre {
  double value, derivative;
};

// P_n and its derivative at |x| < 1 by the three-term recurrence.
Legendre legendre(int n, double x) {
  double previous = 0, current = 1;
  for (int k = 1; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * current - (k - 1) * previous) / k;
    previous = current;
    current = next;
  }
  return {current, n * (x * current - previous) / (x * x - 1)};
}

}  // namespace

std::vector<SegmentNode> gauss_legendre(int n) {
  std::vector<SegmentNode> nodes(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    double x = -sin_cos(pi * (i + 0.75) / (n + 0.5)).cos;
    // Quadratic convergence from an error below 1/n^2: six steps reach rounding for every n.
    for (int step = 0; step < 6; ++step) {
      const Legendre p = legendre(n, x);
      x -= p.value / p.derivative;
    }
    const double slope = legendre(n, x).derivative;
    nodes[static_cast<std::size_t>(i)] = {0.5 * (1 + x), 1 / ((1 - x * x) * slope * slope)};
  }
  return nodes;
}

std::vector<TriangleNode> triangle_rule(int degree) {
  // Along the collapsed direction the Jacobian 1 - v adds one degree: 2 n - 1 >= degree + 1.
  const std::vector<SegmentNode> line = gauss_legendre((std::max(degree, 0) + 3) / 2);
  std::vector<TriangleNode> nodes;
  nodes.reserve(line.size() * line.size());
  for (const SegmentNode& v : line)
    for (const SegmentNode& u : line) {
      const double shrink = 1 - v.position;
      nodes.push_back({u.position * shrink, v.position, 2 * u.weight * v.weight * shrink});
    }
  return nodes;
}

}  // namespace lpq
