// The size that gives the number of quads which was asked for.
#pragma once

#include "base/function_ref.h"
#include "base/result.h"

namespace lpq {

struct SizeForCount {
  double size = 0;
  double quads = 0;  // that it asks for
};

/// The size whose `quads_of(size)` is nearest to `wanted`, > 0, and within 1 % of it where there is
/// one; `first` is where the search begins, and none is larger than `largest`.
/// Outlines, borders and sizes at points ask for quads A of their own, the rest for B / size^2: by
/// the secant method, in 1 / size^2. Errors: those of `quads_of`, called twelve times at most.
Result<SizeForCount> size_for_count(double first, double largest, double wanted,
                                    FunctionRef<Result<double>(double)> quads_of);

/// What to say of so many where they are no good answer; nothing where they are one.
Problem judge_count(double quads, double wanted);

}  // namespace lpq
