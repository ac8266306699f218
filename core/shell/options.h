// Every option of a surface run, declared once (see pipeline/options.h).
#pragma once

#include "pipeline/options.h"

namespace lpq {

/// Lengths in the caller's unit; each_field() below holds the full text, range and unit of each.
struct SurfaceOptions {
  double size = 0;            // target edge length; 0: for about 3000 quads
  int quads = 0;              // in place of a size; 0: not asked
  double feature_angle = 40;  // degrees of bend beyond which edges are kept
  bool keep_groups = true;    // and borders between groups
  double turn = 0;            // degrees that the surface may turn by over one quad; 0: not asked
  double growth = 0;          // slope of sizes; 0: 0.3
  double weld = 1e-10;        // share of the diagonal; nearer points become one
  Method method = Method::best;
  Effort effort = Effort::normal;
  Seeds seeds = Seeds::automatic;
  double norm = 6;         // p of the L_p energy
  int iterations = -1;     // of L_p; -1: as the start needs, none if aligned
  int restarts = -1;       // of L_p; -1: as the start needs, none if aligned
  std::uint64_t seed = 1;  // of random choices
  // Of sizes beside right angles. Less than in the plane, whose 0.12 is for graded sizes: those of
  // surfaces are even but where others are asked for.
  double size_weight = 0.11;
  int smoothing = -1;             // iterations at the end; -1: as needed
  int max_elements = 10'000'000;  // refused beyond, before allocating
};

template <class O, class F>
requires std::is_same_v<std::remove_const_t<O>, SurfaceOptions>
void each_field(O& o, F&& visit) {
  visit("size", o.size,
        OptionInfo{0, 1e300, "length", "Target edge length; 0 gives about 3000 quads.",
                   ErrorCode::bad_size});
  visit("quads", o.quads,
        OptionInfo{0, 100'000'000, "",
                   "About how many quads, in place of a size, which is chosen for them; 0 = not "
                   "asked."});
  visit("featureAngle", o.feature_angle,
        OptionInfo{0, 180, "degrees", "Edges that bend by more are kept as edges of the mesh."});
  visit("keepGroups", o.keep_groups,
        OptionInfo{0, 1, "", "Borders between the groups of the file are kept as edges."});
  visit("turn", o.turn,
        OptionInfo{0, 90, "degrees",
                   "Smaller quads where the surface would turn by more over one; 0 = not asked."});
  visit("growth", o.growth, OptionInfo{0, 10, "", "Largest slope of the size field; 0 is 0.3."});
  visit("weld", o.weld,
        OptionInfo{0, 0.01, "", "Points nearer than this share of the diagonal become one."});
  visit("method", o.method,
        OptionInfo{0, 1, "",
                   "best: the chain of stages that measures best; paper: isotropic start, L_p, "
                   "Blossom, smoothing, in every chart, and nothing after."});
  each_lp_field(o, visit);
  visit("seed", o.seed, OptionInfo{0, 9007199254740991.0, "", "Seed of random choices."});
  visit("sizeWeight", o.size_weight,
        OptionInfo{0, 10, "",
                   "What keeping to the target size is worth beside right angles; with 0 only the "
                   "angles count."});
  visit(
      "smoothing", o.smoothing,
      OptionInfo{-1, 10000, "", "Iterations of the final smoothing; -1 leaves it to the mesher."});
  visit("maxElements", o.max_elements,
        OptionInfo{1, 100'000'000, "",
                   "Refuse before allocating when more elements than this are expected."});
}

/// What the planar chain of one chart is asked for. Never high effort: what charts settle on the
/// union must undo (with it mean eta is 0.003 lower, of eight shapes).
Options chart_options(const SurfaceOptions& options);
/// For windows of the union: the same, with the caller's effort.
Options window_options(const SurfaceOptions& options);

}  // namespace lpq
