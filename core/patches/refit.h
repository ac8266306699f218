// One attempt at one patch: its outline, the plans for it, the best filling, the verdict.
#pragma once

#include <span>

#include "base/rng.h"
#include "patches/remesh.h"
#include "patches/surroundings.h"

namespace lpq {

enum class Refit {
  done,      // the patch was refilled
  rejected,  // no filling was better; a larger patch may do
  hopeless,  // this patch cannot be closed within the limit, nor can a larger one
};

/// How a filling is chosen and judged.
struct RefitRule {
  Index largest = 200;      // faces of a patch
  double temperature = 0;   // 0: only what lowers the figure of merit, and the best of all plans
  double extra_weight = 0;  // irregularity that a refill may add
  Rng* rng = nullptr;       // with it one plan is drawn
};

class Refitter {
 public:
  Refitter(QuadTopology& mesh, const IdealValence& ideal, const Fields& fields,
           const PatchOptions& options);

  PatchGrowth& patch() { return patch_; }
  /// Closes the patch and refills it if that lowers the figure of merit.
  Refit refit(const RefitRule& rule);
  /// Vertices of the last refill around which something changed.
  const std::vector<Index>& changed() const { return changed_; }
  Index tried() const { return tried_; }

 private:
  Polygon polygon() const;
  double wanted_quads() const;
  double patch_quads() const;
  std::vector<Plan> plans(const Polygon& shape, const RefitRule& rule) const;
  Trial best_trial(const Surroundings& around, const Polygon& shape, std::span<const Plan> plans,
                   double best_change);
  void commit(const Surroundings& around, const Trial& trial);

  QuadTopology& mesh_;
  const Fields& fields_;
  const PatchOptions& options_;
  PatchGrowth patch_;
  PatchOutline outline_;
  std::vector<Index> changed_;
  Index tried_ = 0;
  mutable Index hint_ = none;
};

}  // namespace lpq
