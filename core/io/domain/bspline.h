// B-spline curves as CAD programs store them.
#pragma once

#include <vector>

#include "geometry/box.h"

namespace lpq {

struct BSpline {
  int degree = 3;
  std::vector<double> knots;  // #control + degree + 1, not decreasing
  std::vector<Vec2> control;
  std::vector<double> weights;  // #control, positive; empty: all 1
};

inline constexpr int largest_degree = 15;

/// Null if the spline is well formed, else what is wrong with it, as a clause.
const char* spline_problem(const BSpline& spline);

/// The point at a parameter between knots[degree] and knots[#control] [de Boor].
Vec2 spline_point(const BSpline& spline, double u);

void extend(Box& box, const BSpline& spline);

/// Appends a polyline from the first to the last parameter. Every span between knots is halved
/// until the curve at a quarter, half and three quarters lies within the tolerance of the chord.
void flatten(const BSpline& spline, double tolerance, std::vector<Vec2>& polyline,
             std::vector<double>* bows = nullptr);

/// The tangents (per parameter) of the natural cubic spline through the points, with the chords'
/// lengths as parameter steps; `lengths` are those steps, all positive.
std::vector<Vec2> natural_spline_tangents(const std::vector<Vec2>& points,
                                          const std::vector<double>& lengths);

}  // namespace lpq
