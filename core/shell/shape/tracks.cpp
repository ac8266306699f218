// See tracks.h.
#include "shell/shape/tracks.h"

#include <algorithm>
#include <cmath>

#include "shell/place.h"
#include "surface/corners.h"

namespace lpq {

Tracks::Tracks(const SurfaceMesh& mesh, const SurfaceFeatures& features,
               std::span<const double> size)
    : mesh_(mesh), features_(features) {
  mark_corners(mesh, size, FeatureOptions{}.corner_angle, features_);
  for (std::size_t v = 0; v < features.corner.size(); ++v)
    if (features.corner[v]) features_.corner[v] = 1;
  curves_ = trace_curves(mesh, features_);
  track_.assign(features_.edges.count(), none);
  slot_.assign(features_.edges.count(), none);
  for (Index c = 0; c < curves_.count(); ++c) {
    const auto vertices = curves_.vertices.row(c);
    const auto edges = curves_.edges.row(c);
    double s = 0;
    start_.values.push_back(s);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      track_[edges[k]] = c;
      slot_[edges[k]] = static_cast<Index>(k);
      s += distance(mesh.points[vertices[k]], mesh.points[vertices[k + 1]]);
      start_.values.push_back(s);
    }
    start_.end_row();
  }
}

/// At a share of the way along an edge, from its end `from`.
TrackPosition Tracks::position_on(Index edge, Index from, double share) const {
  const Index c = track_[edge], k = slot_[edge];
  const auto start = start_.row(c);
  if (curves_.vertices.row(c)[k] != from) share = 1 - share;
  return {c, start[k] + share * (start[k + 1] - start[k]), none};
}

std::vector<TrackPosition> Tracks::positions_of(const SurfaceCurves& curves,
                                                const CurveMesh& nodes) const {
  std::vector<TrackPosition> at(nodes.points.size());
  std::vector<char> on_feature(nodes.points.size(), 0);
  for (Index c = 0; c < curves.count(); ++c) {
    if (!features_.is_feature(curves.edges.row(c)[0])) continue;
    for (const Index node : nodes.nodes.row(c)) on_feature[node] = 1;
    const auto edges = curves.edges.row(c);
    const auto vertices = curves.vertices.row(c);
    for (const Index node : nodes.nodes.row(c)) {
      const CurvePlace& place = nodes.places[node];
      if (place.vertex == none)
        at[node] = position_on(edges[place.edge], vertices[place.edge], place.t);
      else if (features_.corner[place.vertex])
        at[node] = {none, 0, place.vertex};
      else
        at[node] = place.vertex == vertices.front()
                       ? position_on(edges.front(), vertices.front(), 0)
                       : position_on(edges.back(), vertices.back(), 0);
    }
  }
  std::vector<TrackPosition> result;
  for (std::size_t n = 0; n < at.size(); ++n) {
    const Index v = nodes.places[n].vertex;
    // Where parts meet in a point only, there is a corner without a curve.
    if (!on_feature[n] && v != none && features_.corner[v]) result.push_back({none, 0, v});
    if (on_feature[n]) result.push_back(at[n]);
  }
  return result;
}

/// Anywhere on a loop so small that s goes round it all the time, or without length.
double Tracks::once_round(Index track, double s) const {
  constexpr double most_rounds = 1000;
  const double whole = length(track);
  if (!(std::abs(s) < most_rounds * whole)) return 0;
  while (s < 0) s += whole;
  while (s >= whole) s -= whole;
  return s;
}

Tracks::Point Tracks::at(Index track, double s) const {
  if (curves_.is_loop[track]) s = once_round(track, s);
  const auto start = start_.row(track);
  const auto after = std::upper_bound(start.begin() + 1, start.end() - 1, s);
  const std::size_t k = static_cast<std::size_t>(after - start.begin()) - 1;
  const double size = start[k + 1] - start[k];
  const double t = size > 0 ? std::clamp((s - start[k]) / size, 0.0, 1.0) : 0;
  const Index edge = curves_.edges.row(track)[k];
  const auto vertices = curves_.vertices.row(track);
  const Vec3 along = mesh_.points[vertices[k + 1]] - mesh_.points[vertices[k]];
  const Index e = features_.edges.half_edges.row(edge)[0];
  Point point{{triangle_of(e), {0, 0, 0}}, size > 0 ? (1 / size) * along : Vec3{}};
  const bool forward = mesh_.origin(e) == vertices[k];
  point.place.weight[e % 3] = forward ? 1 - t : t;
  point.place.weight[next_in_triangle(e % 3)] = forward ? t : 1 - t;
  return point;
}

double Tracks::sagitta(Index track, double from, double to) const {
  const auto start = start_.row(track);
  const auto vertices = curves_.vertices.row(track);
  const double whole = start.back();
  const auto point = [&](double s) { return point_at(mesh_, at(track, s).place); };
  const Vec3 a = point(from), chord = point(to) - a;
  const double squared = squared_length(chord);
  double most = 0;
  const double rounds = is_loop(track) ? 1 : 0;
  for (double round = -rounds; round <= rounds; ++round) {
    const double shift = round * whole;
    auto k = std::upper_bound(start.begin(), start.end(), from - shift) - start.begin();
    for (; k < static_cast<std::ptrdiff_t>(start.size()) && start[k] + shift < to; ++k) {
      const Vec3 b = mesh_.points[vertices[k]] - a;
      const double t = squared > 0 ? std::clamp(dot(b, chord) / squared, 0.0, 1.0) : 0;
      most = std::max(most, squared_length(b - t * chord));
    }
  }
  return std::sqrt(most);
}

}  // namespace lpq
