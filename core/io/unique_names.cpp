// See unique_names.h.
#include "io/unique_names.h"

#include "io/escape.h"
#include "io/number.h"
#include "io/plain_text.h"

namespace lpq {

std::string UniqueNames::key(const std::string& name) const {
  return letters_ == Case::matters ? name : lower_case(name);
}

std::string UniqueNames::add(std::string_view name) {
  const std::string plain(utf8_start(name, longest_));
  const auto [entry, is_new] = given_.try_emplace(key(plain), 1);
  if (is_new) return plain;
  std::string numbered;
  do {
    std::string tail = "_";
    append_integer(tail, ++entry->second);
    numbered = std::string(utf8_start(plain, longest_ - tail.size())) + tail;
  } while (!given_.try_emplace(key(numbered), 1).second);
  return numbered;
}

std::vector<std::string> unique_names(std::span<const std::string> names,
                                      void (*append)(std::string&, std::string_view),
                                      std::size_t longest) {
  UniqueNames unique(longest);
  std::vector<std::string> written;
  for (const std::string& name : names) {
    std::string plain;
    append(plain, name);
    written.push_back(unique.add(plain));
  }
  return written;
}

}  // namespace lpq
