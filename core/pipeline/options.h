// Every option of a run, declared once: name, default, range, unit and help.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/option_table.h"
#include "domain/domain.h"
#include "geometry/vec.h"

namespace lpq {

enum class Method { best, paper };
enum class Elements { quad, one_triangle, quad_dominant };
enum class Effort { normal, high };
enum class Seeds { automatic, aligned, isotropic };

template <>
struct ChoiceNames<Method> {
  static constexpr std::array<const char*, 2> names{"best", "paper"};
};
template <>
struct ChoiceNames<Elements> {
  static constexpr std::array<const char*, 3> names{"quad", "one-triangle", "quad-dominant"};
};
template <>
struct ChoiceNames<Effort> {
  static constexpr std::array<const char*, 2> names{"normal", "high"};
};
template <>
struct ChoiceNames<Seeds> {
  static constexpr std::array<const char*, 3> names{"automatic", "aligned", "isotropic"};
};

/// Lengths in the caller's unit; each_field() below holds the full text, range and unit of each.
struct Options {
  double size = 0;             // target edge length; 0: the domain's own, or for about 1000 quads
  int quads = 0;               // in place of a size; 0: not asked
  bool keep_boundary = false;  // the given points are the 1D mesh and come back bit for bit
  Elements elements = Elements::quad;
  Method method = Method::best;
  Effort effort = Effort::normal;
  Seeds seeds = Seeds::automatic;
  double norm = 6;                 // p of the L_p energy
  int iterations = -1;             // of L_p; -1: as the start needs, none if aligned
  int restarts = -1;               // of L_p; -1: as the start needs, none if aligned
  std::uint64_t seed = 1;          // of random choices
  double growth = 0;               // slope of sizes; 0: 0.08, or more where that would cost much
  double simplify = 0;             // length by which the outline may move; 0: not at all
  bool allow_added_point = false;  // in a kept boundary of odd count
  bool strict = false;             // repeated points are errors
  // Of sizes beside right angles. At 0.11 large fillings of patches are too uneven in graded sizes.
  double size_weight = 0.12;
  int smoothing = -1;             // iterations at the end; -1: 300, 600 with high effort, paper 100
  int max_elements = 10'000'000;  // refused beyond, before allocating
};

/// What the caller knows better than the mesher, in the caller's units; all optional. Sizes,
/// guides and seeds given here stand in for those that came with the domain.
struct UserFields {
  using SizeAt = DomainInput::SizeAt;
  using Guide = DomainInput::Guide;
  std::vector<SizeAt> sizes;         // target size at points
  std::function<double(Vec2)> size;  // target size anywhere; wins over `sizes` and Options::size
  double detail = 0;  // length below which `size` hardly varies; 0 = 1/48 of the domain's extent
  std::vector<Guide> guides;          // strokes whose direction the crosses follow nearby
  std::function<double(Vec2)> angle;  // direction of the crosses, radians; wins over all guides
  std::function<Vec2(Vec2)> stretch;  // Fields::stretch: sizes and directions are those after it
  std::vector<Vec2> seeds;            // interior points to start L_p from; others are left out
};

/// Errors: bad_option where a size and a number of quads are given, which contradict each other.
template <class O>
Problem judge_size_options(const O& options) {
  if (!(options.size > 0 && options.quads > 0)) return std::nullopt;
  return Error{ErrorCode::bad_option, "Give a size or a number of quads, not both.", {}};
}

/// How points are placed; of the planar chain, wherever it runs.
template <class O, class F>
void each_lp_field(O& o, F&& visit) {
  visit("effort", o.effort,
        OptionInfo{0, 1, "",
                   "high: irregular vertices are moved about and cancelled for much longer; in the "
                   "plane four other sizes are tried instead of two."});
  visit(
      "seeds", o.seeds,
      OptionInfo{
          0, 2, "",
          "Initial points: aligned with the cross field, isotropic, or what the method prefers."});
  visit("norm", o.norm, OptionInfo{2, 20, "", "Exponent p of the L_p energy."});
  visit(
      "iterations", o.iterations,
      OptionInfo{-1, 100000, "",
                 "L-BFGS iterations; -1 is 80, but none for an aligned start of the best chain."});
  visit(
      "restarts", o.restarts,
      OptionInfo{-1, 1000, "",
                 "Rounds after these that insert points in gaps, remove some where they crowd, and "
                 "iterate 30 times; -1 is 10 for an isotropic start of the best chain whose "
                 "iterations are left to us, else none."});
}

template <class O, class F>
requires std::is_same_v<std::remove_const_t<O>, Options>
void each_field(O& o, F&& visit) {
  visit("size", o.size,
        OptionInfo{0, 1e300, "length",
                   "Target edge length; 0 takes the domain's own h (about 1000 quads where it has "
                   "none), or the boundary's spacing when it is kept.",
                   ErrorCode::bad_size});
  visit("quads", o.quads,
        OptionInfo{0, 100'000'000, "",
                   "About how many quads, in place of a size, which is chosen for them; 0 = not "
                   "asked."});
  visit("keepBoundary", o.keep_boundary,
        OptionInfo{0, 1, "", "The given points are the boundary mesh and come back bit for bit."});
  visit("elements", o.elements,
        OptionInfo{
            0, 2, "",
            "quad: no triangle at all; one-triangle: just one where a kept boundary has an odd "
            "count, placed where it costs least; quad-dominant: a triangle may stay where it is "
            "better."});
  visit("method", o.method,
        OptionInfo{0, 1, "",
                   "best: the chain of stages that measures best; paper: isotropic start, L_p, "
                   "Blossom, smoothing."});
  each_lp_field(o, visit);
  visit(
      "seed", o.seed,
      OptionInfo{0, 9007199254740991.0, "",
                 "Seed of the isotropic start's jitter, and of what high effort draws at random."});
  visit("growth", o.growth,
        OptionInfo{0, 10, "",
                   "Largest slope of the size field; 0 is 0.08, or up to 0.3 where 0.08 would cost "
                   "more than 5000 elements over 0.3."});
  visit("simplify", o.simplify,
        OptionInfo{0, 1e300, "length",
                   "Boundary vertices may be dropped when the outline moves by at most this (not "
                   "with keepBoundary)."});
  visit(
      "allowAddedPoint", o.allow_added_point,
      OptionInfo{
          0, 1, "",
          "A kept boundary with an odd count may get one added point (rather than one triangle)."});
  visit("strict", o.strict,
        OptionInfo{0, 1, "",
                   "Repeated consecutive points are an error instead of merged with a warning."});
  visit("sizeWeight", o.size_weight,
        OptionInfo{0, 10, "",
                   "What keeping to the target size is worth beside right angles; with 0 only the "
                   "angles count."});
  visit("smoothing", o.smoothing,
        OptionInfo{-1, 10000, "",
                   "Iterations of the final smoothing; -1 is 100 for the paper's chain, else 300, "
                   "or 600 with "
                   "high effort."});
  visit("maxElements", o.max_elements,
        OptionInfo{1, 100'000'000, "",
                   "Refuse before allocating when more elements than this are expected."});
}

}  // namespace lpq
