// See narrow_band.h.
#include "surface/narrow_band.h"

#include <cmath>

namespace lpq {
namespace {

constexpr double narrow = 1.5;  // mesh sizes; wider ones have room for irregular vertices
constexpr double longer = 2;    // the outer border, at most: else there is room beside the hole

/// Mean width in mesh sizes: the area over the length of the line in its middle.
double width(const FaceBorder& outer, const FaceBorder& inner, double area) {
  double sizes = 0;
  for (const FaceBorder* border : {&outer, &inner})
    for (const BorderSide& side : border->sides) sizes += side.whole();
  const double length = outer.length + inner.length;
  return length > 0 ? 2 * area * sizes / (length * length) : 0;
}

/// By how many directions the inner border must be turned to run against the outer one.
Index shift_between(const FaceBorder& outer, const FaceBorder& inner) {
  Index best = 0;
  double least = 0;
  for (Index shift = 0; shift < right_angles_round; ++shift) {
    double along = 0;
    for (Index k = 0; k < right_angles_round; ++k)
      along += dot(outer.run[k], inner.run[direction_after(k + shift)]);
    if (!(along < least)) continue;
    least = along;
    best = shift;
  }
  return best;
}

}  // namespace

std::optional<NarrowBand> narrow_band(std::span<const FaceBorder* const> borders, double area) {
  if (borders.size() != 2) return std::nullopt;
  const bool in_order = borders[0]->turns > 0;
  const FaceBorder &outer = *borders[in_order ? 0 : 1], &inner = *borders[in_order ? 1 : 0];
  if (outer.turns != right_angles_round || inner.turns != -right_angles_round) return std::nullopt;
  if (outer.length > longer * inner.length) return std::nullopt;
  const double across = width(outer, inner, area);
  if (!(across < narrow)) return std::nullopt;
  return NarrowBand{.outer = &outer,
                    .inner = &inner,
                    .rows = static_cast<Index>(std::floor(across + 0.5)),
                    .shift = shift_between(outer, inner)};
}

}  // namespace lpq
