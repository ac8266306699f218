// How many edges every curve gets.
#pragma once

#include <span>
#include <vector>

#include "surface/curves.h"
#include "surface/side_balance.h"

namespace lpq {

/// `steps` is int ds/h of each curve. #C
std::vector<Index> curve_counts(const SurfaceCurves& curves, Index face_count,
                                std::span<const double> steps, const CountSums& sums);

/// Edges around every face, both sides of a curve inside it counted. #faces
std::vector<Index> face_counts(const SurfaceCurves& curves, Index face_count,
                               std::span<const Index> counts);

}  // namespace lpq
