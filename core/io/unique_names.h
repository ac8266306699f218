// Names that a format cannot hold as they are, or only so long, and that stay different in it.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lpq {

class UniqueNames {
 public:
  enum class Case { matters, does_not };

  explicit UniqueNames(std::size_t longest = std::string::npos, Case letters = Case::matters)
      : longest_(longest), letters_(letters) {}

  /// `name`, at most `longest` bytes of it, and a number behind where that has been given before
  /// ("steel_2").
  std::string add(std::string_view name);

 private:
  std::string key(const std::string& name) const;

  std::size_t longest_;
  Case letters_;
  std::map<std::string, int> given_;  // how often
};

/// Each of the names as `append` (see escape.h) writes it, all different, one for each.
std::vector<std::string> unique_names(std::span<const std::string> names,
                                      void (*append)(std::string&, std::string_view),
                                      std::size_t longest = std::string::npos);

}  // namespace lpq
