// See repair_warnings.h.
#include "surface/repair_warnings.h"

#include <string>

#include "base/words.h"

namespace lpq {

std::vector<Warning> repair_warnings(const RepairReport& report) {
  std::vector<Warning> warnings;
  // "1 triangle was turned.", "3 triangles were turned."
  const auto warn = [&](ErrorCode code, Index count, const std::string& one,
                        const std::string& many, const std::string& rest) {
    if (count == 0) return;
    const std::string what = count == 1 ? " " + one + " was " : " " + many + " were ";
    warnings.push_back({code, std::to_string(count) + what + rest, {}});
  };
  if (report.rounding > 0)
    warnings.push_back({ErrorCode::adapted,
                        "The triangles hardly hang together: points within " +
                            short_number(report.rounding) + " of each other were made one.",
                        {}});
  warn(ErrorCode::duplicate_point, report.slit_points, "point", "points",
       "made one with another across a slit without width.");
  warn(ErrorCode::touching, report.hanging_points, "point", "points",
       "made a corner of the triangles on whose edges they lay.");
  warn(ErrorCode::duplicate_point, report.collapsed_triangles, "triangle", "triangles",
       "left out: two corners are the same point.");
  warn(ErrorCode::overlapping_edges, report.duplicate_triangles, "triangle", "triangles",
       "left out: another one has the same corners.");
  warn(ErrorCode::zero_area, report.flat_triangles, "triangle without height",
       "triangles without height", "taken away.");
  warn(ErrorCode::zero_area, report.flat_left, "triangle without height",
       "triangles without height", "left as found.");
  warn(ErrorCode::adapted, report.turned_triangles, "triangle", "triangles",
       "turned over, so that neighbours face the same way.");
  warn(ErrorCode::touching, report.nonmanifold_edges, "edge", "edges",
       "kept as a line where three or more triangles meet.");
  warn(ErrorCode::touching, report.conflict_edges, "edge", "edges",
       "cut open: the surface has only one side there.");
  warn(ErrorCode::touching, report.nonmanifold_vertices, "point", "points",
       "found where parts of the surface meet in that point only.");
  if (report.gap.points > 0)
    warnings.push_back({ErrorCode::touching,
                        std::to_string(report.gap.points) + " points of borders lie within " +
                            short_number(report.gap.width) + " of other borders, the first at " +
                            place_in_space(report.gap.at.x, report.gap.at.y, report.gap.at.z) +
                            ". If the surface goes on there, close it with weld " +
                            short_number(report.closing_weld) + ".",
                        {}});
  return warnings;
}

}  // namespace lpq
