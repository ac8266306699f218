#include "base/few_warnings.h"

namespace lpq {

std::vector<Warning> FewWarnings::take() {
  if (count_ > most)
    kept_.push_back(
        {kept_.back().code, "And " + std::to_string(count_ - most) + " more of this kind.", {}});
  count_ = 0;
  return std::exchange(kept_, {});
}

}  // namespace lpq
