// Numbers to text and back: 17 digits or fewer that give the same double again, and never a comma,
// whatever locale the host program has chosen.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace lpq {

/// Appends decimal digits that read back as the same double: short where the value is a short
/// decimal fraction (0.1), else as printf's %.17g. NaN and infinities as nan, inf, -inf.
void append_number(std::string& out, double value);
void append_integer(std::string& out, std::int64_t value);
/// Numbers as append_number writes them, a blank between any two: coordinates.
void append_numbers(std::string& out, std::initializer_list<double> values);

/// Appends `value` rounded to `decimals` (0 .. 6) places, for pictures; |value| < 1e9.
void append_fixed(std::string& out, double value, int decimals);

/// The whole of `text` as a finite decimal number: [+-] digits [. digits] [e [+-] digits].
/// False for anything else: empty, nan, inf, hexadecimal, trailing characters, overflow.
bool parse_number(std::string_view text, double& value);
/// The whole of `text` as a decimal integer that fits.
bool parse_integer(std::string_view text, std::int64_t& value);

}  // namespace lpq
