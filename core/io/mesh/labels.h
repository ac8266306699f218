// Names for formats that allow letters, digits and '_' only, and tell no upper from lower case.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace lpq {

class Labels {
 public:
  explicit Labels(std::size_t longest) : longest_(longest) {}

  /// `name` with every other character as '_', a letter in front, at most `longest` characters,
  /// and a number behind where that has been given before ("steel_2"). Case is kept.
  std::string add(std::string_view name);

 private:
  std::size_t longest_;
  std::map<std::string, int> given_;  // in lower case; how often
};

}  // namespace lpq
