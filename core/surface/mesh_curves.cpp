// See curves.h.
#include <algorithm>
#include <cmath>

#include "surface/curve_counts.h"
#include "surface/curves.h"

namespace lpq {
namespace {

constexpr double most_nodes = 5e7;

/// Steps of int ds/h along one curve: 1/h is linear in arc length between neighbouring stations.
struct Station {
  Index edge = 0;      // of the curve
  double t = 0;        // on it
  double density = 0;  // 1/h
  double steps = 0;    // from the curve's start to here
};

struct Profile {
  std::vector<Station> stations;
  double steps() const { return stations.back().steps; }
};

/// Puts stations along curves: at vertices, and where the caller wants more.
class ProfileMaker {
 public:
  ProfileMaker(const SurfaceMesh& mesh, const SurfaceCurves& curves)
      : mesh_(mesh), curves_(curves) {}

  template <class PiecesOf, class SizeOf>
  Result<std::vector<Profile>> run(PiecesOf&& pieces_of, SizeOf&& size_of) {
    std::vector<Profile> profiles(curves_.is_loop.size());
    double total = 0;
    for (Index c = 0; c < curves_.count(); ++c) {
      const auto vertices = curves_.vertices.row(c);
      Profile& profile = profiles[c];
      for (Index edge = 0; edge + 1 < static_cast<Index>(vertices.size()); ++edge) {
        const Index a = vertices[edge], b = vertices[edge + 1];
        const int pieces = pieces_of(a, b);
        for (int k = 0; k <= pieces; ++k) {
          if (k == 0 && edge > 0) continue;
          const double t = static_cast<double>(k) / pieces;
          const double size = size_of(a, b, t);
          if (!(size > 0 && std::isfinite(size))) return bad_size(a);
          add_station(profile, edge, t, 1 / size, distance(mesh_.points[a], mesh_.points[b]));
        }
      }
      total += profile.steps();
    }
    if (!(total < most_nodes))
      return Error{ErrorCode::too_many_elements, "The mesh size is too small for the curves.", {}};
    return profiles;
  }

 private:
  Error bad_size(Index vertex) const {
    return {ErrorCode::bad_size,
            "The mesh size near vertex " + std::to_string(vertex) +
                " of the surface must be positive and finite.",
            {}};
  }

  static void add_station(Profile& profile, Index edge, double t, double density, double length) {
    Station station{edge, t, density, 0};
    if (!profile.stations.empty()) {
      const Station& last = profile.stations.back();
      const double from = last.edge == edge ? last.t : 0;
      station.steps = last.steps + 0.5 * (last.density + density) * ((t - from) * length);
    }
    profile.stations.push_back(station);
  }

  const SurfaceMesh& mesh_;
  const SurfaceCurves& curves_;
};

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
    const double from = a.edge == b.edge ? a.t : 0;
    // With s = (steps - a.steps) / (b.steps - a.steps) of the area under the line from density d to
    // e, the fraction u solves d u + (e - d) u^2 / 2 = s (d + e) / 2.
    const double whole = b.steps - a.steps;
    const double s = whole > 0 ? std::clamp((steps - a.steps) / whole, 0.0, 1.0) : 0;
    const double d = a.density, e = b.density, target = s * (d + e);
    const double u = target / (d + std::sqrt(d * d + (e - d) * target));
    constexpr double below_one = 1 - 0x1p-53;  // the end of an edge is the start of the next
    const CurvePlace place{
        .curve = c, .edge = b.edge, .t = std::min(from + u * (b.t - from), below_one)};
    const auto vertices = curves_.vertices.row(c);
    const Vec3 p = mesh_.points[vertices[place.edge]], q = mesh_.points[vertices[place.edge + 1]];
    return add(p + place.t * (q - p), place);
  }

  const SurfaceMesh& mesh_;
  const SurfaceCurves& curves_;
  CurveMesh result_;
};

Result<CurveMesh> mesh_profiles(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                                const SurfaceCurves& curves,
                                const Result<std::vector<Profile>>& profiles) {
  if (!profiles) return profiles.error();
  std::vector<double> steps;
  for (const Profile& profile : *profiles) steps.push_back(profile.steps());
  const std::vector<Index> counts = curve_counts(curves, features.face_count, steps,
                                                 side_balances(mesh, features, curves, steps));
  return NodeMaker(mesh, features, curves).run(*profiles, counts);
}

}  // namespace

Result<CurveMesh> mesh_curves(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                              const SurfaceCurves& curves, std::span<const double> size) {
  const auto profiles =
      ProfileMaker(mesh, curves)
          .run([](Index, Index) { return 1; },
               [size](Index a, Index b, double t) { return size[t < 1 ? a : b]; });
  return mesh_profiles(mesh, features, curves, profiles);
}

Result<CurveMesh> mesh_curves_by(SizeAt size, const SurfaceMesh& mesh,
                                 const SurfaceFeatures& features, const SurfaceCurves& curves) {
  const auto point = [&mesh](Index a, Index b, double t) {
    if (t == 0) return mesh.points[a];
    if (t == 1) return mesh.points[b];
    return mesh.points[a] + t * (mesh.points[b] - mesh.points[a]);
  };
  const auto pieces_of = [&](Index a, Index b) {
    constexpr double most_pieces = 1000, pieces_per_size = 4;
    const double h = std::min({size(mesh.points[a]), size(mesh.points[b]), size(point(a, b, 0.5))});
    const double pieces = pieces_per_size * distance(mesh.points[a], mesh.points[b]) / h;
    return pieces > 1 ? static_cast<int>(std::min(std::ceil(pieces), most_pieces)) : 1;
  };
  const auto profiles = ProfileMaker(mesh, curves).run(pieces_of, [&](Index a, Index b, double t) {
    return size(point(a, b, t));
  });
  return mesh_profiles(mesh, features, curves, profiles);
}

}  // namespace lpq
