// Points filed by position and by their own length scale, to ask "is anything near p?" where sizes
// vary over many orders of magnitude. A point of scale h lies in a square cell whose side is the
// power of two above h, so cells scale with the domain without a changed bit. Cells of one level
// come in blocks of 8 x 8, found by hashing; nothing ever iterates over the hash table, so the
// answers depend on the order of insertion only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/index.h"
#include "geometry/vec.h"

namespace lpq {

class PointGrid {
 public:
  PointGrid() : table_(64) {}

  void insert(Vec2 p, double h, Index id) {
    const int level = level_of(h);
    const double cell = std::ldexp(1.0, level);
    const std::int64_t ix = cell_of(p.x, cell), iy = cell_of(p.y, cell);
    if (2 * (block_count() + 1) > static_cast<Index>(table_.size())) grow();
    Slot& slot = slot_of(level, ix >> 3, iy >> 3);
    if (slot.block == none) {
      slot = {ix >> 3, iy >> 3, level, block_count()};
      heads_.resize(heads_.size() + 64, none);
      first_level_ = std::min(first_level_, level);
      last_level_ = std::max(last_level_, level);
    }
    Index& head = heads_[64 * slot.block + within(ix, iy)];
    entries_.push_back({p, id, head});
    head = static_cast<Index>(entries_.size()) - 1;
  }

  /// Whether visit(id, point) is true for a point within `radius` of p in x and in y. Points whose
  /// own scale differs from h by more than a factor of about four are not seen.
  template <class Visit>
  bool any_near(Vec2 p, double h, double radius, Visit visit) const {
    const auto is_met = [&](const Entry& entry) {
      return std::abs(entry.point.x - p.x) <= radius && std::abs(entry.point.y - p.y) <= radius &&
             visit(entry.id, entry.point);
    };
    const int centre = level_of(h);
    const int low = std::max(centre - 2, first_level_), high = std::min(centre + 2, last_level_);
    for (int level = low; level <= high; ++level) {
      const double cell = std::ldexp(1.0, level);
      const Cells cells{cell_of(p.x - radius, cell), cell_of(p.x + radius, cell),
                        cell_of(p.y - radius, cell), cell_of(p.y + radius, cell)};
      for (std::int64_t by = cells.y0 >> 3; by <= cells.y1 >> 3; ++by)
        for (std::int64_t bx = cells.x0 >> 3; bx <= cells.x1 >> 3; ++bx) {
          const Index block = slot_of(level, bx, by).block;
          if (block != none && any_in_block(block, part_of_block(cells, bx, by), is_met))
            return true;
        }
    }
    return false;
  }

 private:
  struct Slot {
    std::int64_t bx = 0, by = 0;
    int level = 0;
    Index block = none;
  };
  struct Entry {
    Vec2 point;
    Index id = none, next = none;
  };

  struct Cells {
    std::int64_t x0, x1, y0, y1;  // first and last
  };

  static Cells part_of_block(const Cells& cells, std::int64_t bx, std::int64_t by) {
    return {std::max(cells.x0, 8 * bx), std::min(cells.x1, 8 * bx + 7), std::max(cells.y0, 8 * by),
            std::min(cells.y1, 8 * by + 7)};
  }
  template <class Test>
  bool any_in_block(Index block, const Cells& cells, Test test) const {
    for (std::int64_t iy = cells.y0; iy <= cells.y1; ++iy)
      for (std::int64_t ix = cells.x0; ix <= cells.x1; ++ix)
        for (Index e = heads_[64 * block + within(ix, iy)]; e != none; e = entries_[e].next)
          if (test(entries_[e])) return true;
    return false;
  }

  static int level_of(double h) {
    int exponent = 0;
    std::frexp(h, &exponent);
    return exponent;
  }
  static std::int64_t cell_of(double x, double cell) {
    return static_cast<std::int64_t>(std::floor(x / cell));
  }
  static Index within(std::int64_t ix, std::int64_t iy) {
    return static_cast<Index>((ix & 7) + 8 * (iy & 7));
  }
  Index block_count() const { return static_cast<Index>(heads_.size() / 64); }

  std::size_t start_of(int level, std::int64_t bx, std::int64_t by) const {
    std::uint64_t key = static_cast<std::uint64_t>(bx) * 0x9E3779B97F4A7C15u +
                        static_cast<std::uint64_t>(by) * 0xC2B2AE3D27D4EB4Fu +
                        static_cast<std::uint64_t>(level + 4096) * 0x165667B19E3779F9u;
    key = (key ^ (key >> 29)) * 0xBF58476D1CE4E5B9u;
    return static_cast<std::size_t>((key ^ (key >> 32)) & (table_.size() - 1));
  }
  // The slot of a block, or the empty slot where it belongs.
  const Slot& slot_of(int level, std::int64_t bx, std::int64_t by) const {
    std::size_t i = start_of(level, bx, by);
    while (table_[i].block != none &&
           !(table_[i].bx == bx && table_[i].by == by && table_[i].level == level))
      i = (i + 1) & (table_.size() - 1);
    return table_[i];
  }
  Slot& slot_of(int level, std::int64_t bx, std::int64_t by) {
    return const_cast<Slot&>(static_cast<const PointGrid*>(this)->slot_of(level, bx, by));
  }
  void grow() {
    std::vector<Slot> old(2 * table_.size());
    old.swap(table_);
    for (const Slot& slot : old)
      if (slot.block != none) slot_of(slot.level, slot.bx, slot.by) = slot;
  }

  std::vector<Slot> table_;     // open addressing, a power of two, at most half full
  std::vector<Index> heads_;    // #blocks x 64  newest entry of each cell
  std::vector<Entry> entries_;  // #points
  int first_level_ = 4096, last_level_ = -4096;
};

}  // namespace lpq
