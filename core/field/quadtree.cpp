#include "field/quadtree.h"

namespace lpq {
namespace {

// Cell coordinates stay exact in a double and in 64 bits; 2^-44 of the domain is far below any
// wall that survives the door.
constexpr std::int32_t deepest_level = 44;

}  // namespace

Quadtree::Quadtree(Vec2 origin, double side) : origin_(origin), side_(side), cells_(1) {
  for (std::int32_t level = 0; level <= deepest_level; ++level, side *= 0.5)
    side_of_level_.push_back(side);
}

Quadtree::Box Quadtree::box(Index cell) const {
  const Cell& c = cells_[cell];
  const double side = side_of_level_[c.level];
  return {
      {origin_.x + static_cast<double>(c.ix) * side, origin_.y + static_cast<double>(c.iy) * side},
      side};
}

bool Quadtree::split(Index leaf) {
  const Cell parent = cells_[leaf];
  if (parent.level == deepest_level) return false;
  cells_[leaf].children = cell_count();
  for (Index quarter = 0; quarter < 4; ++quarter) {
    Cell cell;
    cell.ix = 2 * parent.ix + (quarter & 1);
    cell.iy = 2 * parent.iy + (quarter >> 1);
    cell.level = parent.level + 1;
    cells_.push_back(cell);
  }
  return true;
}

Index Quadtree::leaf_at(Vec2 p) const {
  if (!(p.x >= origin_.x && p.y >= origin_.y)) return none;
  if (!(p.x < origin_.x + side_ && p.y < origin_.y + side_)) return none;
  Index cell = 0;
  while (!is_leaf(cell)) {
    const Vec2 centre = box(cell).centre();
    cell = child(cell, (p.x >= centre.x ? 1 : 0) + (p.y >= centre.y ? 2 : 0));
  }
  return cell;
}

void Quadtree::refine_at(Vec2 p, double side) {
  Index leaf = leaf_at(p);
  while (leaf != none && side_of_level_[cells_[leaf].level] > side && split(leaf)) {
    const Vec2 centre = box(leaf).centre();
    leaf = child(leaf, (p.x >= centre.x ? 1 : 0) + (p.y >= centre.y ? 2 : 0));
  }
}

// The leaf at or above the given cell position, or that position's cell if it is split further.
Index Quadtree::leaf_covering(std::int64_t ix, std::int64_t iy, std::int32_t level) const {
  const std::int64_t count = std::int64_t{1} << level;
  if (ix < 0 || iy < 0 || ix >= count || iy >= count) return none;
  Index cell = 0;
  for (std::int32_t below = level - 1; below >= 0 && !is_leaf(cell); --below)
    cell = child(cell, static_cast<Index>(((ix >> below) & 1) + 2 * ((iy >> below) & 1)));
  return cell;
}

void Quadtree::balance() {
  std::vector<Index> queue;
  for (Index cell = 0; cell < cell_count(); ++cell)
    if (is_leaf(cell)) queue.push_back(cell);
  constexpr std::int64_t sides[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  while (!queue.empty()) {
    const Index leaf = queue.back();
    queue.pop_back();
    if (!is_leaf(leaf)) continue;
    const Cell cell = cells_[leaf];
    for (const auto& side : sides) {
      while (true) {
        const Index other = leaf_covering(cell.ix + side[0], cell.iy + side[1], cell.level);
        if (other == none || !is_leaf(other) || cells_[other].level >= cell.level - 1) break;
        split(other);
        for (Index quarter = 0; quarter < 4; ++quarter) queue.push_back(child(other, quarter));
      }
    }
  }
}

}  // namespace lpq
