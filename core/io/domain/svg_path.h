// The small languages inside SVG attributes: path data, transforms, lists of numbers, lengths
// (W3C, SVG 1.1 chapters 7.6, 8.3 and 9.7.1; SVG 2 chapter 9.5 for the error-free part).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/domain/curves.h"

namespace lpq {

struct Subpath {
  CurvePath curve;
  bool closed = false;
};

/// What is wrong, and at which character of the attribute.
struct AttributeProblem {
  std::size_t at = 0;
  std::string message;
};
using MaybeProblem = std::optional<AttributeProblem>;

/// All commands of path data, in the path's own coordinates. Subpaths without an edge are left out.
MaybeProblem read_path_data(std::string_view text, std::vector<Subpath>& subpaths);

/// matrix, translate, scale, rotate, skewX and skewY, the last one applied first.
MaybeProblem read_transform(std::string_view text, Affine& map);

/// "x,y x,y ...".
MaybeProblem read_points(std::string_view text, std::vector<Vec2>& points);

/// A length in pixels: a number alone or with px, mm, cm, in, pt or pc (96 pixels to the inch).
MaybeProblem read_length(std::string_view text, double& value);

/// An elliptical arc from the current point, given by its end (SVG 1.1, F.6.5).
void append_elliptical_arc(CurvePath& path, Vec2 radii, double rotation_degrees, bool large,
                           bool sweep, Vec2 end);

}  // namespace lpq
