// One sentence for what would be more than the caller allows.
#pragma once

#include "base/fields.h"
#include "base/result.h"

namespace lpq {

inline Error too_many_elements(double needed, double limit) {
  return {ErrorCode::too_many_elements,
          "About " + short_number(needed) + " elements would be needed, more than the limit of " +
              std::to_string(static_cast<long long>(limit)) +
              ". Use a larger size or raise maxElements.",
          {}};
}

}  // namespace lpq
