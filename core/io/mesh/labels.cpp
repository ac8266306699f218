// See labels.h.
#include "io/mesh/labels.h"

#include "io/escape.h"
#include "io/plain_text.h"

namespace lpq {
std::string Labels::add(std::string_view name) {
  std::string plain;
  append_ascii(plain, name, "_");
  for (char& c : plain)
    if (!is_letter(c) && !is_digit(c)) c = '_';
  if (plain.empty() || !is_letter(plain[0])) plain.insert(0, "n_");
  return names_.add(plain);
}

}  // namespace lpq
