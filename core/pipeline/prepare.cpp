#include "pipeline/prepare.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/words.h"
#include "field/make_fields.h"
#include "geometry/box.h"
#include "pipeline/fine_outline.h"
#include "pipeline/grade.h"
#include "pipeline/idle_inputs.h"
#include "pipeline/resolution.h"
#include "pipeline/user_fields.h"

namespace lpq {
namespace {

// A domain that comes without any size gets about this many quads.
constexpr double default_quads = 1000;
constexpr double least_growth = 0.01;

Error size_error(std::string message) { return {ErrorCode::bad_size, std::move(message), {}}; }

double diagonal(const Domain& domain) { return diagonal(box_of(domain.points)); }

// The constant target in the unit frame; 0 means: follow the kept boundary's spacing. Of a number
// of quads it is where the search for their size begins.
double target_size(const Domain& domain, const Options& options) {
  if (options.size > 0) return domain.frame.length_to_frame(options.size);
  if (options.quads > 0) return std::sqrt(domain.area / options.quads);
  if (options.keep_boundary) return 0;
  if (domain.h > 0) return domain.h;
  return std::sqrt(domain.area / default_quads);
}

/// Squares of lengths, of which the final check of a mesh is made, must be within what doubles
/// hold.
Problem judge_scale(const Domain& domain, double size) {
  constexpr double least = 1e-153, greatest = 1e153;
  const double across = domain.frame.length_to_world(diagonal(domain));
  const double finest = size > 0 ? domain.frame.length_to_world(size) : across;
  if (finest >= least && across <= greatest) return std::nullopt;
  return Error{
      ErrorCode::lost_precision,
      "The domain is " + short_number(across) +
          " across: doubles cannot hold areas of that scale. Scale it, so that lengths are "
          "nearer to 1.",
      {}};
}

Result<double> judge_size(const Domain& domain, const Options& options) {
  const double size = target_size(domain, options);
  if (size > diagonal(domain))
    return size_error("The mesh size " + short_number(domain.frame.length_to_world(size)) +
                      " is larger than the whole domain (diagonal " +
                      short_number(domain.frame.length_to_world(diagonal(domain))) +
                      "). Check the unit of length.");
  const double estimate = size > 0 ? domain.area / (size * size) : 0;
  if (estimate > options.max_elements) return too_many_elements(estimate, options.max_elements);
  if (const auto beyond = judge_scale(domain, size)) return *beyond;
  if (size > 0 && size < least_resolved(domain))
    return unresolved_size(domain.frame.length_to_world(size));
  return size;
}

Problem judge_seeds(const std::vector<Vec2>& seeds) {
  for (std::size_t i = 0; i < seeds.size(); ++i)
    if (!is_finite(seeds[i]))
      return Error{ErrorCode::non_finite,
                   "Seed point " + std::to_string(i) + " is not a pair of finite numbers.",
                   {}};
  return {};
}

// What the caller says now stands in for what came with the domain.
UserFields with_those_of(const DomainInput& input, UserFields user) {
  if (user.sizes.empty()) user.sizes = input.sizes;
  if (user.guides.empty()) user.guides = input.guides;
  if (user.seeds.empty()) user.seeds = input.seeds;
  return user;
}

/// Where an outline alone asks for many.
std::vector<Warning> outline_warnings(const Preparation& prepared, const Options& options,
                                      const UserFields& user, double size) {
  if (options.keep_boundary || options.simplify > 0 || !user.sizes.empty() || user.size) return {};
  return tell_fine_outline(prepared.domain, size, cell_capacity(prepared.fields));
}

/// What the caller is told of the inputs, and what it means for what comes next.
void add_notes(Preparation& prepared, const FieldOptions& fields, const Options& options,
               const UserFields& user, double size) {
  const auto tell = [&](std::vector<Warning> warnings) {
    for (Warning& warning : warnings) prepared.boundary.warnings.push_back(std::move(warning));
  };
  std::vector<Warning> of_outline = outline_warnings(prepared, options, user, size);
  prepared.seeks_count = options.quads > 0 && !user.size && of_outline.empty();
  tell(std::move(of_outline));
  IdleInputs idle =
      idle_inputs(user, prepared.domain.frame, prepared.boundary, fields, prepared.fields);
  tell(std::move(idle.warnings));
  prepared.own_fields = !idle.decide_on_fields;
  if (options.quads > 0 && user.size)
    tell({{ErrorCode::ignored,
           "The number of quads has no effect here: a function gives the sizes.",
           {}}});
}

}  // namespace

Error in_world(Error error, const UnitFrame& frame) {
  const Vec2 at = frame.to_world({error.where.x, error.where.y});
  if (error.where.has_point) error.where.set_point(at.x, at.y);
  return error;
}

Result<Preparation> prepare(const DomainInput& input, const Options& options,
                            const UserFields& user) {
  if (const Problem range = check_ranges(options)) return *range;
  if (const Problem both = judge_size_options(options)) return *both;
  if (options.growth > 0 && options.growth < least_growth)
    return Error{ErrorCode::bad_option, "The growth of sizes must be 0 or at least 0.01.", {}};
  const UserFields given = with_those_of(input, user);
  if (const Problem problem = judge_seeds(given.seeds)) return *problem;

  Preparation prepared;
  auto domain = make_domain(input, {.strict = options.strict});
  if (!domain) return domain.error();
  prepared.domain = std::move(*domain);

  const auto size = judge_size(prepared.domain, options);
  if (!size) return size.error();
  const UnitFrame& frame = prepared.domain.frame;
  if (const Problem problem = judge_user_fields(given, prepared.domain, options.max_elements))
    return *problem;
  const bool counts = options.quads > 0 && !given.size;  // a function leaves no size to choose
  auto graded = counts ? grade_for_count(prepared.domain, options, given, *size)
                       : grade_for_size(prepared.domain, options, given, *size);
  if (!graded) return in_world(graded.error(), frame);
  prepared.boundary = std::move(graded->boundary);
  auto fields = make_fields(prepared.boundary, graded->fields);
  if (!fields) return in_world(fields.error(), frame);
  prepared.fields = std::move(*fields);
  add_notes(prepared, graded->fields, options, given, *size);
  for (const Vec2 seed : given.seeds) prepared.seeds.push_back(frame.to_frame(seed));
  return prepared;
}

Fields with_scaled_size(Fields fields, double factor) {
  for (double& h : fields.h) h *= factor;
  fields.attach();
  return fields;
}

}  // namespace lpq
