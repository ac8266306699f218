// Transforms, lists of points and lengths in SVG attributes and styles (W3C, SVG 1.1, chapters 4.2,
// 7.6, 7.10 and 9.7.1; CSS Transforms 1 for what styles may say more).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/domain/curves.h"

namespace lpq {

/// What is wrong, and at which character of the attribute.
struct AttributeProblem {
  std::size_t at = 0;
  std::string message;
};
using MaybeProblem = std::optional<AttributeProblem>;

/// matrix, translate, scale, rotate, skewX and skewY, the last one applied first; also translateX,
/// scaleY and the like, and units, as styles have them; or "none".
MaybeProblem read_transform(std::string_view text, Affine& map);

/// "x,y x,y ...".
MaybeProblem read_points(std::string_view text, std::vector<Vec2>& points);

/// What lengths around an element refer to.
struct LengthUnits {
  double em = 16;            // the size of the font; browsers begin with this
  std::optional<Vec2> view;  // what percentages are parts of, if it is known
};
enum class LengthAxis : char { x, y, other };

/// A length in pixels: a number alone or with px, mm, cm, Q, in, pt, pc (96 pixels to the inch), em
/// or %.
MaybeProblem read_length(std::string_view text, double& value, const LengthUnits& units = {},
                         LengthAxis axis = LengthAxis::other);

}  // namespace lpq
