// What parts of surfaces and their maps to the plane must be.
#pragma once

#include "surface/charts/checks.h"
#include "surface/charts/part.h"

namespace lpq_test {

inline bool is_disk(const lpq::Part& part) { return part.loops.rows() == 1 && part.genus() == 0; }

inline bool is_injective(const lpq::MapCheck& check) {
  return check.flipped == 0 && !check.crossing;
}

}  // namespace lpq_test
