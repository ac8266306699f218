// See json_roles.h.
#include "io/domain/json_roles.h"

namespace lpq::json_domain {

Role child_role(Role parent, const std::string& key) {
  switch (parent) {
    case Role::document:
      if (key == "loops") return Role::loop_list;
      if (key == "tags") return Role::tag_table;
      if (key == "regions") return Role::region_list;
      if (key == "polylines") return Role::polyline_list;
      if (key == "points") return Role::point_list;
      if (key == "h") return Role::size;
      if (key == "sizes") return Role::size_list;
      if (key == "guides") return Role::guide_list;
      if (key == "seedPoints") return Role::seed_list;
      return Role::ignored;
    case Role::region:
      if (key == "name") return Role::name;
      if (key == "loops") return Role::loop_list;
      if (key == "tags") return Role::tag_table;
      return Role::ignored;
    case Role::polyline:
      if (key == "points") return Role::loop;
      if (key == "tag") return Role::name;
      return Role::ignored;
    case Role::point:
      if (key == "position") return Role::position;
      if (key == "tag") return Role::name;
      return Role::ignored;
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
