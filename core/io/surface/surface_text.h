// Small things that the text readers of surfaces share.
#pragma once

#include <string>
#include <string_view>

#include "geometry/vec3.h"
#include "io/number.h"
#include "io/text_lines.h"

namespace lpq {

/// Whether a word is a number that is not finite, as printf and many programs write it.
bool is_not_finite_word(std::string_view word);

/// " Write decimals with a point: ...", where a word that is no number has a comma in it; else "".
std::string advice_on_comma(std::string_view word);

/// Of a face's corner, as the file numbers vertices: `count` of them, from `first` on.
Error unknown_vertex(std::int64_t number, std::int64_t count, std::int64_t first);

/// words[at], words[at + 1], words[at + 2] as a point. False with code and sentence otherwise;
/// `what` is "A vertex" or the like.
bool read_point(const Words& words, std::size_t at, const char* what, Vec3& point, Error& error);

/// "one two" from the words from `first` on.
std::string joined_words(const Words& words, std::size_t first);

}  // namespace lpq
