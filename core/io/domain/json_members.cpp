// See json_members.h.
#include "io/domain/json_members.h"

#include "io/json_text.h"

namespace lpq::json_domain {
namespace {

std::uint32_t bit_of(Role role) { return std::uint32_t{1} << static_cast<unsigned>(role); }

}  // namespace

bool Members::add(const std::string& key, const JsonText& text) {
  constexpr int most_looked_up = 1000;
  Object& object = objects_.back();
  const Role role = child_role(object.role, key);
  if (role != Role::ignored) {
    const bool is_new = (object.seen & bit_of(role)) == 0;
    object.seen |= bit_of(role);
    return is_new;
  }
  if (object.role == Role::ignored || looked_up_ >= most_looked_up) return true;
  ++looked_up_;
  std::string known = likely_key(object.role, key);
  if (!known.empty())
    object.slips.push_back({key, std::move(known), text.error(ErrorCode::parse_error, {}).where});
  return true;
}

void Members::close() {
  for (const Slip& slip : objects_.back().slips) {
    const std::uint32_t bit = bit_of(child_role(objects_.back().role, slip.known));
    if ((objects_.back().seen & bit) != 0) continue;
    warnings_.add({ErrorCode::ignored,
                   "The key \"" + slip.key + "\" is not known and was ignored; did you mean \"" +
                       slip.known + "\"?",
                   slip.where});
  }
  objects_.pop_back();
}

}  // namespace lpq::json_domain
