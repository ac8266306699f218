// Which region lies on either side of everything: the check that several regions fit together, and
// the place of polylines and points.
#pragma once

#include "domain/domain.h"

namespace lpq {

/// Checks that the sides of all loop segments agree with each other, gives polylines their region
/// and checks that they and the isolated points lie inside. Errors: region_conflict; touching (a
/// point on an edge); hole_outside (a polyline or point outside the domain).
Problem settle_sides(Domain& domain);

}  // namespace lpq
