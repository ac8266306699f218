// See triangle_places.h.
#include "shell/triangle_places.h"

#include <algorithm>
#include <cmath>

namespace lpq {
namespace {

constexpr double most_steps = 1000;  // along a side
// Places for each square of the step: many needles side by side need no more of them together than
// a face that is as wide.
constexpr double most_for_area = 4;
constexpr double golden = 0.6180339887498949;  // steps of it spread evenly over [0, 1)

int count_of(double length, double step) {
  return std::max(1, static_cast<int>(std::min(length / step, most_steps)));
}

}  // namespace

void visit_places(const std::array<Vec3, 3>& corners, double step, Index number,
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
  const double most = most_for_area * 0.5 * double_area / step;
  const int columns = count_of(std::min(longest, most), step);
  const double turn = golden * number;
  const double offset = most < longest ? turn - std::floor(turn) : 0.5;
  for (int column = 0; column < columns; ++column) {
    const double along = (column + offset) / columns;
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
