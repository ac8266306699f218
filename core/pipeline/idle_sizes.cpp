#include "pipeline/idle_sizes.h"

#include <algorithm>

#include "domain/outline.h"
#include "field/size_field.h"
#include "pipeline/user_fields.h"

namespace lpq {
namespace {

/// What is asked for at the triangle without sizes at points: the constant size, or the spacing of
/// the walls there.
double usual_size(const BoundaryMesh& boundary, const FieldOptions& options, const Fields& fields,
                  Index t) {
  if (options.size > 0) return options.size;
  double size = 0;
  for (const Index v : fields.background.triangles[t])
    if (v < static_cast<Index>(boundary.spacing.size())) size = std::max(size, boundary.spacing[v]);
  return size;
}

Warning warning_of(std::size_t idle, std::size_t given, Vec2 first) {
  const bool one = idle == 1;
  Warning warning{ErrorCode::ignored,
                  std::to_string(idle) + " of " + std::to_string(given) + " sizes at points " +
                      (one ? "lies" : "lie") + " outside the domain, too far away to matter in it" +
                      (one ? ", at " : ". The first is at ") + point_text(first) +
                      ". Check unit and origin, or leave " + (one ? "it" : "them") + " out.",
                  {}};
  warning.where.set_point(first.x, first.y);
  return warning;
}

}  // namespace

std::vector<Warning> idle_sizes(const UserFields& user, const UnitFrame& frame,
                                const BoundaryMesh& boundary, const FieldOptions& options,
                                const Fields& fields) {
  if (user.size || user.sizes.empty()) return {};
  const std::vector<SizeCone> cones = size_cones_of(options);
  std::vector<Vec2> idle;
  Index hint = none;
  std::size_t next = 0;  // of the cones, which are of those within reach
  for (const UserFields::SizeAt& s : user.sizes) {
    if (!is_within_reach(s.position, frame)) {
      idle.push_back(s.position);
      continue;
    }
    const SizeCone& cone = cones[next++];
    if (fields.locator.find(cone.tip, hint) != none) continue;
    const Index t = fields.locator.find_nearest(cone.tip, hint);
    const double away = distance_to_triangle(fields.background, t, cone.tip);
    // A point of the wall is outside by rounding.
    if (away > 0 && cone.at(away) >= usual_size(boundary, options, fields, t))
      idle.push_back(s.position);
  }
  if (idle.empty()) return {};
  return {warning_of(idle.size(), user.sizes.size(), idle.front())};
}

}  // namespace lpq
