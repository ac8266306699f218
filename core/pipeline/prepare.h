// Everything that is decided before the first point is placed: domain, 1D mesh, fields.
#pragma once

#include "domain/boundary.h"
#include "domain/domain.h"
#include "field/field.h"
#include "pipeline/options.h"

namespace lpq {

struct Preparation {
  Domain domain;
  BoundaryMesh boundary;
  Fields fields;
  std::vector<Vec2> seeds;   // the caller's, unit frame; empty = the method's own
  bool seeks_count = false;  // of quads, which is judged in the end
  bool own_fields = true;    // neither sizes nor directions are the caller's
};

/// Judges input and options, makes the 1D mesh and both fields.
/// Errors: bad_option, bad_size, too_many_elements, and those of judge_user_fields, make_domain,
/// sample_boundary, make_fields.
Result<Preparation> prepare(const DomainInput& input, const Options& options,
                            const UserFields& user = {});

/// An error of the steps that know the unit frame only, for people, who know their own coordinates.
Error in_world(Error error, const UnitFrame& frame);

/// The same fields with every target size multiplied by `factor`.
Fields with_scaled_size(Fields fields, double factor);

}  // namespace lpq
