// See soup_builder.h.
#include "io/surface/soup_builder.h"

#include <algorithm>

#include "base/words.h"
#include "io/surface/polygon.h"
#include "surface/bodies.h"

namespace lpq {
namespace {

constexpr std::size_t most_elements = 200'000'000;  // 3 corners each still fit an Index
}  // namespace

void SoupBuilder::set_group(const std::string& key, const std::string& name) {
  key_ = key;
  name_ = name;
  group_ = none;
}

void SoupBuilder::set_body(const std::string& name) {
  body_name_ = name;
  body_ = none;
  has_bodies_ = true;
}

SurfaceSoup SoupBuilder::take() {
  for (Index i = 0; i < static_cast<Index>(later_.size()); ++i)
    divide(waiting_.row(i), later_[static_cast<std::size_t>(i)]);
  if (!soup_.sizes.empty()) soup_.sizes.resize(soup_.points.size(), 0);
  if (turned_ > 0) soup_.warnings.push_back(warning_of_turned());
  if (has_bodies_) {
    join_loose_bodies(soup_);
  } else {
    soup_.body.clear();
    soup_.body_names.clear();
  }
  return std::move(soup_);
}

SoupBuilder::Owner SoupBuilder::owner() {
  if (group_ == none) {
    const auto [at, is_new] = groups_.try_emplace(key_, static_cast<Index>(groups_.size()));
    if (is_new) soup_.group_names.push_back(name_);
    group_ = at->second;
  }
  if (body_ == none) {
    const auto [at, is_new] = bodies_.try_emplace(body_name_, static_cast<Index>(bodies_.size()));
    if (is_new) soup_.body_names.push_back(body_name_);
    body_ = at->second;
  }
  return {group_, body_};
}

void SoupBuilder::add_polygon(std::span<const Index> corners) {
  const bool is_complete = *std::max_element(corners.begin(), corners.end()) < point_count();
  if (is_complete && later_.empty()) return divide(corners, owner());
  waiting_.values.insert(waiting_.values.end(), corners.begin(), corners.end());
  waiting_.end_row();
  later_.push_back(owner());
}

void SoupBuilder::divide(std::span<const Index> corners, Owner owner) {
  const DividedPolygon divided = divide_polygon(corners, soup_.points);
  for (const Tri& triangle : divided.triangles) {
    soup_.triangles.push_back(triangle);
    soup_.group.push_back(owner.group);
    soup_.body.push_back(owner.body);
  }
  if (divided.turned && turned_++ == 0) first_turned_ = soup_.points[corners[0]];
}

Warning SoupBuilder::warning_of_turned() const {
  const Vec3 at = first_turned_;
  return {ErrorCode::self_intersection,
          std::to_string(turned_) + (turned_ == 1 ? " polygon was" : " polygons were") +
              " divided into triangles of which some turn over, the first near " +
              place_in_space(at.x, at.y, at.z) +
              ": such a one crosses itself, or has inward corners and thousands of others"
              ". Divide it into triangles before.",
          {}};
}

bool SoupBuilder::too_large() const {
  return soup_.points.size() > most_elements || soup_.triangles.size() > most_elements ||
         waiting_.values.size() > most_elements;
}

Error too_many_triangles() {
  return {ErrorCode::too_large,
          "The file has more than 200 million points or triangles. Coarsen it, or divide it.",
          {}};
}

}  // namespace lpq
