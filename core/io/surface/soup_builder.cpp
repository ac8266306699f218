// See soup_builder.h.
#include "io/surface/soup_builder.h"

#include "surface/bodies.h"

namespace lpq {
namespace {

constexpr std::size_t most_elements = 200'000'000;  // 3 corners each still fit an Index
constexpr std::size_t most_corners_looked_at = 64;

/// Twice the area of a polygon as a vector (Newell), from its first corner.
Vec3 area_vector(std::span<const Index> corners, const std::vector<Vec3>& points) {
  const Vec3 origin = points[corners[0]];
  Vec3 sum;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    sum += cross(points[corners[k]] - origin, points[corners[k + 1]] - origin);
  return sum;
}

bool sees_whole_polygon(std::span<const Index> corners, const std::vector<Vec3>& points,
                        std::size_t apex, Vec3 area) {
  const std::size_t n = corners.size();
  const Vec3 origin = points[corners[apex]];
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const Vec3 a = points[corners[(apex + k) % n]], b = points[corners[(apex + k + 1) % n]];
    if (!(dot(cross(a - origin, b - origin), area) > 0)) return false;
  }
  return true;
}

std::size_t best_apex(std::span<const Index> corners, const std::vector<Vec3>& points) {
  if (corners.size() == 3 || corners.size() > most_corners_looked_at) return 0;
  const Vec3 area = area_vector(corners, points);
  for (std::size_t apex = 0; apex < corners.size(); ++apex)
    if (sees_whole_polygon(corners, points, apex, area)) return apex;
  return 0;
}

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
  if (!soup_.sizes.empty()) soup_.sizes.resize(soup_.points.size(), 0);
  if (has_bodies_) {
    join_loose_bodies(soup_);
  } else {
    soup_.body.clear();
    soup_.body_names.clear();
  }
  return std::move(soup_);
}

void SoupBuilder::add_polygon(std::span<const Index> corners) {
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
  const std::size_t n = corners.size(), apex = best_apex(corners, soup_.points);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    soup_.triangles.push_back(
        {corners[apex], corners[(apex + k) % n], corners[(apex + k + 1) % n]});
    soup_.group.push_back(group_);
    soup_.body.push_back(body_);
  }
}

bool SoupBuilder::too_large() const {
  return soup_.points.size() > most_elements || soup_.triangles.size() > most_elements;
}

Error too_many_triangles() {
  return {ErrorCode::too_large, "The file has more than 200 million points or triangles.", {}};
}

}  // namespace lpq
