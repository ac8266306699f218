// See report.h.
#include "pipeline/report.h"

#include <algorithm>

namespace lpq {

SizeFidelity size_fidelity(std::vector<double> ratios) {
  if (ratios.empty()) return {};
  std::sort(ratios.begin(), ratios.end());
  return {percentile(ratios, 0.1), percentile(ratios, 0.5), percentile(ratios, 0.9), ratios.front(),
          ratios.back()};
}

}  // namespace lpq
