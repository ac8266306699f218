// Faces that run round a hole and are narrow all the way, as the ends of thin walls are.
#pragma once

#include <optional>
#include <span>

#include "surface/face_borders.h"

namespace lpq {

/// A border outside and one inside that turn as often, so that what runs one way outside has
/// something beside it that runs back inside.
struct NarrowBand {
  const FaceBorder *outer = nullptr, *inner = nullptr;
  Index rows = 0;   // of quads that fit between, rounded: 0 or 1
  Index shift = 0;  // what runs in direction k outside, in 0 .. 3, runs in k + shift inside
};

/// Of all borders of one face and its area, in squares of their unit of length. None if they are
/// not an outline and one hole that turn by four right angles each, or further apart than 1.5 mesh
/// sizes (mean), or if the outline is more than twice as long as the hole's border. Cost O(sides).
std::optional<NarrowBand> narrow_band(std::span<const FaceBorder* const> borders, double area);

}  // namespace lpq
