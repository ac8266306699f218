#include "cleanup/cleanup.h"

#include <utility>

#include "cleanup/darts.h"
#include "cleanup/disk_patterns.h"
#include "cleanup/ideal_valence.h"
#include "cleanup/shape_energy.h"
#include "cleanup/smooth.h"
#include "cleanup/topology.h"
#include "cleanup/untangle.h"

namespace lpq {

namespace {

constexpr int steps_before = 20;  // of smoothing, before the local operations

Index count_invalid(const QuadMesh& mesh) { return static_cast<Index>(invalid_faces(mesh).size()); }

// With fewer, nearly every corner is fixed, and tries are for nothing.
constexpr std::size_t fewest_faces = 16;

// Always the same, and made once: a surface may have a thousand small charts.
DiskPatterns& kept_patterns(PatternSet set) {
  thread_local DiskPatterns regular(PatternSet::regular), repair(PatternSet::repair);
  return set == PatternSet::regular ? regular : repair;
}

// Doublets, positions, and where these do not suffice new connectivity: until all faces are valid.
void make_valid(CleanupResult& result, const Fields& fields) {
  QuadTopology doublets(std::move(result.mesh));
  remove_doublets(doublets);
  result.mesh = std::move(doublets).compact();
  untangle(result.mesh);
  if (count_invalid(result.mesh) == 0) return;
  QuadTopology topology(std::move(result.mesh));
  const IdealValence ideal(topology);
  repair_invalid(topology, ideal, fields, kept_patterns(PatternSet::repair));
  result.mesh = std::move(topology).compact();
  untangle(result.mesh);
}

// Fewer irregular vertices. The shapes are smoothed first, so that what a refill would do to them
// is compared with what they can be, not with what the matching left.
void make_regular(CleanupResult& result, const Fields& fields, SmoothOptions smoothing) {
  smoothing.iterations = steps_before;
  smoothing.rounding = coarse_rounding;
  smooth_eta(result.mesh, fields, smoothing);
  QuadTopology topology(std::move(result.mesh));
  const IdealValence ideal(topology);
  regularise(topology, ideal, fields, kept_patterns(PatternSet::regular));
  result.mesh = std::move(topology).compact();
}

// What regularity could not mend for the price, at any price.
void mend_shapes(CleanupResult& result, const Fields& fields) {
  if (result.mesh.faces.size() < fewest_faces) return;
  QuadTopology topology(std::move(result.mesh));
  const IdealValence ideal(topology);
  mend_flat(topology, ideal, fields, kept_patterns(PatternSet::repair));
  result.mesh = std::move(topology).compact();
}

void cut_what_is_left(CleanupResult& result) {
  QuadTopology topology(std::move(result.mesh));
  cut_darts(topology);
  result.mesh = std::move(topology).compact();
}

}  // namespace

CleanupResult clean_up(QuadMesh mesh, const Fields& fields, const CleanupOptions& options) {
  const SmoothOptions smoothing{.iterations = options.smoothing_iterations,
                                .size_weight = options.size_weight,
                                .eta_floor = options.eta_floor,
                                .rounding = options.rounding};
  CleanupResult result;
  result.mesh = std::move(mesh);
  make_valid(result, fields);
  if (options.topology) make_regular(result, fields, smoothing);
  if (options.topology) mend_shapes(result, fields);
  // Other connectivity, other chances.
  if (options.topology && count_invalid(result.mesh) > 0) make_valid(result, fields);
  if (options.cut_darts && count_invalid(result.mesh) > 0) cut_what_is_left(result);
  result.stats.still_invalid = count_invalid(result.mesh);
  if (result.stats.still_invalid > 0) return result;  // not worth polishing
  smooth_eta(result.mesh, fields, smoothing);
  result.stats.still_invalid = count_invalid(result.mesh);
  return result;
}

}  // namespace lpq
