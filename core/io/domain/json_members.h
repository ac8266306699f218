// The members of the objects of a JSON domain: none twice, and a word where a key looks like one
// that is missing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/few_warnings.h"
#include "io/domain/json_roles.h"

namespace lpq {
class JsonText;
}

namespace lpq::json_domain {

class Members {
 public:
  void open(Role role) { objects_.push_back({role, 0, {}}); }
  /// The next key of the innermost object or array; false if it has a known one twice.
  bool add(const std::string& key, const JsonText& text);
  void close();
  /// After the last close().
  std::vector<Warning> take_warnings() { return warnings_.take(); }

 private:
  struct Slip {
    std::string key, known;
    Where where;
  };
  struct Object {
    Role role;
    std::uint32_t seen = 0;  // roles of the members, a bit each
    std::vector<Slip> slips;
  };

  std::vector<Object> objects_;
  FewWarnings warnings_;
  int looked_up_ = 0;
};

}  // namespace lpq::json_domain
