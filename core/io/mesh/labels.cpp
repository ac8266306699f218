// See labels.h.
#include "io/mesh/labels.h"

#include <algorithm>

#include "io/escape.h"
#include "io/number.h"
#include "io/plain_text.h"

namespace lpq {
std::string Labels::add(std::string_view name) {
  std::string plain;
  append_ascii(plain, name, "_");
  for (char& c : plain)
    if (!is_letter(c) && !is_digit(c)) c = '_';
  if (plain.empty() || !is_letter(plain[0])) plain.insert(0, "n_");
  plain.resize(std::min(plain.size(), longest_));
  const auto [entry, is_new] = given_.try_emplace(lower_case(plain), 1);
  if (is_new) return plain;
  std::string label;
  do {
    std::string tail = "_";
    append_integer(tail, ++entry->second);
    label = plain.substr(0, longest_ - tail.size()) + tail;
  } while (!given_.try_emplace(lower_case(label), 1).second);
  return label;
}

}  // namespace lpq
