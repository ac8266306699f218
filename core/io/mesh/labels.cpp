// See labels.h.
#include "io/mesh/labels.h"

#include <algorithm>

#include "io/escape.h"
#include "io/number.h"

namespace lpq {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace

std::string Labels::add(std::string_view name) {
  std::string plain;
  append_ascii(plain, name, "_");
  for (char& c : plain)
    if (!is_letter(c) && !(c >= '0' && c <= '9')) c = '_';
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
