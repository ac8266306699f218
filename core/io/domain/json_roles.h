// What every value of a JSON domain is for, and which kinds of value may be that.
#pragma once

#include <string>

namespace lpq::json_domain {

enum class Role {
  document,
  ignored,
  loop_list,
  loop,
  coordinates,
  coordinate,
  region_list,
  region,
  tag_table,
  tag_list,
  polyline_list,
  polyline,
  point_list,
  point,
  position,
  size_list,
  size_at,
  guide_list,
  guide,
  seed_list,
  size,
  name,
};
enum class Kind { object, array, number, string, other };

/// The role of a member `key` of an object, or of an element of an array (key empty).
Role child_role(Role parent, const std::string& key);

/// The member that a key of an object may be meant to be, "" if it looks like none.
std::string likely_key(Role parent, const std::string& key);

/// In words for an error, where a value of the role must not be of that kind; else null.
const char* expected(Role role, Kind kind);

}  // namespace lpq::json_domain
