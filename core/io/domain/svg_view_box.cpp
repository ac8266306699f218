// See svg_view_box.h.
#include "io/domain/svg_view_box.h"

#include <algorithm>

namespace lpq {
namespace {

bool has(std::string_view text, std::string_view word) {
  return text.find(word) != std::string_view::npos;
}

/// How much of the room to spare lies before the view box.
double share(std::string_view aspect, std::string_view least, std::string_view most) {
  if (has(aspect, least)) return 0;
  return has(aspect, most) ? 1 : 0.5;
}

}  // namespace

MaybeProblem read_view_box(std::string_view text, Vec2& corner, Vec2& size) {
  std::vector<Vec2> corner_and_size;
  if (auto problem = read_points(text, corner_and_size)) return problem;
  if (corner_and_size.size() != 2) return AttributeProblem{0, "four numbers are expected"};
  corner = corner_and_size[0];
  size = corner_and_size[1];
  return std::nullopt;
}

MaybeProblem fit_view_box(std::string_view view_box, std::string_view aspect, Vec2 size,
                          Affine& map) {
  Vec2 corner, box;
  if (auto problem = read_view_box(view_box, corner, box)) return problem;
  if (!(box.x > 0 && box.y > 0 && size.x > 0 && size.y > 0))
    return AttributeProblem{0, "a width and a height above 0 are expected, of <use> and <svg> too"};
  Vec2 scale{size.x / box.x, size.y / box.y};
  if (!has(aspect, "none")) {
    const double both =
        has(aspect, "slice") ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
    scale = {both, both};
  }
  const Vec2 before{share(aspect, "xMin", "xMax") * (size.x - scale.x * box.x),
                    share(aspect, "YMin", "YMax") * (size.y - scale.y * box.y)};
  map =
      map *
      Affine{scale.x, 0, 0, scale.y, before.x - scale.x * corner.x, before.y - scale.y * corner.y};
  return std::nullopt;
}

}  // namespace lpq
