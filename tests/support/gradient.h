// A gradient against central differences. Per component the best of several steps counts: the error
// falls with the square of the step until rounding makes it rise again, and where a neighbourhood
// is tight only small steps stay within it.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace lpq_test {

/// `value(x)` against `gradient` at x: the largest error of any component in `checked`, relative to
/// the largest component of the gradient.
inline double gradient_error(const std::function<double(const std::vector<double>&)>& value,
                             std::vector<double> x, const std::vector<double>& gradient,
                             const std::vector<std::size_t>& checked,
                             const std::vector<double>& steps) {
  double largest = 0, worst = 0;
  for (const double g : gradient) largest = std::max(largest, std::abs(g));
  for (const std::size_t i : checked) {
    const double at = x[i];
    double best = std::numeric_limits<double>::infinity();
    for (const double step : steps) {
      x[i] = at + step;
      const double up = value(x);
      x[i] = at - step;
      const double down = value(x);
      x[i] = at;
      best = std::min(best, std::abs((up - down) / (2 * step) - gradient[i]));
      if (best <= 1e-8 * largest) break;
    }
    worst = std::max(worst, best / largest);
  }
  return worst;
}

}  // namespace lpq_test
