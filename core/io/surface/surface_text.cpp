// See surface_text.h.
#include "io/surface/surface_text.h"

#include "io/plain_text.h"

namespace lpq {

bool is_not_finite_word(std::string_view word) {
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.remove_prefix(1);
  // Some C libraries write nan(ind) or nan(0x...), or 1.#INF.
  if (word.substr(0, 3) == "1.#") return true;
  return same_letters(word.substr(0, 3), "nan") || same_letters(word.substr(0, 3), "inf");
}

std::string advice_on_comma(std::string_view word) {
  const std::size_t comma = word.find(',');
  if (comma == std::string_view::npos || comma + 1 == word.size()) return {};
  return " Write decimals with a point: '" + std::string(word.substr(0, 40)) + "' has a comma.";
}

Error unknown_vertex(std::int64_t number, std::int64_t count, std::int64_t first) {
  std::string text = "A face names vertex " + std::to_string(number) + ", which is not there: ";
  if (count == 0) {
    text += "no vertex stands before it.";
  } else {
    text += "they are numbered from " + std::to_string(first) + " to " +
            std::to_string(first + count - 1) + ".";
  }
  return {ErrorCode::parse_error, std::move(text), {}};
}

bool read_point(const Words& words, std::size_t at, const char* what, Vec3& point, Error& error) {
  double* const coordinates[] = {&point.x, &point.y, &point.z};
  for (std::size_t k = 0; k < 3; ++k) {
    if (at + k < words.size() && parse_number(words[at + k], *coordinates[k])) continue;
    const bool not_finite = at + k < words.size() && is_not_finite_word(words[at + k]);
    error.code = not_finite ? ErrorCode::non_finite : ErrorCode::parse_error;
    error.message = what;
    error.message += not_finite ? " has a coordinate that is not finite."
                                : " needs three finite numbers: x y z.";
    if (at + k < words.size()) error.message += advice_on_comma(words[at + k]);
    return false;
  }
  return true;
}

std::string joined_words(const Words& words, std::size_t first) {
  std::string joined;
  for (std::size_t i = first; i < words.size(); ++i) {
    if (i > first) joined += ' ';
    joined += words[i];
  }
  return joined;
}

}  // namespace lpq
