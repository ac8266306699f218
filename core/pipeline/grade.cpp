// See grade.h.
#include "pipeline/grade.h"

#include <algorithm>
#include <limits>

#include "field/size_for_count.h"
#include "geometry/box.h"
#include "grids/balanced_pieces.h"
#include "pipeline/user_fields.h"

namespace lpq {
namespace {

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

/// Opposite sides get the same number of nodes: fewer irregular vertices between them, or a grid.
BoundaryMesh balance(const Domain& domain, BoundaryOptions options, BoundaryMesh boundary) {
  options.pieces = balanced_pieces(boundary);
  if (options.pieces.empty()) return boundary;
  auto balanced = sample_boundary(domain, options);
  return balanced ? std::move(*balanced) : std::move(boundary);
}

Result<Graded> grade(const Domain& domain, const Options& options, const UserFields& user,
                     double size, double growth, Index most_nodes = BoundaryOptions{}.max_nodes) {
  const BoundaryOptions nodes = boundary_options(domain, options, user, size, growth, most_nodes);
  auto boundary = sample_boundary(domain, nodes);
  if (!boundary) return boundary.error();
  if (!options.keep_boundary && options.method == Method::best && !has_function(user))
    *boundary = balance(domain, nodes, std::move(*boundary));
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

Result<Graded> grade_with(const Domain& domain, const Options& options, const UserFields& user,
                          double size, double growth) {
  if (growth > 0) return grade(domain, options, user, size, growth);
  return grade_as_affordable(domain, options, user, size);
}

// A number of quads that sizes of gentle slope have no room for may have it where they are steeper.
struct Counted {
  SizeForCount size;
  double growth = 0;
};

Result<Counted> size_by_count(const Domain& domain, const Options& options, const UserFields& user,
                              double first) {
  Counted counted{.growth = options.growth};
  const auto quads_of = [&](double size) -> Result<double> {
    const auto graded = grade_with(domain, options, user, size, counted.growth);
    if (!graded) return graded.error();
    return estimate_quads(graded->boundary, graded->fields);
  };
  const double largest = diagonal(box_of(domain.points));
  auto found = size_for_count(first, largest, options.quads, quads_of);
  if (found && options.growth == 0 && found->quads > options.quads &&
      judge_count(found->quads, options.quads)) {
    counted.growth = steep_growth;
    found = size_for_count(first, largest, options.quads, quads_of);
  }
  if (!found) return found.error();
  counted.size = *found;
  return counted;
}

}  // namespace

Result<Graded> grade_for_size(const Domain& domain, const Options& options, const UserFields& user,
                              double size) {
  return grade_with(domain, options, user, size, options.growth);
}

Result<Graded> grade_for_count(const Domain& domain, const Options& options, const UserFields& user,
                               double first) {
  const auto counted = size_by_count(domain, options, user, first);
  if (!counted) return counted.error();
  return grade_with(domain, options, user, counted->size.size, counted->growth);
}

}  // namespace lpq
