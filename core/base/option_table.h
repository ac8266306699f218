// The option table convention: every option struct has one function
//
//   template <class O, class F> void each_field(O& options, F&& visit)
//
// that calls visit(name, member, OptionInfo) for each option, in order. From it come the command
// line, its help, range checks, JSON dumps, JavaScript parsing and the playground's panel.
// Names are lowerCamel; the command line turns them into --kebab-case.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <type_traits>

#include "base/result.h"
#include "base/words.h"

namespace lpq {

struct OptionInfo {
  double min = 0, max = 0;  // inclusive range of a number; unused for flags and choices
  const char* unit = "";    // "length" = the caller's unit of length
  const char* help = "";    // one sentence
  ErrorCode beyond = ErrorCode::bad_option;  // what a number out of the range is
};

/// Specialise for every enum used as an option: the names of its values, in order.
template <class E>
struct ChoiceNames;

template <class E>
const char* choice_name(E value) {
  return ChoiceNames<E>::names[static_cast<std::size_t>(value)];
}

/// The error of code `beyond` if the value is out of the inclusive range, or NaN.
inline Problem judge_range(const char* name, double value, double min, double max,
                           ErrorCode beyond) {
  if (value >= min && value <= max) return std::nullopt;
  return Error{beyond,
               std::string("Option ") + name + " is " + short_number(value) +
                   ", but it must lie between " + short_number(min) + " and " + short_number(max) +
                   ".",
               {}};
}

/// First option out of range (or NaN, or no value of its enum), if any.
template <class O>
Problem check_ranges(const O& options) {
  Problem bad;
  each_field(options, [&](const char* name, const auto& value, const OptionInfo& info) {
    using T = std::remove_cvref_t<decltype(value)>;
    if (bad) return;
    if constexpr (std::is_enum_v<T>)
      bad = judge_range(name, static_cast<double>(static_cast<int>(value)), 0,
                        static_cast<double>(ChoiceNames<T>::names.size() - 1), info.beyond);
    else if constexpr (!std::is_same_v<T, bool>)
      bad = judge_range(name, static_cast<double>(value), info.min, info.max, info.beyond);
  });
  return bad;
}

}  // namespace lpq
