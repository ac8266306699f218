// See soup.h.
#include "surface/soup.h"

#include <cmath>
#include <optional>

#include "base/words.h"
#include "geometry/box.h"

namespace lpq {
namespace {

constexpr double smallest_surface = 1e-30,
                 largest_surface = 1e30;  // sixth powers of lengths are taken
constexpr double largest_coordinate = 1e100;

Problem check_corners(const SurfaceSoup& soup, SoupExtent& extent) {
  const auto count = static_cast<Index>(soup.points.size());
  extent.used.assign(soup.points.size(), 0);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (const Index v : soup.triangles[t]) {
      if (v < 0 || v >= count)
        return Error{ErrorCode::parse_error,
                     "Triangle " + std::to_string(t) + " has point " + std::to_string(v) +
                         ", but the points are 0 to " + std::to_string(count - 1) + ".",
                     {}};
      extent.used[v] = 1;
    }
  return std::nullopt;
}

/// One label for each triangle, or none at all: below the number of names where there are any, else
/// below that of triangles.
Problem check_labels(const char* what, const std::vector<Index>& labels, std::size_t triangles,
                     std::size_t names) {
  if (labels.empty()) return std::nullopt;
  if (labels.size() != triangles)
    return Error{ErrorCode::parse_error,
                 "There are " + std::to_string(labels.size()) + " " + what + " numbers for " +
                     std::to_string(triangles) + " triangles; give one for each, or none.",
                 {}};
  const auto most = static_cast<Index>(names > 0 ? names : triangles);
  for (std::size_t t = 0; t < labels.size(); ++t)
    if (labels[t] < 0 || labels[t] >= most)
      return Error{ErrorCode::parse_error,
                   "Triangle " + std::to_string(t) + " has " + what + " " +
                       std::to_string(labels[t]) + ", but " + what + " numbers go from 0 to " +
                       std::to_string(most - 1) + ": there are no more " +
                       (names > 0 ? what + std::string(" names") : "triangles") + ".",
                   {}};
  return std::nullopt;
}

Problem check_sizes(const SurfaceSoup& soup) {
  if (!soup.sizes.empty() && soup.sizes.size() != soup.points.size())
    return Error{ErrorCode::bad_size,
                 "There are " + std::to_string(soup.sizes.size()) + " sizes for " +
                     std::to_string(soup.points.size()) + " points; give one for each.",
                 {}};
  for (std::size_t p = 0; p < soup.sizes.size(); ++p)
    if (!(std::isfinite(soup.sizes[p]) && soup.sizes[p] >= 0))
      return Error{
          ErrorCode::bad_size,
          "The size at point " + std::to_string(p) + " is no length; give 0 where there is none.",
          {}};
  return std::nullopt;
}

Problem check_points(const std::vector<Vec3>& points, SoupExtent& extent) {
  Box3 box;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!extent.used[v]) {
      ++extent.unused;
      continue;
    }
    const Vec3 p = points[v];
    if (!is_finite(p))
      return Error{ErrorCode::non_finite,
                   "Point " + std::to_string(v) + " has a coordinate that is not finite.",
                   {}};
    extend(box, p);
  }
  for (const double x : {box.lo.x, box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z})
    if (std::fabs(x) > largest_coordinate)
      return Error{ErrorCode::too_large, "A coordinate is larger than 1e100.", {}};
  extent.diagonal = diagonal(box);
  if (box.lo == box.hi || (extent.diagonal > smallest_surface && extent.diagonal < largest_surface))
    return std::nullopt;
  return Error{ErrorCode::lost_precision,
               "The surface is " + short_number(extent.diagonal) +
                   " across; its numbers are beyond what double precision can calculate with. "
                   "Use another unit of length: between 1e-30 and 1e30.",
               {}};
}

}  // namespace

Result<SoupExtent> check_soup(const SurfaceSoup& soup) {
  const std::size_t triangles = soup.triangles.size();
  const std::size_t groups = soup.group_names.size(), bodies = soup.body_names.size();
  SoupExtent extent;
  if (triangles == 0) return Error{ErrorCode::empty, "The surface has no triangle.", {}};
  if (const Problem error = check_corners(soup, extent)) return *error;
  if (const Problem error = check_labels("group", soup.group, triangles, groups)) return *error;
  if (const Problem error = check_labels("body", soup.body, triangles, bodies)) return *error;
  if (const Problem error = check_sizes(soup)) return *error;
  if (const Problem error = check_points(soup.points, extent)) return *error;
  return extent;
}

}  // namespace lpq
