// See coarsen.h. The passes over sets of vertices apart from each other are those of [LSSCD98]; a
// vertex goes into a neighbour, so that no new place has to be found.
#include "surface/coarsen.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/fans.h"

namespace lpq {
namespace {

// Of new triangles: 1 is equilateral.
constexpr double least_quality = 0.2;
// Cosine of the angle that a triangle may turn by.
constexpr double least_cosine = 0.9;
// Distance of the vertex from new triangles' planes, as a share of their longest side.
constexpr double most_offset = 0.05;
constexpr std::size_t most_neighbours = 12;
constexpr int most_passes = 60;
// A pass that removes a smaller share of the vertices is the last.
constexpr double least_share = 0.01;

class Coarsener {
 public:
  Coarsener(const SurfaceMesh& mesh, std::span<const char> feature,
            std::span<const double> longest);
  void run();
  CoarseSurface take();

 private:
  void fix_vertices();
  bool try_remove(Index v);
  void walk_round(Index v);
  template <class Visit>
  void each_neighbour(Index w, Visit&& visit) const;
  bool keeps_topology(Index w) const;
  double quality(Index v, std::size_t into) const;
  void remove(Index v, std::size_t into);
  void link(Index e, Index f);
  Index home_of(Index v);

  Index target(Index e) const { return corners_of(triangles_)[next_in_triangle(e)]; }
  Index apex(Index e) const { return corners_of(triangles_)[prev_in_triangle(e)]; }

  const SurfaceMesh& mesh_;
  std::span<const double> longest_;
  std::vector<Tri> triangles_;  // with none where one is gone
  std::vector<Index> twins_;
  std::vector<char> feature_;   // #half-edges
  std::vector<Index> leaving_;  // #V  a half-edge
  std::vector<char> fixed_;     // #V  1: stays, 2: nothing may go into it either
  std::vector<Index> home_;     // #V  itself, or where it went
  std::vector<int> touched_;    // #V  last pass that changed the triangles there
  std::vector<Index> seen_;     // #V  last vertex in whose ring it was seen
  std::vector<Index> ring_;     // half-edges that leave the current vertex, counter-clockwise
  int pass_ = 0;
};

Coarsener::Coarsener(const SurfaceMesh& mesh, std::span<const char> feature,
                     std::span<const double> longest)
    : mesh_(mesh),
      longest_(longest),
      triangles_(mesh.triangles),
      twins_(mesh.twins),
      feature_(feature.begin(), feature.end()),
      leaving_(mesh.points.size(), none),
      fixed_(mesh.points.size(), 0),
      touched_(mesh.points.size(), 0),
      seen_(mesh.points.size(), none) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) home_.push_back(v);
  fix_vertices();
}

void Coarsener::fix_vertices() {
  const SurfaceFans fans = fans_of(mesh_.twins);
  for (Index f = 0; f < fans.count(); ++f) {
    const Index e = fans.corners.row(f)[0], v = mesh_.origin(e);
    if (leaving_[v] != none) fixed_[v] = 2;  // sheets meet here
    leaving_[v] = e;
  }
  const auto fix = [&](Index v) { fixed_[v] = std::max<char>(fixed_[v], 1); };
  for (Index e = 0; e < static_cast<Index>(twins_.size()); ++e)
    if (twins_[e] == none || feature_[e]) fix(mesh_.origin(e)), fix(mesh_.target(e));
}

void Coarsener::walk_round(Index v) {
  ring_.clear();
  Index e = leaving_[v];
  do {
    ring_.push_back(e);
    e = twins_[prev_in_triangle(e)];
  } while (e != leaving_[v]);
}

template <class Visit>
void Coarsener::each_neighbour(Index w, Visit&& visit) const {
  const Index first = leaving_[w];
  Index e = first;
  do {
    visit(target(e));
    const Index left = prev_in_triangle(e);
    e = twins_[left];
    if (e == none) visit(corners_of(triangles_)[left]);
  } while (e != none && e != first);
  if (e == first) return;
  for (e = twins_[first]; e != none; e = twins_[e]) {
    e = next_in_triangle(e);
    visit(target(e));
  }
}

/// The vertex whose ring was seen and w have two neighbours in common.
bool Coarsener::keeps_topology(Index w) const {
  const Index v = corners_of(triangles_)[ring_[0]];
  int common = 0, neighbours = 0;
  each_neighbour(w, [&](Index u) { common += seen_[u] == v, ++neighbours; });
  return common == 2 && (ring_.size() > 3 || neighbours > 3);
}

