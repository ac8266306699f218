// Writes what json_domain.cpp reads.
#include "io/domain/json_domain.h"
#include "io/json_write.h"

namespace lpq {
namespace {

void append_points(JsonWriter& json, std::string_view name, const std::vector<Vec2>& points) {
  if (!name.empty()) json.key(name);
  json.begin_array();
  for (const Vec2 p : points) json.tuple(p.x, p.y);
  json.end_array();
}

void append_region(JsonWriter& json, const DomainInput::Region& region) {
  json.begin_object();
  json.member("name", region.name);
  json.begin_array("loops");
  for (const Loop& loop : region.loops) {
    if (&loop != &region.loops.front()) json.new_line();
    append_points(json, {}, loop);
  }
  json.end_array();
  if (!region.tags.empty()) {
    json.begin_array("tags");
    for (const auto& tags : region.tags) {
      json.begin_array();
      for (const std::string& tag : tags) json.value(tag);
      json.end_array();
    }
    json.end_array();
  }
  json.end_object();
}

// What steers sizes, directions and the start, where there is any.
void append_steering(JsonWriter& json, const DomainInput& domain) {
  if (!domain.sizes.empty()) {
    json.begin_array("sizes");
    for (const DomainInput::SizeAt& s : domain.sizes) json.tuple(s.position.x, s.position.y, s.h);
    json.end_array();
  }
  if (!domain.guides.empty()) {
    json.begin_array("guides");
    for (const DomainInput::Guide& guide : domain.guides) append_points(json, {}, guide);
    json.end_array();
  }
  if (!domain.seeds.empty()) append_points(json, "seedPoints", domain.seeds);
}

}  // namespace

std::string write_domain_json(const DomainInput& domain) {
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  json.begin_array("regions");
  for (const DomainInput::Region& region : domain.regions) append_region(json, region);
  json.end_array();
  json.begin_array("polylines");
  for (const DomainInput::Polyline& line : domain.polylines) {
    json.begin_object();
    append_points(json, "points", line.points);
    json.member("tag", line.tag);
    json.end_object();
  }
  json.end_array();
  json.begin_array("points");
  for (const DomainInput::Point& point : domain.points) {
    json.begin_object();
    json.key("position");
    json.tuple(point.position.x, point.position.y);
    json.member("tag", point.tag);
    json.end_object();
  }
  json.end_array();
  if (domain.h > 0) json.member("h", domain.h);
  append_steering(json, domain);
  json.end_object();
  out += '\n';
  return out;
}

}  // namespace lpq
