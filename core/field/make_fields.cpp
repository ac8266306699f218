// Order of work: a coarse background graded by the walls alone carries a first size field; that
// decides how fine the interior of the final background must be; on it the crosses are solved and
// the sizes completed.
#include "field/make_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/words.h"
#include "field/background.h"
#include "field/cross_field.h"
#include "field/guides.h"
#include "field/size_field.h"
#include "geometry/box.h"
#include "geometry/segment.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

// A size function may vary anywhere: unless the caller knows better, it is looked at on leaves of
// at most this share of the domain.
constexpr double function_resolution = 1.0 / 48;
// A size function may be small where the coarse background did not look: no more new leaves than
// any mesh within the limit would need, as a leaf is some quads wide.
constexpr double leaves_beside_quads = 1e5, leaves_per_quad = 2;
constexpr double largest_angle = 1e4;  // radians, for sin_cos of four times as much

// From this distance to the walls on, in units of h, the background grows further, as the square
// root of the distance: the crosses turn by about h / distance per h there, and a phase carried
// along an edge of length L errs by about (L / h) (L / distance)^2 / 12.
constexpr double coarsening_depth = 20;

bool good_size(double h) { return std::isfinite(h) && h > 0; }

Error error_at(ErrorCode code, std::string message, Vec2 at) {
  Error error{code, std::move(message), {}};
  error.where.set_point(at.x, at.y);
  return error;
}
Error bad_size(std::string message) { return {ErrorCode::bad_size, std::move(message), {}}; }

// Points so far away that their squares overflow are as good as infinite.
Problem judge_guide(const DomainInput::Guide& guide, Index number) {
  const std::string name = "guide " + std::to_string(number);
  Error error{ErrorCode::bad_option, {}, {}};
  error.where.guide = number;
  for (std::size_t i = 0; i < guide.size(); ++i)
    if (!std::isfinite(squared_length(guide[i]))) {
      error.code = ErrorCode::non_finite;
      error.message = "Point " + std::to_string(i) + " of " + name + " is not finite.";
      error.where.edge = static_cast<Index>(i);
      return error;
    }
  if (guide.size() < 2) {
    error.message = "A guide needs at least two points, but " + name + " has " +
                    std::to_string(guide.size()) + ".";
    return error;
  }
  for (const Vec2 p : guide)
    if (!(p == guide.front())) return std::nullopt;
  error = error_at(error.code, "All points of " + name + " are the same: it has no direction.",
                   guide.front());
  error.where.guide = number;
  return error;
}

Problem judge(const FieldOptions& options) {
  if (!(options.size == 0 || good_size(options.size)))
    return bad_size("The mesh size must be a positive number.");
  if (!good_size(options.growth)) return bad_size("The growth of sizes must be positive.");
  if (!(std::isfinite(options.coarseness) && options.coarseness >= 0.25))
    return bad_size("The coarseness of the background must be at least 0.25.");
  for (const SizeSample& s : options.sizes)
    if (!good_size(s.h) || !is_finite(s.position))
      return error_at(ErrorCode::bad_size,
                      "A mesh size given at a point must be a positive number.", s.position);
  for (std::size_t i = 0; i < options.guides.size(); ++i)
    if (auto error = judge_guide(options.guides[i], static_cast<Index>(i))) return error;
  return std::nullopt;
}

double largest_size(const FieldOptions& options) {
  return options.size > 0 ? options.size : std::numeric_limits<double>::infinity();
}

// Sizes at the vertices as asked for, before any limit; infinite where nothing is asked.
std::vector<double> asked_sizes(const TriMesh& mesh, const BoundaryMesh& boundary,
                                const FieldOptions& options) {
  if (options.size_function) {
    std::vector<double> h;
    h.reserve(mesh.points.size());
    for (const Vec2 p : mesh.points) h.push_back(options.size_function(p));
    return h;
  }
  if (options.size > 0 || !options.sizes.empty())
    return std::vector<double>(mesh.points.size(), largest_size(options));
  return harmonic_size(mesh, boundary);
}

