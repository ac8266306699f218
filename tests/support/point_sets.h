// Point sets for the geometric tests: in general position, on grids, on circles, from files.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/index.h"
#include "base/rng.h"
#include "geometry/vec.h"

namespace lpq_test {

using lpq::Index;
using lpq::Vec2;

inline std::vector<Vec2> random_points(int count, std::uint64_t seed) {
  lpq::Rng rng(seed);
  std::vector<Vec2> points(count);
  for (Vec2& p : points) p = {rng.unit(), rng.unit()};
  return points;
}

/// Distinct points of an integer grid [0, side)^2, in random order: full of ties.
inline std::vector<Vec2> random_grid_points(int count, int side, std::uint64_t seed) {
  std::vector<Vec2> all;
  for (int i = 0; i < side * side; ++i) all.push_back({double(i % side), double(i / side)});
  lpq::Rng rng(seed);
  for (std::size_t i = all.size(); i > 1; --i) std::swap(all[i - 1], all[rng.below(i)]);
  all.resize(std::min<std::size_t>(count, all.size()));
  return all;
}

/// The 36 integer points on the circle of radius 65, exactly cocircular.
inline std::vector<Vec2> cocircular_points() {
  std::vector<Vec2> points;
  for (int x = -65; x <= 65; ++x) {
    for (int y = -65; y <= 65; ++y) {
      if (x * x + y * y == 65 * 65) points.push_back({double(x), double(y)});
    }
  }
  return points;
}

/// All the numbers of the array that follows `key`, e.g. of "points":[[0,1],[2,3]].
inline std::vector<double> numbers_after(const std::string& text, const std::string& key) {
  std::vector<double> numbers;
  std::size_t at = text.find("\"" + key + "\"");
  if (at == std::string::npos) return numbers;
  at = text.find('[', at);
  int depth = 0;
  for (const char* c = text.c_str() + at; *c != 0;) {
    if (*c == '[') ++depth;
    if (*c == ']' && --depth == 0) break;
    if (*c == '-' || (*c >= '0' && *c <= '9')) {
      char* end = nullptr;
      numbers.push_back(std::strtod(c, &end));
      c = end;
    } else {
      ++c;
    }
  }
  return numbers;
}

inline std::vector<Vec2> points_after(const std::string& text, const std::string& key) {
  const std::vector<double> numbers = numbers_after(text, key);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    points.push_back({numbers[i], numbers[i + 1]});
  }
  return points;
}

inline std::vector<Vec2> without_duplicates(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace lpq_test
