// See report.h.
#include "pipeline/report.h"

#include <algorithm>
#include <utility>

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

Report without_attempt(Report report) {
  Report whole;
  whole.boundary_nodes = report.boundary_nodes;
  whole.boundary_edges = report.boundary_edges;
  whole.singularities = std::move(report.singularities);
  whole.attempts = report.attempts;
  whole.simplify_deviation = report.simplify_deviation;
  whole.times = std::move(report.times);
  whole.warnings = std::move(report.warnings);
  return whole;
}

}  // namespace lpq