Problem complete_sizes(const TriMesh& mesh, const BoundaryMesh& boundary,
                       const FieldOptions& options, std::span<const SizeCone> cones,
                       std::span<double> h) {
  for (std::size_t v = 0; v < h.size(); ++v)
    if (!(h[v] > 0) || (options.size_function && !std::isfinite(h[v])))
      return error_at(ErrorCode::bad_size, "The mesh size is not a positive number here.",
                      mesh.points[v]);
  limit_by_cones(mesh, cones, options.growth, h);
  limit_by_walls(boundary, h);
  limit_growth(mesh, options.growth, h);
  return std::nullopt;
}

std::vector<double> distance_to_walls(const TriMesh& mesh) {
  std::vector<double> depth(mesh.points.size(), std::numeric_limits<double>::infinity());
  std::fill(depth.begin(), depth.begin() + mesh.fixed, 0.0);
  limit_growth(mesh, 1, depth);
  return depth;
}

double interpolate(const TriMesh& mesh, std::span<const double> h, Index t, const double (&w)[3]) {
  const auto [a, b, c] = mesh.triangles[t];
  return w[0] * h[a] + w[1] * h[b] + w[2] * h[c];
}

Result<CrossField> crosses(const TriMesh& mesh, const FieldOptions& options,
                           std::span<const Chord> guides) {
  if (!options.angle_function) return solve_cross_field(mesh, guides);
  CrossField field;
  field.z.reserve(mesh.points.size());
  for (const Vec2 p : mesh.points) {
    const double angle = options.angle_function(p);
    if (!(std::abs(angle) < largest_angle))
      return error_at(ErrorCode::non_finite,
                      "The direction is not a number of radians below 10000 here.", p);
    const auto [s, c] = sin_cos(4 * angle);
    field.z.push_back({c, s});
  }
  return field;
}

// So that the background shows the disc of a cone; its middle is a source already.
void add_rim(const SizeCone& cone, std::vector<Source>& sources) {
  if (!(cone.reach > 0)) return;
  const double r = cone.reach, q = std::sqrt(0.5) * r;
  for (const Vec2 d : {Vec2{r, 0}, {q, q}, {0, r}, {-q, q}, {-r, 0}, {-q, -q}, {0, -r}, {q, -q}})
    sources.push_back({cone.tip + d, cone.h});
}

BackgroundBuilder builder_for(const BoundaryMesh& boundary, const FieldOptions& options,
                              std::span<const SizeCone> cones) {
  std::vector<Source> sources;
  for (const SizeSample& s : options.sizes) sources.push_back({s.position, s.h});
  for (const SizeCone& cone : cones) add_rim(cone, sources);
  const double detail = options.function_detail > 0
                            ? options.function_detail
                            : function_resolution * longer_side(box_of(boundary.points));
  return BackgroundBuilder(boundary, sources, options.size_function ? detail : 0);
}

// The coarse background and the sizes at its vertices.
struct CoarseSizes {
  TriMesh mesh;
  std::vector<double> h;
};

Result<CoarseSizes> coarse_sizes(const BackgroundBuilder& builder, const BoundaryMesh& boundary,
                                 const FieldOptions& options, std::span<const SizeCone> cones) {
  auto mesh = builder.coarse();
  if (!mesh) return mesh.error();
  std::vector<double> h = asked_sizes(*mesh, boundary, options);
  if (auto error = complete_sizes(*mesh, boundary, options, cones, h)) return std::move(*error);
  return CoarseSizes{std::move(*mesh), std::move(h)};
}

/// The integral of 1/h^2.
double quads_of(const TriMesh& mesh, std::span<const double> h) {
  double quads = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const double area =
        0.5 * cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    // Exact for quadratic integrands; 1/h^2 varies by a small factor in a triangle.
    for (const double middle : {h[a] + h[b], h[b] + h[c], h[c] + h[a]})
      quads += area / 3 * 4 / (middle * middle);
  }
  return quads;
}

