// Which chains of stages a run tries, one after the other.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "pipeline/options.h"

namespace lpq {

/// A plain grid in place of a chain (grids/submapped_grid.h), after one that says where holes lie.
enum class Grid { no, plane, ring };

/// Sizes a little off make other meshes, some with fewer irregular vertices; those worth most
/// first. What they gain falls with the number of quads: with two of them mean eta rises by 0.015
/// at 150 quads, 0.008 at 500, 0.001 at 2500; four gain a little more.
inline constexpr std::array<double, 4> other_sizes{0.97, 1.03, 0.94, 1.06};
inline constexpr double few_quads = 1000;
/// Where meshes are compared: below this eta the worst quad counts as much as all others together.
inline constexpr double least_eta = 0.2;

/// One chain of stages.
struct Attempt {
  Seeds seeds = Seeds::aligned;
  bool given = false;  // start from the caller's points instead
  Grid grid = Grid::no;
  int iterations = 0;
  int restarts = 0;  // rounds of exchanging points after these
  double size_factor = 1;
  bool subdivide = false;    // three quads per triangle: always valid, never pretty
  bool cut_darts = false;    // what nothing else made convex: valid, not pretty either
  bool alternative = false;  // run even when the one before passed; the better mesh is kept
  bool at_once = false;      // in one step: nobody needs to see the same stages again
};

/// What decides on attempts beside the options.
struct AttemptGrounds {
  bool seeds_given = false;  // the caller has points to start from
  // So many are expected. 0: directions or sizes are the caller's, who is to get them as they are.
  double quads = 0;
};

/// The first is what was asked for, with alternatives: sizes a little off make other meshes, some
/// with fewer irregular vertices, and some borders have a plain grid. The others are tried only
/// when the final check finds the mesh wanting.
std::vector<Attempt> plan_attempts(const Options& options, const AttemptGrounds& grounds);

/// What the chain starts from, as reports say it.
std::string start_name(const Attempt& attempt);

}  // namespace lpq
