// The curves of a surface's features as tracks that vertices of the mesh slide along, by arc
// length.
#pragma once

#include <span>
#include <vector>

#include "shell/mesh_charts.h"

namespace lpq {

/// Where a vertex of the mesh stands on a track; no track for a corner, which stays.
struct TrackPosition {
  Index track = none;
  double s = 0;         // from the start of the track
  Index vertex = none;  // corners: of the surface
};

class Tracks {
 public:
  /// Corners are marked anew with the size of each vertex of the surface: sliding rounds none off.
  Tracks(const SurfaceMesh& mesh, const SurfaceFeatures& features, std::span<const double> size);

  /// Positions of the nodes of curves that lie on features, in their order.
  std::vector<TrackPosition> positions_of(const SurfaceCurves& curves,
                                          const CurveMesh& nodes) const;

  const SurfaceCurves& curves() const { return curves_; }
  double length(Index track) const { return start_.row(track).back(); }
  bool is_loop(Index track) const { return curves_.is_loop[track]; }

  struct Point {
    SurfacePlace place;
    Vec3 tangent;  // of length one
  };
  /// The point at s; on loops s is taken round.
  Point at(Index track, double s) const;

  /// How far the track goes from the chord between two points of it; on loops `to` may be beyond
  /// the end, and `from` before the start.
  double sagitta(Index track, double from, double to) const;

 private:
  double once_round(Index track, double s) const;
  TrackPosition position_on(Index edge, Index from, double share) const;

  const SurfaceMesh& mesh_;
  SurfaceFeatures features_;
  SurfaceCurves curves_;
  Csr<double> start_;                // #tracks  arc length at every vertex of the track
  std::vector<Index> track_, slot_;  // #E  none off features
};

}  // namespace lpq
