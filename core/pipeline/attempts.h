// Which chains of stages a run tries, one after the other.
#pragma once

#include <vector>

#include "pipeline/options.h"

namespace lpq {

/// One chain of stages.
struct Attempt {
  Seeds seeds = Seeds::aligned;
  bool given = false;  // start from the caller's points instead
  int iterations = 0;
  int restarts = 0;  // rounds of exchanging points after these
  double size_factor = 1;
  bool subdivide = false;    // three quads per triangle: always valid, never pretty
  bool cut_darts = false;    // what nothing else made convex: valid, not pretty either
  bool alternative = false;  // run even when the one before passed; the better mesh is kept
};

/// The first is what was asked for, with an alternative at most; the others are tried only when the
/// final check finds the mesh wanting. `seeds_given`: the caller has points to start from.
std::vector<Attempt> plan_attempts(const Options& options, bool seeds_given);

/// What the chain starts from, as reports say it.
const char* start_name(const Attempt& attempt);

}  // namespace lpq
