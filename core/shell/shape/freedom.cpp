// See freedom.h.
#include "shell/shape/freedom.h"

#include <algorithm>

#include "base/check.h"
#include "base/sort_numbers.h"
#include "shell/place.h"

namespace lpq {
namespace {

// Of the way to the neighbour on the track, from one anchor to the next: two that approach each
// other do not meet.
constexpr double largest_slide = 0.4;
// Of the mesh size: edges whose track goes further from them do not get longer by sliding.
constexpr double largest_sagitta = 0.1;
constexpr int sagitta_trials = 4;

/// Exactly, if the vertex is a corner of the triangle.
void put_on_vertex(const SurfaceMesh& surface, Index vertex, SurfacePlace& place) {
  for (int k = 0; k < 3; ++k) {
    if (surface.triangles[place.triangle][k] != vertex) continue;
    for (int j = 0; j < 3; ++j) place.weight[j] = j == k;
  }
}

}  // namespace

std::vector<VertexRole> vertex_roles(const Charted& charted, const Tracks& tracks,
                                     const ShellMesh& mesh) {
  const std::vector<TrackPosition> positions = tracks.positions_of(charted.curves, charted.nodes);
  std::vector<VertexRole> roles(mesh.points.size());
  std::size_t next = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.is_free(v)) continue;
    LPQ_ASSERT(next < positions.size());
    VertexRole& role = roles[v];
    role.on_track = positions[next++];
    role.kind = role.on_track.track == none || mesh.pins[v] == Pin::corner
                    ? VertexRole::Kind::fixed
                    : VertexRole::Kind::slides;
  }
  LPQ_ASSERT(next == positions.size());
  return roles;
}

Freedom::Freedom(const ShapeGround& ground, std::vector<VertexRole> roles, ShellMesh& mesh)
    : ground_(ground),
      mesh_(mesh),
      role_(std::move(roles)),
      neighbours_(mesh.points.size(), {none, none}),
      anchor_(mesh.points.size()),
      axes_(mesh.points.size()) {
  for (std::size_t v = 0; v < role_.size(); ++v)
    if (role_[v].on_track.vertex != none)
      put_on_vertex(ground.surface, role_[v].on_track.vertex, mesh.places[v]);
  find_neighbours();
}

void Freedom::find_neighbours() {
  std::vector<Index> on_tracks;
  for (std::size_t v = 0; v < role_.size(); ++v)
    if (role_[v].on_track.track != none) on_tracks.push_back(static_cast<Index>(v));
  sort_numbers(on_tracks, [&](Index v, Index w) {
    const TrackPosition &a = role_[v].on_track, &b = role_[w].on_track;
    if (a.track != b.track) return a.track < b.track;
    return a.s != b.s ? a.s < b.s : v < w;
  });
  for (std::size_t i = 0; i < on_tracks.size();) {
    const Index track = role_[on_tracks[i]].on_track.track;
    std::size_t j = i + 1;
    while (j < on_tracks.size() && role_[on_tracks[j]].on_track.track == track) ++j;
    for (std::size_t k = i + 1; k < j; ++k) {
      neighbours_[on_tracks[k]][0] = on_tracks[k - 1];
      neighbours_[on_tracks[k - 1]][1] = on_tracks[k];
    }
    if (ground_.tracks.is_loop(track)) {
      neighbours_[on_tracks[i]][0] = on_tracks[j - 1];
      neighbours_[on_tracks[j - 1]][1] = on_tracks[i];
    }
    i = j;
  }
}

void Freedom::anchor(std::span<const Index> vertices) {
  constexpr double still[2] = {0, 0};
  for (const Index v : vertices) {
    anchor_[v].place = mesh_.places[v];
    if (role_[v].kind == Kind::slides) anchor_on_track(v);
    place(v, still);
  }
}

void Freedom::anchor_on_track(Index v) {
  const auto& [track, s, vertex] = role_[v].on_track;
  const double whole = ground_.tracks.length(track);
  const auto& [before, after] = neighbours_[v];
  double low = before == none ? 0 : role_[before].on_track.s;
  double high = after == none ? whole : role_[after].on_track.s;
  if (ground_.tracks.is_loop(track)) {
    if (low >= s) low -= whole;
    if (high <= s) high += whole;
  }
  const double bound = largest_sagitta * ground_.size_at(mesh_.places[v]);
  anchor_[v].s = s;
  anchor_[v].low = s - slide_towards(track, high, s, low, bound);
  anchor_[v].high = s + slide_towards(track, low, s, high, bound);
}

/// How far a vertex may slide from s towards `ahead`: not to its neighbour there, and not so far
/// that the edge `behind` it, whose other end may slide as far the other way, leaves the track.
double Freedom::slide_towards(Index track, double behind, double s, double ahead,
                              double bound) const {
  const double forward = ahead > s ? 1 : -1;
  const auto sagitta = [&](double by) {
    double from = behind - forward * by, to = s + forward * by;
    if (!ground_.tracks.is_loop(track)) from = std::clamp(from, 0.0, ground_.tracks.length(track));
    return ground_.tracks.sagitta(track, std::min(from, to), std::max(from, to));
  };
  double most = largest_slide * std::max(0.0, forward * (ahead - s));
  const double allowed = std::max(bound, sagitta(0));
  for (int i = 0; i < sagitta_trials; ++i, most *= 0.5)
    if (sagitta(most) <= allowed) return most;
  return 0;
}

void Freedom::place(Index v, const double* displacement) {
  if (role_[v].kind == Kind::slides) slide(v, displacement[0]);
  if (role_[v].kind == Kind::walks) walk(v, {displacement[0], displacement[1]});
}

void Freedom::slide(Index v, double by) {
  const Anchor& anchor = anchor_[v];
  TrackPosition& at = role_[v].on_track;
  const double wanted = anchor.s + by;
  at.s = std::clamp(wanted, anchor.low, anchor.high);
  const bool stopped = at.s != wanted;
  if (ground_.tracks.is_loop(at.track)) {
    const double whole = ground_.tracks.length(at.track);
    if (at.s < 0) at.s += whole;
    if (at.s >= whole) at.s -= whole;
  }
  const Tracks::Point point = ground_.tracks.at(at.track, at.s);
  mesh_.places[v] = point.place;
  mesh_.points[v] = point_at(ground_.surface, point.place);
  axes_[v][0] = stopped ? Vec3{} : point.tangent;
}

void Freedom::walk(Index v, Vec2 by) {
  const WalkEnd end = ground_.walker.walk(anchor_[v].place, by);
  mesh_.places[v] = end.place;
  mesh_.points[v] = point_at(ground_.surface, end.place);
  axes_[v] = {Vec3{}, Vec3{}};
  if (!end.whole) return;
  const TriangleAxes axes = axes_of(ground_.surface, end.place.triangle);
  // The displacement's x axis is `turn` in the last frame, its y axis is that turned left.
  axes_[v][0] = end.turn.x * axes.x + end.turn.y * axes.y;
  axes_[v][1] = end.turn.x * axes.y - end.turn.y * axes.x;
}

void Freedom::pull_back(Index v, Vec3 by_position, double* by_displacement) const {
  for (int i = 0; i < unknowns(v); ++i) by_displacement[i] = dot(axes_[v][i], by_position);
}

void Freedom::restore(Index v, const State& state) {
  role_[v].on_track.s = state.s;
  mesh_.places[v] = state.place;
  mesh_.points[v] = state.point;
}

}  // namespace lpq
