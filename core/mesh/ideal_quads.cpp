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

}  // namespace lpq
