// How small a mesh may be beside coordinates far from the origin.
#pragma once

#include "domain/domain.h"

namespace lpq {

/// Lengths below, in the unit frame, leave no room for shapes between neighbouring doubles.
double least_resolved(const Domain& domain);

/// Says so of a size, in the caller's units.
Error unresolved_size(double size);

}  // namespace lpq
