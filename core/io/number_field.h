// Numbers for formats that give them a column of so many characters.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lpq {

/// Appends `value` with a decimal point in at most `width` >= 8 characters: as append_number's
/// digits where they fit, so that the same double is read back, else with as many digits as fit,
/// correctly rounded. `exponent_mark` is "e", or "" for the form 1.5-3 of Fortran and Nastran.
void append_number_field(std::string& out, double value, std::size_t width,
                         std::string_view exponent_mark);

}  // namespace lpq
