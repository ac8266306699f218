// Path data of SVG (W3C, SVG 1.1, chapter 8.3; SVG 2, chapter 9.5 for the error-free part).
#pragma once

#include <string_view>
#include <vector>

#include "io/domain/curves.h"
#include "io/domain/svg_values.h"

namespace lpq {

struct Subpath {
  CurvePath curve;
  bool closed = false;
};

/// All commands of path data, in the path's own coordinates; "none" has none. Subpaths without an
/// edge are left out.
MaybeProblem read_path_data(std::string_view text, std::vector<Subpath>& subpaths);

/// An elliptical arc from the current point, given by its end (SVG 1.1, F.6.5).
void append_elliptical_arc(CurvePath& path, Vec2 radii, double rotation_degrees, bool large,
                           bool sweep, Vec2 end);

}  // namespace lpq
