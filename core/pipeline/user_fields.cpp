#include "pipeline/user_fields.h"

#include <algorithm>
#include <cmath>

namespace lpq {
namespace {

// Sizes in the unit frame whose squares doubles hold. Any mesh as fine as the least is refused, and
// none is as coarse as the greatest.
constexpr double least_size = 1e-150, greatest_size = 1e150;

bool is_size(double h) { return std::isfinite(h) && h > 0; }

Problem judge_sizes(const std::vector<UserFields::SizeAt>& sizes) {
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const UserFields::SizeAt& size = sizes[i];
    if (!is_finite(size.position))
      return Error{ErrorCode::non_finite,
                   "The place of size " + std::to_string(i) + " is not a pair of finite numbers.",
                   {}};
    if (is_size(size.h)) continue;
    Error error{ErrorCode::bad_size, "A mesh size given at a point must be a positive number.", {}};
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

}  // namespace

bool is_within_reach(Vec2 point, const UnitFrame& frame) {
  return std::isfinite(squared_length(frame.to_frame(point)));
}

Problem judge_user_fields(const UserFields& user, const UnitFrame& frame) {
  if (Problem problem = judge_sizes(user.sizes)) return problem;
  for (std::size_t g = 0; g < user.guides.size(); ++g)
    if (Problem problem = judge_guide(user.guides[g], static_cast<Index>(g), frame)) return problem;
  return {};
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
