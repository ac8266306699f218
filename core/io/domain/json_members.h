// The members of the objects of a JSON domain: none twice, and a word where a key looks like one
// that is missing, or holds what may be meant for the mesh: points or a size. Other members are
// notes.
#pragma once

#include <cstddef>
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
  void open(Role role);
  /// The next key of the innermost object or array; false if it has a known one twice.
  bool add(const std::string& key, const JsonText& text);
  /// The next value, where its role is `ignored`; its number from 1 if it is in an array, else 0.
  void add_unknown(Kind kind, std::size_t element);
  void close(const JsonText& text);
  /// After the last close().
  std::vector<Warning> take_warnings() { return warnings_.take(); }

 private:
  struct Slip {
    std::string key, known;  // known: "" if it looks like none
    std::ptrdiff_t byte;
    bool is_meant = false;  // its value tells
  };
  struct Object {
    Role role;
    std::uint32_t seen = 0;  // roles of the members, a bit each
    std::vector<Slip> slips;
  };

  std::vector<Object> objects_;
  FewWarnings warnings_;
  std::size_t ignored_depth_ = 0;     // objects and arrays within the last slip
  int looked_up_ = 0, in_parts_ = 0;  // keys of the document, and of what is in it
  bool is_slip_ = false;              // the member being read is one
};

}  // namespace lpq::json_domain
