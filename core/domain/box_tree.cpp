#include "domain/box_tree.h"

#include <algorithm>
#include <compare>
#include <cstdint>

#include "base/sort_numbers.h"

namespace lpq {
namespace {

Box united(const Box& a, const Box& b) {
  return {{std::min(a.lo.x, b.lo.x), std::min(a.lo.y, b.lo.y)},
          {std::max(a.hi.x, b.hi.x), std::max(a.hi.y, b.hi.y)}};
}

// The low 32 bits with a zero between each two.
std::uint64_t spread(std::uint64_t v) {
  v = (v | (v << 16)) & 0x0000FFFF0000FFFFu;
  v = (v | (v << 8)) & 0x00FF00FF00FF00FFu;
  v = (v | (v << 4)) & 0x0F0F0F0F0F0F0F0Fu;
  v = (v | (v << 2)) & 0x3333333333333333u;
  return (v | (v << 1)) & 0x5555555555555555u;
}

std::uint64_t z_order(Vec2 p, const Box& all, double cells_per_length) {
  constexpr double last_cell = 4294967295.0;
  const auto cell = [&](double offset) {
    return static_cast<std::uint64_t>(std::clamp(offset * cells_per_length, 0.0, last_cell));
  };
  return spread(cell(p.x - all.lo.x)) | (spread(cell(p.y - all.lo.y)) << 1);
}

struct Key {
  Index group;
  std::uint64_t place;
  Index item;
  auto operator<=>(const Key&) const = default;
};

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes, std::span<const Index> group) {
  if (boxes.empty()) return;
  const Index n = static_cast<Index>(boxes.size());
  Box all = boxes[0];
  for (const Box& box : boxes) all = united(all, box);
  const double extent = longer_side(all);
  const double cells_per_length = extent > 0 ? 4294967295.0 / extent : 0.0;
  std::vector<Key> keys(n);
  for (Index i = 0; i < n; ++i)
    keys[i] = {group.empty() ? none : group[i],
               z_order(midpoint(boxes[i].lo, boxes[i].hi), all, cells_per_length), i};
  sort_values(keys);

  items_.resize(n);
  boxes_.reserve(n + n / 2 + 16);
  level_begin_ = {0, n};
  for (Index i = 0; i < n; ++i) {
    items_[i] = keys[i].item;
    boxes_.push_back(boxes[items_[i]]);
  }
  for (Index begin = 0, end = n; end - begin > 1;) {
    for (Index first = begin; first < end; first += fan) {
      Box box = boxes_[first];
      for (Index child = first + 1; child < std::min(first + fan, end); ++child)
        box = united(box, boxes_[child]);
      boxes_.push_back(box);
    }
    begin = end;
    end = static_cast<Index>(boxes_.size());
    level_begin_.push_back(end);
  }
}

}  // namespace lpq
