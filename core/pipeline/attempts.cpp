// See attempts.h.
#include "pipeline/attempts.h"

#include <algorithm>

#include "base/words.h"

namespace lpq {
namespace {

// Iterations of L_p when the caller leaves the choice to us: "eighty iterations are usually
// sufficient" (paper section 3.3.3); an aligned start is already where L_p would lead.
constexpr int isotropic_iterations = 80;
// What has no mesh is mostly narrower in places than the size: then smaller quads fit; and where
// the rows of an aligned start are the reason, a few iterations of L_p from scattered points do not
// have them.
constexpr double smaller = 0.75, still_smaller = 0.6;
constexpr int brief_iterations = 20;
// Or edges of a kept boundary are long for the size: larger quads have fewer corners at them.
constexpr double larger = 3;
// Three quads per triangle halve its sides: the triangles are larger to begin with.
constexpr double before_subdivision = 1.5;
// Rounds of exchanging points: from an isotropic start four in five of what twice as many bring.
// None where the count is the caller's or the paper's, or the start aligned, which they harm.
constexpr int isotropic_restarts = 10;
constexpr double few_for_high_effort = 1500;  // in place of few_quads
// A step of more would keep a page waiting, and hardly anything is lacking there.
constexpr double most_quads_of_grid = 10'000;

std::size_t sizes_to_try(const Options& options, double quads) {
  const bool high = options.effort == Effort::high;
  if (!(quads < (high ? few_for_high_effort : few_quads))) return 0;
  return high ? 4 : 2;
}

// High effort begins with all that normal effort tries, so that it never ends with less.
void add_alternatives(const Options& options, const AttemptGrounds& grounds, Seeds seeds,
                      std::vector<Attempt>& attempts) {
  if (!(grounds.quads > 0)) return;
  if (grounds.quads < most_quads_of_grid)
    for (const Grid grid : {Grid::plane, Grid::ring})
      attempts.push_back({.grid = grid, .alternative = true, .at_once = true});
  for (std::size_t k = 0; k < sizes_to_try(options, grounds.quads); ++k)
    attempts.push_back(
        {.seeds = seeds, .size_factor = other_sizes[k], .alternative = true, .at_once = true});
}

}  // namespace

std::vector<Attempt> plan_attempts(const Options& options, const AttemptGrounds& grounds) {
  std::vector<Attempt> attempts;
  const bool paper = options.method == Method::paper;
  Seeds seeds = options.seeds;
  if (seeds == Seeds::automatic) seeds = paper ? Seeds::isotropic : Seeds::aligned;
  const bool isotropic = seeds == Seeds::isotropic;
  const int asked = options.iterations, restarts = std::max(0, options.restarts);
  if (grounds.seeds_given) {
    const int iterations = asked < 0 ? isotropic_iterations : asked;
    attempts.push_back({.given = true, .iterations = iterations, .restarts = restarts});
  } else if (isotropic || paper) {
    const bool ours = asked < 0 && options.restarts < 0 && !paper;
    attempts.push_back({.seeds = seeds,
                        .iterations = asked < 0 ? isotropic_iterations : asked,
                        .restarts = ours ? isotropic_restarts : restarts});
  } else {
    // L_p can undo a good aligned start: with it and without it, the better mesh is kept.
    attempts.push_back({.seeds = seeds});
    if (asked > 0)
      attempts.push_back(
          {.seeds = seeds, .iterations = asked, .restarts = restarts, .alternative = true});
    else
      add_alternatives(options, grounds, seeds, attempts);
  }
  attempts.push_back({.seeds = Seeds::aligned, .size_factor = smaller});
  if (options.keep_boundary) {
    attempts.push_back(
        {.seeds = Seeds::isotropic, .iterations = brief_iterations, .size_factor = still_smaller});
    attempts.push_back({.seeds = Seeds::aligned, .cut_darts = true});
    attempts.push_back({.seeds = Seeds::aligned, .size_factor = larger});
  } else {
    attempts.push_back(
        {.seeds = Seeds::isotropic, .size_factor = before_subdivision, .subdivide = true});
  }
  return attempts;
}

std::string start_name(const Attempt& attempt) {
  if (attempt.grid != Grid::no) return attempt.grid == Grid::plane ? "grid" : "ring";
  if (attempt.given) return "given";
  const std::string name = attempt.seeds == Seeds::isotropic ? "isotropic" : "aligned";
  return attempt.size_factor == 1 ? name : name + " at size x " + short_number(attempt.size_factor);
}

}  // namespace lpq
