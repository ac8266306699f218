// Gauss integration on the segment and the triangle, for any degree, with the same nodes on every
// platform (paper section 3.2.4; [Zienkiewicz, Taylor 2000]).
#pragma once

#include <vector>

namespace lpq {

struct SegmentNode {
  double position = 0;  // in (0, 1)
  double weight = 0;    // weights sum to 1
};

/// Gauss-Legendre with n >= 1 nodes, ascending: exact for polynomials of degree 2 n - 1.
std::vector<SegmentNode> gauss_legendre(int n);

struct TriangleNode {
  double u = 0, v = 0;  // point = (1 - u - v) x0 + u C1 + v C2, paper Eq. (11)
  double weight = 0;    // weights sum to 1: integral = area * sum of weight * value
};

/// Exact for polynomials of the given degree >= 0; all nodes inside, all weights positive. The
/// collapsed product of two segment rules: ((degree + 3) / 2)^2 nodes, not the fewest possible, but
/// available for every degree.
std::vector<TriangleNode> triangle_rule(int degree);

}  // namespace lpq
