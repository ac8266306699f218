// See curves.h.
#include <algorithm>
#include <cmath>

#include "surface/curve_counts.h"
#include "surface/curves.h"

namespace lpq {
namespace {

constexpr double most_nodes = 5e7;

/// Steps of int ds/h along one curve, at its vertices: 1/h is linear in arc length between two.
struct Station {
  double density = 0;  // 1/h
  double steps = 0;    // from the curve's start to here
};

struct Profile {
  std::vector<Station> stations;
  double steps() const { return stations.back().steps; }
};

Error bad_size(Index vertex) {
  return {ErrorCode::bad_size,
          "The mesh size near vertex " + std::to_string(vertex) +
              " of the surface must be positive and finite.",
          {}};
}

Result<std::vector<Profile>> profiles_of(const SurfaceMesh& mesh, const SurfaceCurves& curves,
                                         std::span<const double> size) {
  std::vector<Profile> profiles(curves.is_loop.size());
  double total = 0;
  for (Index c = 0; c < curves.count(); ++c) {
    std::vector<Station>& stations = profiles[c].stations;
    Index before = none;
    for (const Index v : curves.vertices.row(c)) {
      if (!(size[v] > 0 && std::isfinite(size[v]))) return bad_size(v);
      Station station{1 / size[v], 0};
      if (before != none) {
        const double edge = distance(mesh.points[before], mesh.points[v]);
        const Station& last = stations.back();
        station.steps = last.steps + 0.5 * (last.density + station.density) * edge;
      }
      stations.push_back(station);
      before = v;
    }
    total += profiles[c].steps();
  }
  if (!(total < most_nodes))
    return Error{ErrorCode::too_many_elements, "The mesh size is too small for the curves.", {}};
  return profiles;
}

class NodeMaker {
 public:
  NodeMaker(const SurfaceMesh& mesh, const SurfaceFeatures& features, const SurfaceCurves& curves)
      : mesh_(mesh), curves_(curves) {
    result_.node_of_corner.assign(mesh.points.size(), none);
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      if (features.corner[v]) result_.node_of_corner[v] = add(mesh.points[v], {.vertex = v});
  }

  CurveMesh run(std::span<const Profile> profiles, std::span<const Index> counts) {
    for (Index c = 0; c < curves_.count(); ++c) divide(c, profiles[c], counts[c]);
    return std::move(result_);
  }

 private:
  Index add(Vec3 point, CurvePlace place) {
    result_.points.push_back(point);
    result_.places.push_back(place);
    return static_cast<Index>(result_.points.size()) - 1;
  }

  void divide(Index c, const Profile& profile, Index count) {
    const auto vertices = curves_.vertices.row(c);
    const Index start = vertices.front();
    const Index first = curves_.is_loop[c] ? add(mesh_.points[start], {.curve = c, .edge = 0})
                                           : result_.node_of_corner[start];
    const Index last = curves_.is_loop[c] ? first : result_.node_of_corner[vertices.back()];
    result_.nodes.values.push_back(first);
    std::size_t station = 0;
    for (Index k = 1; k < count; ++k) {
      const double steps = profile.steps() * (static_cast<double>(k) / count);
      while (station + 2 < profile.stations.size() && profile.stations[station + 1].steps <= steps)
        ++station;
      result_.nodes.values.push_back(add_between(c, profile, station, steps));
    }
    result_.nodes.values.push_back(last);
    result_.nodes.end_row();
  }

  /// The node at so many steps, between two stations of one edge.
  Index add_between(Index c, const Profile& profile, std::size_t station, double steps) {
    const Station &a = profile.stations[station], &b = profile.stations[station + 1];
    // With s = (steps - a.steps) / (b.steps - a.steps) of the area under the line from density d to
    // e, the fraction u solves d u + (e - d) u^2 / 2 = s (d + e) / 2.
    const double whole = b.steps - a.steps;
    const double s = whole > 0 ? std::clamp((steps - a.steps) / whole, 0.0, 1.0) : 0;
    const double d = a.density, e = b.density, target = s * (d + e);
    const double u = target / (d + std::sqrt(d * d + (e - d) * target));
    constexpr double below_one = 1 - 0x1p-53;  // the end of an edge is the start of the next
    const CurvePlace place{
        .curve = c, .edge = static_cast<Index>(station), .t = std::min(u, below_one)};
    const auto vertices = curves_.vertices.row(c);
    const Vec3 p = mesh_.points[vertices[place.edge]], q = mesh_.points[vertices[place.edge + 1]];
    return add(p + place.t * (q - p), place);
  }

  const SurfaceMesh& mesh_;
  const SurfaceCurves& curves_;
  CurveMesh result_;
};

}  // namespace

Result<CurveMesh> mesh_curves(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                              const SurfaceCurves& curves, std::span<const double> size) {
  const auto profiles = profiles_of(mesh, curves, size);
  if (!profiles) return profiles.error();
  std::vector<double> steps;
  for (const Profile& profile : *profiles) steps.push_back(profile.steps());
  const std::vector<Index> counts = curve_counts(curves, features.face_count, steps,
                                                 side_balances(mesh, features, curves, steps));
  return NodeMaker(mesh, features, curves).run(*profiles, counts);
}

}  // namespace lpq
