// Elementary functions whose bits are the same on every platform. The C library's differ between
// native and WebAssembly builds in the last place, and some of these values decide topology
// (matching costs, phases), so we compute them with + - * / sqrt alone.
#pragma once

namespace lpq {

struct SinCos {
  double sin, cos;
};

/// |x| < 1e5; within 1 ulp or so of the true value.
SinCos sin_cos(double x);
/// Angle of (x, y) in (-pi, pi]; 0 for (0, 0).
double arc_tangent(double y, double x);
/// e^x for |x| < 700.
double exponential(double x);
/// Natural logarithm of x > 0, finite.
double logarithm(double x);

inline constexpr double pi = 3.14159265358979323846;

inline double cos_degrees(double angle) { return sin_cos(angle * (pi / 180)).cos; }

}  // namespace lpq
