// See laid_borders.h.
#include "grids/laid_borders.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.h"
#include "grids/border_loops.h"
#include "grids/hole_places.h"
#include "grids/loop_turns.h"
#include "grids/polar.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

/// From {0, 0} on.
LatticeLoop along(const std::vector<Index>& nodes, const std::vector<Index>& directions) {
  LatticeLoop loop{nodes, {}};
  LatticePlace place;
  for (const Index d : directions) {
    loop.places.push_back(place);
    place = place + lattice_step(d);
  }
  return loop;
}

bool may_place(const LaidLoops& laid, std::size_t placed, const BoundaryMesh& boundary,
               const TriMesh& triangles) {
  return laid.loops.size() == placed ||
         triangles.fixed == static_cast<Index>(boundary.points.size());
}

Index nearest(double x) { return static_cast<Index>(std::floor(x + 0.5)); }

/// Borders of a ring, laid round the centre of a hole.
class RingLoops {
 public:
  RingLoops(const BoundaryMesh& boundary, std::vector<std::vector<Index>> borders)
      : boundary_(boundary), borders_(std::move(borders)) {
    std::swap(borders_[1], borders_[largest_hole(boundary, borders_)]);
    laid_.centre = centre_of(points_of(boundary, borders_[1]));
  }

  /// All but the places of holes.
  std::optional<LaidLoops> run(double wanted) {
    for (std::size_t k = 0; k < borders_.size(); ++k)
      if (!lay(k, k == 0 ? 1 : k == 1 ? -1 : 0)) return std::nullopt;
    // The lines enclose so many quads if the inner border begins in column 0, and a round of them
    // more in every column further in.
    double quads = 0;
    for (const LatticeLoop& loop : laid_.loops) quads += cells_left_of(loop);
    const Index columns = nearest((wanted - quads) / laid_.round);
    const LatticePlace by{-columns, nearest(turn_of_[1] - turn_of_[0])};
    for (LatticePlace& place : laid_.loops[1].places) place = place + by;
    return std::move(laid_);
  }

 private:
  bool lay(std::size_t k, Index rounds) {
    const LineAbout line = line_about(laid_.centre, points_of(boundary_, borders_[k]));
    if (line.points.empty() || line.rounds != rounds) return false;
    const std::vector<Index> directions = directions_of(line);
    if (directions.empty()) return false;
    if (rounds == 1)
      for (const Index d : directions) laid_.round += lattice_step(d).y;
    if (laid_.round < fewest_round) return false;
    laid_.loops.push_back(along(borders_[k], directions));
    std::vector<LatticePlace>& places = laid_.loops.back().places;
    double turn = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      turn += line.points[i].y / (2 * pi) * laid_.round - places[i].y;
      places[i].y -= laid_.round * line.sheets[i];
    }
    turn_of_.push_back(turn / static_cast<double>(places.size()));
    return true;
  }

  std::vector<Index> directions_of(const LineAbout& line) const {
    if (line.rounds == 0) return loop_turns(line.points, 0);
    const std::optional<Index> rows =
        line.rounds > 0 ? std::nullopt : std::optional<Index>(-laid_.round);
    return line_turns(line.points, {0, 2 * pi * line.rounds}, rows);
  }

  /// Between the line and column 0.
  double cells_left_of(const LatticeLoop& loop) const {
    const std::vector<LatticePlace>& p = loop.places;
    double cells = 0;
    for (std::size_t k = 0; k < p.size(); ++k) {
      const Index y = p[(k + 1) % p.size()].y - p[k].y;
      cells += p[k].x * (y > 1 ? y - laid_.round : y < -1 ? y + laid_.round : y);
    }
    return cells;
  }

  static constexpr Index fewest_round = 4;

  const BoundaryMesh& boundary_;
  std::vector<std::vector<Index>> borders_;
  LaidLoops laid_;
  std::vector<double> turn_of_;  // #loops  rows by which the angle is ahead of the places
};

}  // namespace

std::optional<LaidLoops> laid_in_plane(const BoundaryMesh& boundary, const TriMesh& triangles) {
  const double axis = axis_of(boundary);
  LaidLoops laid;
  for (const std::vector<Index>& nodes : border_loops(boundary)) {
    laid.loops.push_back(along(nodes, loop_turns(points_of(boundary, nodes), axis)));
    if (laid.loops.back().places.empty()) return std::nullopt;
  }
  if (laid.loops.empty() || !may_place(laid, 1, boundary, triangles)) return std::nullopt;
  if (!place_holes(triangles, 1, laid)) return std::nullopt;
  return laid;
}

std::optional<LaidLoops> laid_round(const BoundaryMesh& boundary, const TriMesh& triangles,
                                    double wanted) {
  auto borders = border_loops(boundary);
  if (borders.size() < 2) return std::nullopt;
  auto laid = RingLoops(boundary, std::move(borders)).run(wanted);
  if (!laid || !may_place(*laid, 2, boundary, triangles)) return std::nullopt;
  if (!place_holes(triangles, 2, *laid)) return std::nullopt;
  return laid;
}

}  // namespace lpq
