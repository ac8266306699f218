// See json_roles.h.
#include "io/domain/json_roles.h"

#include <vector>

#include "base/nearest_name.h"

namespace lpq::json_domain {

namespace {

struct Member {
  Role parent;
  const char* key;
  Role role;
};
constexpr Member members[] = {{Role::document, "loops", Role::loop_list},
                              {Role::document, "tags", Role::tag_table},
                              {Role::document, "regions", Role::region_list},
                              {Role::document, "polylines", Role::polyline_list},
                              {Role::document, "points", Role::point_list},
                              {Role::document, "h", Role::size},
                              {Role::document, "sizes", Role::size_list},
                              {Role::document, "guides", Role::guide_list},
                              {Role::document, "seedPoints", Role::seed_list},
                              {Role::region, "name", Role::name},
                              {Role::region, "loops", Role::loop_list},
                              {Role::region, "tags", Role::tag_table},
                              {Role::polyline, "points", Role::loop},
                              {Role::polyline, "tag", Role::name},
                              {Role::point, "position", Role::position},
                              {Role::point, "tag", Role::name}};

}  // namespace

std::string likely_key(Role parent, const std::string& key) {
  if (parent == Role::document && (key == "size" || key == "H")) return "h";
  std::vector<std::string> known;
  for (const Member& member : members)  // any letter is one slip away from "h"
    if (member.parent == parent && member.role != Role::size) known.emplace_back(member.key);
  return nearest_name(key, known);
}

Role child_role(Role parent, const std::string& key) {
  for (const Member& member : members)
    if (member.parent == parent && key == member.key) return member.role;
  switch (parent) {
    case Role::loop_list: return Role::loop;
    case Role::loop:
    case Role::guide:
    case Role::seed_list: return Role::coordinates;
    case Role::coordinates:
    case Role::size_at:
    case Role::position: return Role::coordinate;
    case Role::region_list: return Role::region;
    case Role::tag_table: return Role::tag_list;
    case Role::tag_list: return Role::name;
    case Role::polyline_list: return Role::polyline;
    case Role::point_list: return Role::point;
    case Role::size_list: return Role::size_at;
    case Role::guide_list: return Role::guide;
    default: return Role::ignored;
  }
}

const char* expected(Role role, Kind kind) {
  const auto unless = [kind](Kind wanted, const char* text) {
    return kind == wanted ? nullptr : text;
  };
  switch (role) {
    case Role::document: return unless(Kind::object, "an object with \"loops\" or \"regions\"");
    case Role::region: return unless(Kind::object, "an object with \"loops\"");
    case Role::polyline: return unless(Kind::object, "an object with \"points\"");
    case Role::point:
      return kind == Kind::array ? nullptr
                                 : unless(Kind::object, "[x, y] or an object with \"position\"");
    case Role::coordinates:
    case Role::position: return unless(Kind::array, "a point [x, y]");
    case Role::size_at: return unless(Kind::array, "a point with its size [x, y, h]");
    case Role::loop_list:
    case Role::loop:
    case Role::region_list:
    case Role::tag_table:
    case Role::tag_list:
    case Role::polyline_list:
    case Role::point_list:
    case Role::size_list:
    case Role::guide_list:
    case Role::guide:
    case Role::seed_list: return unless(Kind::array, "an array");
    case Role::coordinate:
    case Role::size: return unless(Kind::number, "a number");
    case Role::name: return unless(Kind::string, "a string");
    case Role::ignored: return nullptr;
  }
  return nullptr;
}

}  // namespace lpq::json_domain