// Refined inside as the sizes on the coarse background ask, with those of new vertices.
Result<FineBackground> fine_background(BackgroundBuilder& builder, const CoarseSizes& coarse,
                                       const FieldOptions& options) {
  const auto size_at = [&](Index t, const double(&weights)[3], Vec2 point) {
    const double h = interpolate(coarse.mesh, coarse.h, t, weights);
    if (!options.size_function) return h;
    const double asked = options.size_function(point);
    return good_size(asked) ? std::min(h, asked) : h;
  };
  const std::vector<double> depth = distance_to_walls(coarse.mesh);
  const auto largest_leaf = [&](Index t, const double(&weights)[3], Vec2 point) {
    const double h = size_at(t, weights, point);
    const double far = interpolate(coarse.mesh, depth, t, weights) / (coarsening_depth * h);
    return options.coarseness * h * std::sqrt(std::max(far, 1.0));
  };
  const double most_leaves = leaves_beside_quads + leaves_per_quad * options.max_quads;
  return builder.fine(coarse.mesh, largest_leaf, size_at, most_leaves);
}

}  // namespace

std::vector<SizeCone> size_cones_of(const FieldOptions& options) {
  if (options.size_function) return {};
  return size_cones(options.sizes, options.growth, largest_size(options));
}

Problem judge_stretch(Vec2 mu, Vec2 at) {
  if (squared_length(mu) < 1) return std::nullopt;
  return error_at(ErrorCode::non_finite, "The stretch is not a vector shorter than 1 here.", at);
}

Result<double> estimate_quads(const BoundaryMesh& boundary, const FieldOptions& options) {
  if (auto error = judge(options)) return std::move(*error);
  const std::vector<SizeCone> cones = size_cones_of(options);
  const auto coarse = coarse_sizes(builder_for(boundary, options, cones), boundary, options, cones);
  if (!coarse) return coarse.error();
  return quads_of(coarse->mesh, coarse->h);
}

Result<Fields> make_fields(const BoundaryMesh& boundary, const FieldOptions& options) {
  if (auto error = judge(options)) return std::move(*error);
  const std::vector<SizeCone> cones = size_cones_of(options);
  BackgroundBuilder builder = builder_for(boundary, options, cones);
  const auto coarse = coarse_sizes(builder, boundary, options, cones);
  if (!coarse) return coarse.error();
  if (const double quads = quads_of(coarse->mesh, coarse->h); quads > options.max_quads)
    return too_many_elements(quads, options.max_quads);

  const std::vector<Chord> guides = chords_of(options.guides, coarse->mesh, coarse->h);
  builder.refine(sources_along(guides));
  auto fine = fine_background(builder, *coarse, options);
  if (!fine) return fine.error();

  Fields fields;
  fields.background = std::move(fine->mesh);
  if (options.size_function || options.size > 0 || !options.sizes.empty()) {
    fields.h = asked_sizes(fields.background, boundary, options);
  } else {
    fields.h.assign(coarse->h.begin(), coarse->h.begin() + boundary.points.size());
    fields.h.insert(fields.h.end(), fine->interior_values.begin(), fine->interior_values.end());
  }
  if (auto error = complete_sizes(fields.background, boundary, options, cones, fields.h))
    return std::move(*error);
  auto field = crosses(fields.background, options, guides);
  if (!field) return field.error();
  fields.z = std::move(field->z);
  fields.pull = std::move(field->pull);
  if (options.stretch_function)
    for (const Vec2 p : fields.background.points) {
      fields.stretch.push_back(options.stretch_function(p));
      if (auto error = judge_stretch(fields.stretch.back(), p)) return std::move(*error);
    }
  fields.has_spots = wider_than_growth(cones, options.growth);
  fields.singularities = find_singularities(fields.background, fields.z);
  fields.attach();
  return fields;
}

}  // namespace lpq
