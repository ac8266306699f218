// The bodies of a file, which touch but are not one: each gets a mesh of its own.
#pragma once

#include "surface/soup.h"

namespace lpq {

/// Joins bodies that are none by themselves: those that share points with others, and all whose
/// triangles leave edges open (where equal points are one), as loose sheets of one shell. Of
/// several in one the first gives the name. Cost O(#T log #T).
void join_loose_bodies(SurfaceSoup& soup);

}  // namespace lpq
