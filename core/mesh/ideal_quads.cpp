#include "mesh/ideal_quads.h"

#include "numerics/elementary.h"

namespace lpq {

Index ideal_quads(double angle) {
  Index k = 1;
  while (angle * (2 * k + 1) > pi * k * (k + 1)) ++k;
  return k;
}

double fitting_quads(double angle) {
  const double quarters = angle / (pi / 2);
  const auto k = static_cast<double>(static_cast<Index>(quarters));
  const double change = 2 * k * (k + 1) / (2 * k + 1);
  const double half = quarters < change ? 0.5 * (quarters - k) / (change - k)
                                        : 0.5 + 0.5 * (quarters - change) / (k + 1 - change);
  return k + half;
}

bool is_hollow_bend(double angle) {
  constexpr double least_bend = 33 * pi / 180, most_bend = 64 * pi / 180;
  return angle >= pi + least_bend && angle <= pi + most_bend;
}

bool is_in_hollow_bend(double before, double angle, double after) {
  return is_hollow_bend(before) && is_hollow_bend(angle) && is_hollow_bend(after);
}

}  // namespace lpq
