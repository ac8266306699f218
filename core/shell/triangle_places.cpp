// See triangle_places.h.
#include "shell/triangle_places.h"

#include <algorithm>

namespace lpq {
namespace {

constexpr double most_steps = 1000;  // along a side

int count_of(double length, double step) {
  return std::max(1, static_cast<int>(std::min(length / step, most_steps)));
}

}  // namespace

void visit_places(const std::array<Vec3, 3>& corners, double step,
                  FunctionRef<void(const std::array<double, 3>& weight, double area)> visit) {
  int a = 0;  // the longest side begins there
  for (int k = 1; k < 3; ++k)
    if (distance(corners[k], corners[(k + 1) % 3]) > distance(corners[a], corners[(a + 1) % 3]))
      a = k;
  const int b = (a + 1) % 3, c = (a + 2) % 3;
  const Vec3 side = corners[b] - corners[a], other = corners[c] - corners[a];
  const double longest = length(side), double_area = length(cross(side, other));
  if (!(double_area > 0)) return;
  const double height = double_area / longest;
  const double foot = dot(other, side) / (longest * longest);
  const int columns = count_of(longest, step);
  for (int column = 0; column < columns; ++column) {
    const double along = (column + 0.5) / columns;
    const double top = along < foot ? along / foot : (1 - along) / (1 - foot);
    const int rows = count_of(top * height, step);
    for (int row = 0; row < rows; ++row) {
      const double up = top * ((row + 0.5) / rows);
      std::array<double, 3> weight{};
      weight[b] = along - up * foot;
      weight[c] = up;
      weight[a] = 1 - up - weight[b];
      visit(weight, top * double_area / (1.0 * columns * rows));
    }
  }
}

}  // namespace lpq
