#include "surface/charts/layout.h"

#include <algorithm>
#include <cmath>

#include "base/sort_numbers.h"
#include "geometry/box.h"

namespace lpq {
namespace {

constexpr double gap_share = 1.0 / 400;  // of the side of a square with the boxes' area
constexpr double row_share = 1.05;       // of the same, for what rows leave free

struct ChartBox {
  Vec2 low, size;
};

}  // namespace

AtlasLayout lay_out(std::span<const Chart> charts) {
  std::vector<ChartBox> boxes;
  double area = 0, width = 0;
  for (const Chart& chart : charts) {
    const Box box = box_of(chart.plane.points);
    boxes.push_back({box.lo, box.hi - box.lo});
    area += boxes.back().size.x * boxes.back().size.y;
    width = std::max(width, boxes.back().size.x);
  }
  const double gap = gap_share * std::sqrt(area);
  width = std::max(width, row_share * std::sqrt(area)) + 2 * gap;
  const std::vector<Index> order = sorted_numbers(charts.size(), [&](Index a, Index b) {
    const double height_a = boxes[a].size.y, height_b = boxes[b].size.y;
    return height_a != height_b ? height_a > height_b : a < b;
  });
  AtlasLayout layout{std::vector<Vec2>(charts.size()), width};
  Vec2 at{gap, gap};
  double row_height = 0;
  for (const Index c : order) {
    if (at.x > gap && at.x + boxes[c].size.x + gap > width) {
      at = {gap, at.y + row_height + gap};
      row_height = 0;
    }
    layout.shift[c] = at - boxes[c].low;
    row_height = std::max(row_height, boxes[c].size.y);
    at.x += boxes[c].size.x + gap;
  }
  layout.side = std::max(width, at.y + row_height + gap);
  if (!(layout.side > 0)) layout.side = 1;  // nothing has an area
  return layout;
}

}  // namespace lpq
