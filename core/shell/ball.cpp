// See ball.h.
#include "shell/ball.h"

#include <algorithm>
#include <limits>

namespace lpq {

constexpr double far = std::numeric_limits<double>::infinity();

BallFinder::BallFinder(const SurfaceMesh& mesh, std::span<const char> barrier)
    : mesh_(mesh),
      barrier_(barrier),
      distance_(mesh.triangles.size(), far),
      taken_(mesh.triangles.size(), 0),
      touched_(mesh.points.size(), 0) {
  centroid_.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
    centroid_.push_back((1.0 / 3) * (mesh.points[a] + mesh.points[b] + mesh.points[c]));
}

double BallFinder::step(Index from, Index to) const {
  return distance(centroid_[from], centroid_[to]);
}

/// A triangle is glued to a disk along one edge, its opposite corner apart, or along two.
bool BallFinder::keeps_disk(Index t) const {
  int glued = 0, edge = 0;
  for (int k = 0; k < 3; ++k) {
    const Index twin = mesh_.twins[3 * t + k];
    if (twin == none || !taken_[triangle_of(twin)]) continue;
    ++glued;
    edge = k;
  }
  if (glued == 1) return !touched_[mesh_.triangles[t][(edge + 2) % 3]];
  return glued == 2;
}

void BallFinder::take(Index t) {
  taken_[t] = 1;
  disk_.push_back(t);
  for (const Index v : mesh_.triangles[t]) touched_[v] = 1;
}

void BallFinder::reach(Index t, double there) {
  if (distance_[t] == far) reached_.push_back(t);
  distance_[t] = std::min(distance_[t], there);
  queue_.push({distance_[t], t});
}

// What cannot be taken when its turn comes is asked again with every neighbour that is.
void BallFinder::grow(Index centre, double radius) {
  reach(centre, 0);
  while (!queue_.empty()) {
    const auto [d, t] = queue_.top();
    queue_.pop();
    if (taken_[t] || (t != centre && !keeps_disk(t))) continue;
    take(t);
    for (Index e = 3 * t; e < 3 * t + 3; ++e) {
      if (mesh_.twins[e] == none) continue;
      const Index next = triangle_of(mesh_.twins[e]);
      if (taken_[next]) continue;
      if (barrier_[e]) {
        if (distance_[next] < far) queue_.push({distance_[next], next});
      } else if (const double there = d + step(t, next); there < radius) {
        reach(next, there);
      }
    }
  }
}

// Distances of the triangles taken from those at the open border.
void BallFinder::measure_from_border() {
  for (const Index t : reached_) distance_[t] = far;
  for (const Index t : disk_)
    for (Index e = 3 * t; e < 3 * t + 3; ++e)
      if (!barrier_[e] && mesh_.twins[e] != none && !taken_[triangle_of(mesh_.twins[e])])
        reach(t, 0);
  while (!queue_.empty()) {
    const auto [d, t] = queue_.top();
    queue_.pop();
    if (d > distance_[t]) continue;
    for (Index e = 3 * t; e < 3 * t + 3; ++e) {
      if (mesh_.twins[e] == none) continue;
      const Index next = triangle_of(mesh_.twins[e]);
      const double there = d + step(t, next);
      if (taken_[next] && there < distance_[next]) reach(next, there);
    }
  }
}

Ball BallFinder::ball(Index centre, double radius, double margin) {
  grow(centre, radius);
  measure_from_border();
  Ball ball;
  std::sort(disk_.begin(), disk_.end());
  for (const Index t : disk_) {
    ball.inside.push_back(distance_[t] >= margin);
    taken_[t] = 0;
    for (const Index v : mesh_.triangles[t]) touched_[v] = 0;
  }
  for (const Index t : reached_) distance_[t] = far;
  reached_.clear();
  ball.triangles = std::move(disk_);
  disk_.clear();
  return ball;
}

}  // namespace lpq
