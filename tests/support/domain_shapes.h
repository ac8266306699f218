// Small inputs for the tests of the door.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "domain/domain.h"

namespace lpq_test {

inline lpq::Loop rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline lpq::DomainInput one_region(std::vector<lpq::Loop> loops) {
  lpq::DomainInput input;
  input.regions.push_back({"", std::move(loops), {}});
  return input;
}

inline lpq::DomainInput regions_of(std::vector<std::vector<lpq::Loop>> regions) {
  lpq::DomainInput input;
  for (auto& loops : regions)
    input.regions.push_back({"r" + std::to_string(input.regions.size()), std::move(loops), {}});
  return input;
}

/// A square with a diamond hole and a triangular one: no two loops alike.
inline lpq::DomainInput square_with_holes() {
  return one_region(
      {rectangle(0, 0, 10, 10), {{2, 3}, {3, 2}, {4, 3}, {3, 4}}, {{6, 6}, {8, 6.5}, {7, 8}}});
}

}  // namespace lpq_test
