// The energy of one sub-triangle: the integral of |y_1|^p + |y_2|^p over the triangle (0, u, v),
// with its derivatives by u and v. u and v are Voronoi vertices seen from their site, turned into
// the cross's frame and divided by h there; then rho = h^-(p+2) has become 1 and every number is of
// order one, so nothing can underflow (paper section 3.3.2) up to p = 20 and beyond.
#pragma once

#include <span>

#include "numerics/quadrature.h"

namespace lpq {

/// A block of sub-triangles, one array per quantity: what the compiler turns into SIMD.
struct PieceBlock {
  static constexpr int capacity = 256;
  template <class T>
  using Array = T[capacity];

  Array<double> ux, uy, vx, vy;      // in
  Array<double> double_area;         // out: u x v, signed
  Array<double> energy;              // out
  Array<double> dux, duy, dvx, dvy;  // out: derivatives of the energy
};

/// Is there a closed form? For p = 2, 4, .. 20.
bool has_closed_form(double p);

/// Exact, for even p (polynomial identities below). Cost about 5 p + 30 flops per sub-triangle.
void integrate_closed_form(int p, int count, PieceBlock& block);

/// By the given rule, for any real p >= 2 (paper section 3.2.4): value and derivatives are those of
/// the same sum, so the gradient is exact for the sum whatever the rule's error.
void integrate_gauss(double p, std::span<const TriangleNode> rule, int count, PieceBlock& block);

/// Degree of the rule used for p: exact for even p; otherwise the integrand has a kink of order p
/// on the cross's arms and a few more nodes keep its error below the optimiser's concern.
int gauss_degree(double p);

}  // namespace lpq
