// Initial interior points: the paper's ordinary isotropic start, the aligned one, the caller's own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "domain/boundary.h"
#include "field/field.h"

namespace lpq {

struct SeedOptions {
  std::uint64_t seed = 1;  // of the isotropic start's jitter
  double jitter = 0.05;    // in units of h, isotropic start
  double clearance = 0.4;  // least distance to a wall in units of h
  Index max_points = 20'000'000;
};

/// Points expected inside: the quads that fit, int dA/h^2, counted by vertices: N = Q - B/2 + chi.
double expected_interior_points(const BoundaryMesh& boundary, const Fields& fields);

/// Well-spaced, isotropic (paper Fig. 2), graded by h, count fitted to expected_interior_points.
std::vector<Vec2> isotropic_seeds(const BoundaryMesh& boundary, const Fields& fields,
                                  const SeedOptions& options = {});

/// Integer points of a phase field aligned with the crosses (one sparse solve, [Ray et al. 2006]),
/// holes filled by packing.
std::vector<Vec2> aligned_seeds(const BoundaryMesh& boundary, const Fields& fields,
                                const SeedOptions& options = {});

/// The caller's own start: those of `points` that lie inside, apart from the walls and from each
/// other. Cost O(n log n).
std::vector<Vec2> given_seeds(const BoundaryMesh& boundary, const Fields& fields,
                              std::span<const Vec2> points);

}  // namespace lpq
