// Builds the background mesh and solves for both fields.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "base/result.h"
#include "domain/boundary.h"
#include "domain/size_cones.h"
#include "field/field.h"

namespace lpq {

struct FieldOptions {
  double size = 0;                            // constant target, 0 = from the boundary spacing
  std::vector<SizeSample> sizes;              // the caller's values at points (nearest-graded)
  std::function<double(Vec2)> size_function;  // the caller's callable, unit frame; wins over both
  double function_detail = 0;  // length below which size_function hardly varies; 0 = by default
  std::vector<DomainInput::Guide> guides;      // the caller's strokes, unit frame
  std::function<double(Vec2)> angle_function;  // the caller's theta(x); replaces the Laplace solve
  std::function<Vec2(Vec2)> stretch_function;  // of Fields::stretch
  double growth = 0.3;                         // largest slope of h; > 0
  double max_quads = std::numeric_limits<double>::infinity();  // refused beyond
  double coarseness = 3;  // background spacing in units of h off the walls; more beyond 20 h
};

/// Background triangulation graded from the boundary, cross field by Laplace's equation on
/// (cos 4 theta, sin 4 theta) with the walls' directions as Dirichlet data on wall *edges*
/// (Crouzeix-Raviart unknowns, so a corner never averages two directions), likewise the guides' on
/// edges that they meet, where the background is as fine as the target; size field by Laplace on
/// log h from the spacing (or the caller's), limited to the given growth.
/// Errors: bad_size; non_finite for an angle, a stretch or a guide; bad_option for a guide without
/// a direction (see Where::guide); too_many_elements where the sizes ask for more than `max_quads`.
/// Cost: two sparse Cholesky factorisations of the background.
Result<Fields> make_fields(const BoundaryMesh& boundary, const FieldOptions& options = {});

/// Errors: non_finite for a stretch that turns a direction off, or is no number.
Problem judge_stretch(Vec2 mu, Vec2 at);

/// What the sizes at points ask for; nothing beside a function of sizes.
std::vector<SizeCone> size_cones_of(const FieldOptions& options);

/// About how many quads these sizes ask for, the integral of 1/h^2, from the coarse background
/// alone. Errors: those of the sizes above.
Result<double> estimate_quads(const BoundaryMesh& boundary, const FieldOptions& options);

}  // namespace lpq
