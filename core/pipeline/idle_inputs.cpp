#include "pipeline/idle_inputs.h"

#include <algorithm>

#include "domain/outline.h"
#include "field/guides.h"
#include "field/size_field.h"
#include "pipeline/user_fields.h"

namespace lpq {
namespace {

constexpr double rounding = 1e-12;  // of the unit frame

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

/// How far outside the domain, and in `hint` the nearest triangle. 0 for points of the wall, too,
/// which are outside by rounding.
double distance_outside(const Fields& fields, Vec2 p, Index& hint) {
  if (fields.locator.find(p, hint) != none) return 0;
  const Index nearest = fields.locator.find_nearest(p, hint);
  const double distance = distance_to_triangle(fields.background, nearest, p);
  return distance > rounding ? distance : 0;
}

/// "2 of 3 guides lie outside the domain."
Warning warning_of(std::size_t idle, std::size_t given, const char* what, const char* why,
                   Vec2 first) {
  const bool one = idle == 1;
  Warning warning{ErrorCode::ignored,
                  std::to_string(idle) + " of " + std::to_string(given) + " " + what +
                      (one ? " lies" : " lie") + " outside the domain" + why +
                      (one ? ", at " : ". The first is at ") + point_text(first) +
                      ". Check unit and origin, or leave " + (one ? "it" : "them") + " out.",
                  {}};
  warning.where.set_point(first.x, first.y);
  return warning;
}

/// Where they are.
std::vector<Vec2> sizes_without_effect(const UserFields& user, const UnitFrame& frame,
                                       const BoundaryMesh& boundary, const FieldOptions& options,
                                       const Fields& fields) {
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
    const double away = distance_outside(fields, cone.tip, hint);
    if (away > 0 && cone.at(away) >= usual_size(boundary, options, fields, hint))
      idle.push_back(s.position);
  }
  return idle;
}

std::vector<Vec2> seeds_outside(const UserFields& user, const UnitFrame& frame,
                                const Fields& fields) {
  std::vector<Vec2> outside;
  Index hint = none;
  for (const Vec2 seed : user.seeds)
    if (!is_within_reach(seed, frame) || distance_outside(fields, frame.to_frame(seed), hint) > 0)
      outside.push_back(seed);
  return outside;
}

}  // namespace

IdleInputs idle_inputs(const UserFields& user, const UnitFrame& frame, const BoundaryMesh& boundary,
                       const FieldOptions& options, const Fields& fields) {
  IdleInputs idle;
  std::vector<Vec2> sizes;
  std::vector<Index> guides;
  if (!user.size) sizes = sizes_without_effect(user, frame, boundary, options, fields);
  if (!user.angle) guides = guides_outside(options.guides, fields.background, fields.h);
  if (!sizes.empty())
    idle.warnings.push_back(warning_of(sizes.size(), user.sizes.size(), "sizes at points",
                                       ", too far away to matter in it", sizes.front()));
  if (!guides.empty()) {
    const Index first = guides.front();
    idle.warnings.push_back(
        warning_of(guides.size(), user.guides.size(), "guides", "", user.guides[first].front()));
    idle.warnings.back().where.guide = first;
  }
  if (const std::vector<Vec2> seeds = seeds_outside(user, frame, fields); !seeds.empty())
    idle.warnings.push_back(
        warning_of(seeds.size(), user.seeds.size(), "start points", "", seeds.front()));
  idle.decide_on_fields =
      has_function(user) || sizes.size() < user.sizes.size() || guides.size() < user.guides.size();
  return idle;
}

}  // namespace lpq
