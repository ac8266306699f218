// Seeds by the packing alone, which fills what aligned seeds leave empty.
#pragma once

#include <span>
#include <vector>

#include "lpcvt/packing.h"
#include "lpcvt/seeds.h"

namespace lpq::test {

/// From walls and existing points inward along both axes.
inline std::vector<Vec2> packed_seeds(const BoundaryMesh& boundary, const Fields& fields,
                                      std::span<const Vec2> existing,
                                      const SeedOptions& options = {}) {
  Packing packing(boundary, fields);
  Index hint = none;
  for (const Vec2 p : existing) {
    const double h = fields.size(p, hint);
    packing.add(p, h, hint);
  }
  PackingRule rule;
  rule.max_points = options.max_points;
  pack_inward(boundary, fields, WallDistance(boundary, fields), rule, packing);
  return packing.interior();
}

}  // namespace lpq::test
