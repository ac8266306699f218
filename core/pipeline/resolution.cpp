// See resolution.h.
#include "pipeline/resolution.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/words.h"

namespace lpq {

double least_resolved(const Domain& domain) {
  constexpr double least_steps = 16;  // between neighbouring coordinates
  double largest = 0;
  for (const Vec2 p : domain.points) {
    const Vec2 world = domain.frame.to_world(p);
    largest = std::max({largest, std::abs(world.x), std::abs(world.y)});
  }
  return least_steps * domain.frame.length_to_frame(largest) *
         std::numeric_limits<double>::epsilon();
}

Error unresolved_size(double size) {
  return {ErrorCode::lost_precision,
          "Beside coordinates this far from the origin, doubles cannot hold a mesh of size " +
              short_number(size) + ". Move the domain closer to the origin, or use a larger size.",
          {}};
}

}  // namespace lpq
