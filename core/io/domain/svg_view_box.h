// viewBox and preserveAspectRatio (W3C, SVG 1.1, chapters 7.7 and 7.8).
#pragma once

#include <string_view>

#include "io/domain/svg_path.h"

namespace lpq {

/// "x y width height".
MaybeProblem read_view_box(std::string_view text, Vec2& corner, Vec2& size);

/// Maps the view box "x y width height" into (0, 0) .. size, before `map`. `aspect` is the value of
/// preserveAspectRatio: "none", "xMinYMax slice", ...; "" is "xMidYMid meet".
MaybeProblem fit_view_box(std::string_view view_box, std::string_view aspect, Vec2 size,
                          Affine& map);

}  // namespace lpq
