// See size_for_count.h.
#include "field/size_for_count.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/words.h"

namespace lpq {
namespace {

constexpr int most_trials = 12;
constexpr double close = 0.01;       // of the number wanted
constexpr double tolerable = 0.2;    // likewise; told beyond
constexpr double longest_step = 16;  // of 1 / size^2, as a factor

}  // namespace

Result<SizeForCount> size_for_count(double first, double largest, double wanted,
                                    FunctionRef<Result<double>(double)> quads_of) {
  const double least = 1 / (largest * largest);  // of x = 1 / size^2
  double x = std::max(1 / (first * first), least), before = 0, quads_before = 0;
  SizeForCount best;
  for (int trial = 0; trial < most_trials; ++trial) {
    const double size = 1 / std::sqrt(x);
    const Result<double> quads = quads_of(size);
    if (!quads) return quads.error();
    if (trial == 0 || std::abs(*quads - wanted) < std::abs(best.quads - wanted))
      best = {size, *quads};
    if (std::abs(*quads - wanted) <= close * wanted) break;
    // None of its own (A = 0) until a second point is known, or where the points tell nothing.
    const double slope = (*quads - quads_before) / (x - before);
    const double next = slope > 0 ? x + (wanted - *quads) / slope : x * wanted / *quads;
    before = x, quads_before = *quads;
    x = std::max(std::clamp(next, x / longest_step, x * longest_step), least);
    if (x == before) break;
  }
  return best;
}

Problem judge_count(double quads, double wanted) {
  if (std::abs(quads - wanted) <= tolerable * wanted) return std::nullopt;
  const bool more = quads > wanted;
  return Error{ErrorCode::adapted,
               "About " + short_number(std::round(quads)) + " quads instead of " +
                   short_number(wanted) + ": " +
                   (more ? "details, bends or sizes that are given ask for so many by themselves."
                         : "grids, outlines or sizes that are given come no nearer."),
               {}};
}

}  // namespace lpq
