#include "mesh/ideal_quads.h"

#include "numerics/elementary.h"

namespace lpq {

Index ideal_quads(double angle) {
  Index k = 1;
  while (angle * (2 * k + 1) > pi * k * (k + 1)) ++k;
  return k;
}

bool is_hollow_bend(double angle) {
  constexpr double least_bend = 33 * pi / 180, most_bend = 64 * pi / 180;
  return angle >= pi + least_bend && angle <= pi + most_bend;
}

bool is_in_hollow_bend(double before, double angle, double after) {
  return is_hollow_bend(before) && is_hollow_bend(angle) && is_hollow_bend(after);
}

}  // namespace lpq