/// The least of the new triangles; 0 where one must not be.
double Coarsener::quality(Index v, std::size_t into) const {
  const std::size_t n = ring_.size();
  const Vec3 from = mesh_.points[v], to = mesh_.points[target(ring_[into])];
  const double longest2 = longest_[v] * longest_[v];
  double least = 1;
  for (std::size_t j = 0; j < n; ++j) {
    if (j == into || (j + 1) % n == into) continue;
    const Vec3 a = mesh_.points[target(ring_[j])], b = mesh_.points[apex(ring_[j])];
    const Vec3 before = cross(a - from, b - from), after = cross(a - to, b - to);
    const double la = squared_length(a - to), lb = squared_length(b - to);
    const double double_area = length(after);
    if (la > longest2 || lb > longest2) return 0;
    if (dot(before, after) < least_cosine * length(before) * double_area) return 0;
    if (std::abs(dot(after, from - to)) > most_offset * longest_[v] * double_area) return 0;
    const double sum = la + lb + squared_length(b - a);
    least = std::min(least, 2 * 1.7320508075688772 * double_area / sum);
  }
  return least;
}

void Coarsener::link(Index e, Index f) {
  if (e != none) twins_[e] = f;
  if (f != none) twins_[f] = e;
}

/// The two triangles of the edge from v fold up; what lies beyond their other sides meets.
void Coarsener::remove(Index v, std::size_t into) {
  const Index e = ring_[into], f = twins_[e], w = target(e);
  const Index right = twins_[prev_in_triangle(e)], left = twins_[next_in_triangle(f)];
  for (const Index other : ring_) touched_[target(other)] = pass_;
  feature_[right] = feature_[next_in_triangle(e)];
  feature_[left] = feature_[prev_in_triangle(f)];
  leaving_[w] = right;
  leaving_[apex(e)] = next_in_triangle(right);
  leaving_[apex(f)] = left;
  link(right, twins_[next_in_triangle(e)]);
  link(left, twins_[prev_in_triangle(f)]);
  for (const Index other : ring_) corners_of(triangles_)[other] = w;
  triangles_[triangle_of(e)] = triangles_[triangle_of(f)] = {none, none, none};
  home_[v] = w;
}

bool Coarsener::try_remove(Index v) {
  walk_round(v);
  if (ring_.size() > most_neighbours) return false;
  for (const Index e : ring_) seen_[target(e)] = v;
  double best = least_quality;
  std::size_t into = ring_.size();
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const Index w = target(ring_[i]);
    if (fixed_[w] == 2) continue;
    const double found = quality(v, i);
    if (found > best && keeps_topology(w)) best = found, into = i;
  }
  if (into == ring_.size()) return false;
  remove(v, into);
  return true;
}

void Coarsener::run() {
  double left = mesh_.vertex_count();
  for (pass_ = 1; pass_ <= most_passes; ++pass_) {
    double removed = 0;
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (!fixed_[v] && leaving_[v] != none && home_[v] == v && touched_[v] != pass_)
        removed += try_remove(v);
    if (removed < least_share * left) break;
    left -= removed;
  }
}

Index Coarsener::home_of(Index v) {
  Index end = v;
  while (home_[end] != end) end = home_[end];
  while (home_[v] != end) v = std::exchange(home_[v], end);
  return end;
}

CoarseSurface Coarsener::take() {
  CoarseSurface result;
  SurfaceMesh& mesh = result.mesh;
  std::vector<Index> number(triangles_.size(), none), vertex(mesh_.points.size(), none);
  for (Index v = 0; v < mesh_.vertex_count(); ++v) {
    if (home_[v] != v) continue;
    vertex[v] = mesh.vertex_count();
    result.vertex.push_back(v);
    mesh.points.push_back(mesh_.points[v]);
    if (!mesh_.body.empty()) mesh.body.push_back(mesh_.body[v]);
  }
  for (Index v = 0; v < mesh_.vertex_count(); ++v) result.home.push_back(vertex[home_of(v)]);
  for (Index t = 0; t < mesh_.triangle_count(); ++t) {
    if (triangles_[t][0] == none) continue;
    const auto [a, b, c] = triangles_[t];
    number[t] = mesh.triangle_count();
    result.triangle.push_back(t);
    mesh.triangles.push_back({vertex[a], vertex[b], vertex[c]});
    mesh.group.push_back(mesh_.group[t]);
  }
  for (const Index t : result.triangle)
    for (Index e = 3 * t; e < 3 * t + 3; ++e) {
      const Index twin = twins_[e];
      mesh.twins.push_back(twin == none ? none : 3 * number[triangle_of(twin)] + twin % 3);
      result.feature.push_back(feature_[e]);
    }
  return result;
}

}  // namespace

CoarseSurface coarsen(const SurfaceMesh& mesh, std::span<const char> feature,
                      std::span<const double> longest) {
  Coarsener coarsener(mesh, feature, longest);
  coarsener.run();
  return coarsener.take();
}

}  // namespace lpq
