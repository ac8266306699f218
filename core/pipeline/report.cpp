// See report.h.
#include "pipeline/report.h"

#include <algorithm>

namespace lpq {

SizeFidelity size_fidelity(std::vector<double> ratios) {
  if (ratios.empty()) return {};
  std::sort(ratios.begin(), ratios.end());
  double off = 0;
  for (const double r : ratios) off += std::max(r, 1 / r) - 1;
  return {.p10 = percentile(ratios, 0.1),
          .p50 = percentile(ratios, 0.5),
          .p90 = percentile(ratios, 0.9),
          .min = ratios.front(),
          .max = ratios.back(),
          .off = off / static_cast<double>(ratios.size())};
}

}  // namespace lpq
