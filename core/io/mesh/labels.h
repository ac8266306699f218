// Names for formats that allow letters, digits and '_' only, and tell no upper from lower case.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/unique_names.h"

namespace lpq {

class Labels {
 public:
  explicit Labels(std::size_t longest) : names_(longest, UniqueNames::Case::does_not) {}

  /// `name` with every other character as '_', a letter in front, at most `longest` characters,
  /// and a number behind where that has been given before ("steel_2"). Case is kept.
  std::string add(std::string_view name);

 private:
  UniqueNames names_;
};

}  // namespace lpq
