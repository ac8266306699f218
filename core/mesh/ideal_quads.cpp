#include "mesh/ideal_quads.h"

#include "numerics/elementary.h"

namespace lpq {

Index ideal_quads(double angle) {
  Index k = 1;
  while (angle * (2 * k + 1) > pi * k * (k + 1)) ++k;
  return k;
}

}  // namespace lpq
