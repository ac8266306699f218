// See json_text.h.
#include "io/json_text.h"

#include <algorithm>

namespace lpq {
namespace {

/// Some programs write NaN and Infinity, which are not JSON. Outside strings they become empty
/// strings of the same width, so that places stay true; as coordinates they are refused by name.
std::string without_bare_literals(std::string_view text) {
  std::string result(text);
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (in_string && text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      in_string = !in_string;
    if (in_string) continue;
    for (const std::string_view literal : {"NaN", "-Infinity", "Infinity"}) {
      if (text.substr(i, literal.size()) != literal) continue;
      result.replace(i, literal.size(), literal.size(), ' ');
      result[i] = result[i + 1] = '"';
      i += literal.size() - 1;
      break;
    }
  }
  return result;
}

}  // namespace

JsonText::JsonText(std::string_view text)
    : text_(text), json_(without_bare_literals(text)), reached_(json_.data()) {}

bool JsonText::parse(JsonReader& reader) {
  return nlohmann::json::sax_parse(Cursor{json_.data(), &reached_},
                                   Cursor{json_.data() + json_.size(), &reached_}, &reader);
}

bool JsonText::is_bare_literal() const {
  // Where the quotes of an empty string stood, the caller's text has NaN or Infinity.
  return text_[static_cast<std::size_t>(reached_ - json_.data() - 2)] != '"';
}

std::ptrdiff_t JsonText::byte() const {
  return std::max<std::ptrdiff_t>(reached_ - json_.data() - 1, 0);
}

Error JsonText::error(ErrorCode code, std::string message, std::ptrdiff_t byte) const {
  Error error{code, std::move(message), {}};
  error.where.byte = byte;
  error.where.line = 1 + std::count(text_.data(), text_.data() + byte, '\n');
  return error;
}

}  // namespace lpq
