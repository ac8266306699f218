#include "pipeline/prepare.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/words.h"
#include "field/make_fields.h"
#include "geometry/box.h"
#include "pipeline/idle_inputs.h"
#include "pipeline/user_fields.h"

namespace lpq {
namespace {

// A domain that comes without any size gets about this many quads.
constexpr double default_quads = 1000;
// A mesh size of fewer steps between neighbouring coordinates leaves no room for shapes.
constexpr double least_steps = 16;

Error size_error(std::string message) { return {ErrorCode::bad_size, std::move(message), {}}; }

// The slope of sizes when the caller leaves the choice to us. In a field of slope g quads lose
// about g/2 of their shape, since lines have to spread or end, and a mesh graded over all its
// extent has about 1/g times as many of them: shape is bought with quads, but with this many at
// most.
constexpr double gentle_growth = 0.08, steep_growth = 0.3;
constexpr double spare_quads = 5000;
// Boundaries with more nodes than this are not looked at with the gentle slope at all, and where
// the spare quads would hardly show they are saved, too.
constexpr Index most_gentle_nodes = 50000;
constexpr double least_share = 0.05;
constexpr double least_growth = 0.01;

double diagonal(const Domain& domain) {
  const Box box = box_of(domain.points);
  return length(box.hi - box.lo);
}

// The distance, in the unit frame, of neighbouring doubles among the caller's coordinates.
double coordinate_step(const Domain& domain) {
  double largest = 0;
  for (const Vec2 p : domain.points) {
    const Vec2 world = domain.frame.to_world(p);
    largest = std::max({largest, std::abs(world.x), std::abs(world.y)});
  }
  return domain.frame.length_to_frame(largest) * std::numeric_limits<double>::epsilon();
}

// The constant target in the unit frame; 0 means: follow the kept boundary's spacing.
double target_size(const Domain& domain, const Options& options) {
  if (options.size > 0) return domain.frame.length_to_frame(options.size);
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
  if (size > 0 && size < least_steps * coordinate_step(domain))
    return Error{
        ErrorCode::lost_precision,
        "Beside coordinates this far from the origin, doubles cannot hold a mesh of size " +
            short_number(domain.frame.length_to_world(size)) +
            ". Move the domain closer to the origin, or use a larger size.",
        {}};
  return size;
}

// Quads alone need even counts; one triangle stands in where a count cannot be made even.
bool requires_even(const Options& options) {
  if (options.elements != Elements::one_triangle) return options.elements == Elements::quad;
  return !options.keep_boundary || options.allow_added_point;
}

BoundaryOptions boundary_options(const Domain& domain, const Options& options,
                                 const UserFields& user, double size, double growth,
                                 Index most_nodes) {
  return {.keep = options.keep_boundary,
          .size = size,
          .growth = growth,
          .simplify_tolerance = domain.frame.length_to_frame(options.simplify),
          .require_even = requires_even(options),
          .allow_added_point = options.allow_added_point,
          // a quad has four edges: more nodes than that mean more elements than allowed
          .max_nodes = std::min(most_nodes, Index{4} * options.max_elements),
          // a size function wins over them
          .sizes = user.size ? std::vector<SizeSample>{} : samples_in_frame(user, domain.frame)};
}

// The caller's fields, moved into the unit frame.
FieldOptions field_options(const UnitFrame& frame, const UserFields& user, double size,
                           double growth, double most_quads) {
  FieldOptions fields;
  fields.size = size;
  fields.growth = growth;
  fields.sizes = samples_in_frame(user, frame);
  for (const UserFields::Guide& guide : user.guides) {
    fields.guides.emplace_back();
    for (const Vec2 p : guide) fields.guides.back().push_back(frame.to_frame(p));
  }
  if (user.size)
    fields.size_function = [frame, size_at = user.size](Vec2 p) {
      return size_in_frame(size_at(frame.to_world(p)), frame);
    };
  fields.max_quads = most_quads;
  fields.function_detail = frame.length_to_frame(user.detail);
  if (user.angle)
    fields.angle_function = [frame, angle_at = user.angle](Vec2 p) {
      return angle_at(frame.to_world(p));
    };
  if (user.stretch)
    fields.stretch_function = [frame, stretch_at = user.stretch](Vec2 p) {
      return stretch_at(frame.to_world(p));
    };
  return fields;
}

// Lengths of the edges are those after the stretch.
Problem stretch_spacing(const UnitFrame& frame, const UserFields& user, BoundaryMesh& boundary) {
  std::vector<double> sum(boundary.points.size(), 0.0);
  std::vector<int> edges(boundary.points.size(), 0);
  for (const Segment& s : boundary.edges) {
    const Vec2 a = boundary.points[s.a], b = boundary.points[s.b];
    const Vec2 mu = user.stretch(frame.to_world(midpoint(a, b)));
    if (Problem problem = judge_stretch(mu, midpoint(a, b))) return problem;
    const double l = length(stretched(b - a, mu));
    for (const Index v : {s.a, s.b}) sum[v] += l, ++edges[v];
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
    if (edges[v] > 0) boundary.spacing[v] = sum[v] / edges[v];
  return {};
}

// A boundary with the sizes inside still to come.
struct Graded {
  BoundaryMesh boundary;
  FieldOptions fields;
};

Result<Graded> grade(const Domain& domain, const Options& options, const UserFields& user,
                     double size, double growth, Index most_nodes = BoundaryOptions{}.max_nodes) {
  auto boundary =
      sample_boundary(domain, boundary_options(domain, options, user, size, growth, most_nodes));
  if (!boundary) return boundary.error();
  if (user.stretch)
    if (Problem problem = stretch_spacing(domain.frame, user, *boundary))
      return std::move(*problem);
  return Graded{std::move(*boundary),
                field_options(domain.frame, user, size, growth, options.max_elements)};
}

// Between two slopes the number of quads goes about as 1/slope.
double affordable_growth(double gentle_quads, double steep_quads) {
  const double share = spare_quads / (gentle_quads - steep_quads);
  if (!(share < 1)) return gentle_growth;
  if (share < least_share) return steep_growth;
  return 1 / (1 / steep_growth + share * (1 / gentle_growth - 1 / steep_growth));
}

Result<Graded> grade_as_affordable(const Domain& domain, const Options& options,
                                   const UserFields& user, double size) {
  auto gentle = grade(domain, options, user, size, gentle_growth, most_gentle_nodes);
  double gentle_quads = std::numeric_limits<double>::infinity();
  if (gentle) {
    const auto quads = estimate_quads(gentle->boundary, gentle->fields);
    if (!quads) return quads.error();
    if (*quads <= spare_quads) return gentle;
    gentle_quads = *quads;
  } else if (gentle.error().code != ErrorCode::too_many_elements) {
    return gentle;
  }
  auto steep = grade(domain, options, user, size, steep_growth);
  if (!steep) return steep;
  const auto quads = estimate_quads(steep->boundary, steep->fields);
  if (!quads) return quads.error();
  const double growth = affordable_growth(gentle_quads, *quads);
  if (growth == gentle_growth) return gentle;
  if (growth == steep_growth) return steep;
  return grade(domain, options, user, size, growth);
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

}  // namespace

Error in_world(Error error, const UnitFrame& frame) {
  const Vec2 at = frame.to_world({error.where.x, error.where.y});
  if (error.where.has_point) error.where.set_point(at.x, at.y);
  return error;
}

Result<Preparation> prepare(const DomainInput& input, const Options& options,
                            const UserFields& user) {
  if (const Problem range = check_ranges(options)) return *range;

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
  auto graded = options.growth > 0 ? grade(prepared.domain, options, given, *size, options.growth)
                                   : grade_as_affordable(prepared.domain, options, given, *size);
  if (!graded) return in_world(graded.error(), frame);
  prepared.boundary = std::move(graded->boundary);
  auto fields = make_fields(prepared.boundary, graded->fields);
  if (!fields) return in_world(fields.error(), frame);
  prepared.fields = std::move(*fields);
  const auto tell = [&](std::vector<Warning> warnings) {
    for (Warning& warning : warnings) prepared.boundary.warnings.push_back(std::move(warning));
  };
  tell(idle_sizes(given, frame, prepared.boundary, graded->fields, prepared.fields));
  tell(idle_guides(given, graded->fields, prepared.fields));
  tell(idle_seeds(given, frame, prepared.fields));
  for (const Vec2 seed : given.seeds) prepared.seeds.push_back(frame.to_frame(seed));
  return prepared;
}

Fields with_scaled_size(Fields fields, double factor) {
  for (double& h : fields.h) h *= factor;
  fields.attach();
  return fields;
}

}  // namespace lpq
