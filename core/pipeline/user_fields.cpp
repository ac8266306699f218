#include "pipeline/user_fields.h"

#include <algorithm>
#include <cmath>

#include "base/words.h"
#include "geometry/box.h"
#include "pipeline/resolution.h"

namespace lpq {
namespace {

// Sizes in the unit frame whose squares doubles hold. Any mesh as fine as the least is refused, and
// none is as coarse as the greatest.
constexpr double least_size = 1e-150, greatest_size = 1e150;

// The background is solved for at about 5 kB a point, and a mesh has some quads for each: beside
// what any domain may have, a detail asks for no more points than this share of the quads allowed.
constexpr double points_beside_quads = 1e5, points_per_quad = 0.02;

bool is_size(double h) { return std::isfinite(h) && h > 0; }

/// Sizes grow on their way in.
bool is_outside(const Box& box, const UnitFrame& frame, Vec2 position) {
  const Vec2 p = frame.to_frame(position);
  return !(p.x >= box.lo.x && p.x <= box.hi.x && p.y >= box.lo.y && p.y <= box.hi.y);
}

Problem judge_sizes(const std::vector<UserFields::SizeAt>& sizes, const Domain& domain) {
  const double least = domain.frame.length_to_world(least_resolved(domain));
  const Box box = box_of(domain.points);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const UserFields::SizeAt& size = sizes[i];
    if (!is_finite(size.position))
      return Error{ErrorCode::non_finite,
                   "The place of size " + std::to_string(i) + " is not a pair of finite numbers.",
                   {}};
    if (is_size(size.h) && (size.h >= least || is_outside(box, domain.frame, size.position)))
      continue;
    Error error = is_size(size.h) ? unresolved_size(size.h)
                                  : Error{ErrorCode::bad_size,
                                          "A mesh size given at a point must be a positive number.",
                                          {}};
    error.where.set_point(size.position.x, size.position.y);
    return error;
  }
  return {};
}

Problem judge_guide(const UserFields::Guide& guide, Index number, const UnitFrame& frame) {
  for (std::size_t i = 0; i < guide.size(); ++i) {
    const bool finite = is_finite(guide[i]);
    if (finite && is_within_reach(guide[i], frame)) continue;
    Error error{finite ? ErrorCode::bad_option : ErrorCode::non_finite,
                "Point " + std::to_string(i) + " of guide " + std::to_string(number) +
                    (finite ? " is too far from the domain. Bring it nearer." : " is not finite."),
                {}};
    error.where.guide = number;
    error.where.edge = static_cast<Index>(i);
    return error;
  }
  return {};
}

// About one point for each square of that side inside and on the walls.
double background_points(const Domain& domain, double detail) {
  double walls = 0;
  for (const Segment& s : domain.segments)
    walls += distance(domain.points[s.a], domain.points[s.b]);
  return domain.area / detail / detail + walls / detail;
}

Problem judge_detail(const UserFields& user, const Domain& domain, double max_elements) {
  if (!(user.detail >= 0 && std::isfinite(user.detail)))
    return Error{
        ErrorCode::bad_option,
        "The detail of a size function is a positive length, or 0 for 1/48 of the domain's "
        "extent, not " +
            short_number(user.detail) + ".",
        {}};
  if (!user.size || user.detail == 0) return {};
  const double points = background_points(domain, domain.frame.length_to_frame(user.detail));
  const double most = points_beside_quads + points_per_quad * max_elements;
  if (points <= most) return {};
  return Error{ErrorCode::too_many_elements,
               "A size function looked at with a detail of " + short_number(user.detail) +
                   " needs a background of about " + short_number(std::min(points, 1e300)) +
                   " points, more than the limit of " + short_number(most) +
                   ". Use a larger detail: the length below which sizes hardly vary.",
               {}};
}

}  // namespace

bool is_within_reach(Vec2 point, const UnitFrame& frame) {
  return std::isfinite(squared_length(frame.to_frame(point)));
}

bool has_function(const UserFields& user) { return user.size || user.angle || user.stretch; }

Problem judge_user_fields(const UserFields& user, const Domain& domain, double max_elements) {
  if (Problem problem = judge_sizes(user.sizes, domain)) return problem;
  for (std::size_t g = 0; g < user.guides.size(); ++g)
    if (Problem problem = judge_guide(user.guides[g], static_cast<Index>(g), domain.frame))
      return problem;
  return judge_detail(user, domain, max_elements);
}

double size_in_frame(double size, const UnitFrame& frame) {
  const double scaled = frame.length_to_frame(size);
  return is_size(size) ? std::clamp(scaled, least_size, greatest_size) : scaled;
}

std::vector<SizeSample> samples_in_frame(const UserFields& user, const UnitFrame& frame) {
  std::vector<SizeSample> samples;
  for (const UserFields::SizeAt& s : user.sizes)
    if (is_within_reach(s.position, frame))
      samples.push_back({frame.to_frame(s.position), size_in_frame(s.h, frame)});
  return samples;
}

}  // namespace lpq
