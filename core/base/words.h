// Pieces of sentences that several rooms say.
#pragma once

#include <string>

#include "base/result.h"

namespace lpq {

/// A number in a sentence: six digits, no zeros to fill up.
std::string short_number(double value);

/// "(1, 0.5, -2)", in the caller's units.
std::string place_in_space(double x, double y, double z);

/// The refusal of a mesh of about `needed` elements, with what to do.
Error too_many_elements(double needed, double limit);

}  // namespace lpq
