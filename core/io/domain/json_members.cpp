// See json_members.h.
#include "io/domain/json_members.h"

#include "io/json_text.h"
#include "io/plain_text.h"

namespace lpq::json_domain {
namespace {

std::uint32_t bit_of(Role role) { return std::uint32_t{1} << static_cast<unsigned>(role); }

/// Whether what begins so tells about the domain, whatever its value is.
bool is_note(const std::string& key) {
  if (key.empty() || !is_letter(key[0])) return true;
  for (const char* start : {"meta", "note", "comment", "propert", "descri", "warning"})
    if (lower_case(key).find(start) == 0) return true;
  return false;
}

bool is_size(const std::string& key) {
  const std::string word = lower_case(key);
  if (word == "h" || word == "lc") return true;
  for (const char* part : {"size", "hmax", "maxh", "hmin", "minh"})
    if (word.find(part) != std::string::npos) return true;
  return false;
}

/// What is done instead, for a key that looks like no known one.
const char* advice(Role parent, const std::string& key) {
  if (lower_case(key).find("hole") == 0) return "; holes are further loops of \"loops\".";
  if (!is_size(key)) return ".";
  return parent == Role::document
             ? "; the size of the mesh is \"h\"."
             : "; sizes at places are given in \"sizes\" of the document: [[x, y, h], ..].";
}

}  // namespace

void Members::open(Role role) {
  objects_.push_back({role, 0, {}});
  if (role == Role::ignored) ++ignored_depth_;
}

bool Members::add(const std::string& key, const JsonText& text) {
  constexpr int most_looked_up = 1000;
  constexpr std::size_t most_letters = 60;
  Object& object = objects_.back();
  if (object.role == Role::ignored) return true;
  const Role role = child_role(object.role, key);
  is_slip_ = false;
  if (role != Role::ignored) {
    const bool is_new = (object.seen & bit_of(role)) == 0;
    object.seen |= bit_of(role);
    return is_new;
  }
  int& looked_up = object.role == Role::document ? looked_up_ : in_parts_;
  if (looked_up >= most_looked_up) return true;
  ++looked_up;
  is_slip_ = true;
  object.slips.push_back({key.substr(0, most_letters), likely_key(object.role, key), text.byte()});
  return true;
}

// Metadata are words, counts and lists of these; what is meant for the mesh is a size, or points:
// arrays in an array, objects in one, or the coordinates of three points at least.
void Members::add_unknown(Kind kind, std::size_t element) {
  constexpr std::size_t fewest_coordinates = 6;
  if (!is_slip_) return;
  Slip& slip = objects_[objects_.size() - 1 - ignored_depth_].slips.back();
  if (ignored_depth_ == 0) {
    slip.is_meant = kind == Kind::number && is_size(slip.key);
  } else if (element > 0 && !slip.is_meant) {
    slip.is_meant = kind == Kind::array || kind == Kind::object ||
                    (kind == Kind::number && ignored_depth_ == 1 && element >= fewest_coordinates);
  }
}

void Members::close(const JsonText& text) {
  const Object& object = objects_.back();
  if (object.role == Role::ignored) --ignored_depth_;
  for (const Slip& slip : object.slips) {
    const bool is_like =
        !slip.known.empty() && (object.seen & bit_of(child_role(object.role, slip.known))) == 0;
    if (!is_like && (!slip.is_meant || is_note(slip.key))) continue;
    warnings_.add(text.error(
        ErrorCode::ignored,
        "The key \"" + slip.key + "\" is not known and was ignored" +
            (is_like ? "; did you mean \"" + slip.known + "\"?" : advice(object.role, slip.key)),
        slip.byte));
  }
  objects_.pop_back();
}

}  // namespace lpq::json_domain
