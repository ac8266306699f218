// See words.h.
#include "base/words.h"

#include <algorithm>
#include <cstdio>

namespace lpq {

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string place_in_space(double x, double y, double z) {
  return "(" + short_number(x) + ", " + short_number(y) + ", " + short_number(z) + ")";
}

Error too_many_elements(double needed, double limit) {
  return {ErrorCode::too_many_elements,
          "About " + short_number(std::min(1e300, needed)) +
              " elements would be needed, more than the limit of " +
              std::to_string(static_cast<long long>(limit)) +
              ". Use a larger size or raise maxElements.",
          {}};
}

}  // namespace lpq
