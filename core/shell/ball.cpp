// See ball.h.
#include "shell/ball.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace lpq {

constexpr double far = std::numeric_limits<double>::infinity();

BallFinder::BallFinder(const SurfaceMesh& mesh, std::span<const char> barrier)
    : mesh_(mesh), barrier_(barrier), distance_(mesh.triangles.size(), far) {
  centroid_.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
    centroid_.push_back((1.0 / 3) * (mesh.points[a] + mesh.points[b] + mesh.points[c]));
}

Ball BallFinder::ball(Index centre, double radius, double margin) {
  using Entry = std::pair<double, Index>;  // the index breaks ties
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  Ball ball;
  std::vector<Index>& reached = ball.triangles;
  reached.push_back(centre);
  distance_[centre] = 0;
  queue.push({0, centre});
  while (!queue.empty()) {
    const auto [d, t] = queue.top();
    queue.pop();
    if (d > distance_[t]) continue;
    for (Index e = 3 * t; e < 3 * t + 3; ++e) {
      const Index twin = mesh_.twins[e];
      if (twin == none || barrier_[e]) continue;
      const Index next = triangle_of(twin);
      const double there = d + distance(centroid_[t], centroid_[next]);
      if (there >= radius + margin || there >= distance_[next]) continue;
      if (distance_[next] == far) reached.push_back(next);
      distance_[next] = there;
      queue.push({there, next});
    }
  }
  std::sort(reached.begin(), reached.end());
  for (const Index t : reached) {
    ball.inside.push_back(distance_[t] < radius);
    distance_[t] = far;
  }
  return ball;
}

}  // namespace lpq
