#include "surface/bends.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "base/sort_numbers.h"
#include "geometry/segment.h"
#include "numerics/elementary.h"
#include "surface/curves.h"

namespace lpq {
namespace {

// In mesh sizes from the middle of the bend.
constexpr double inner = 0.25, outer = 1, wide_inner = 1.25, wide_outer = 2;
constexpr double half_chord = 0.5, apart = 0.75, from_ends = 1.5;
constexpr double shortest_loop = 6;
// How much more a curve may turn in the wide window: the ends of slots turn on, corners do not.
constexpr double turns_on = 1.3, turns_on_degrees = 10;

/// One curve by arc length; closed ones go round.
class Line {
 public:
  Line(const SurfaceMesh& mesh, std::span<const Index> vertices, bool loop) : loop_(loop) {
    for (const Index v : vertices) {
      at_.push_back(points_.empty() ? 0 : at_.back() + distance(points_.back(), mesh.points[v]));
      points_.push_back(mesh.points[v]);
    }
  }

  double length() const { return at_.back(); }
  double at(std::size_t k) const { return at_[k]; }

  Vec3 point(double s) const {
    if (loop_) {
      if (s < 0) s += length();
      if (s > length()) s -= length();
    }
    s = std::clamp(s, 0.0, length());
    const auto next = std::upper_bound(at_.begin() + 1, at_.end() - 1, s);
    const auto k = static_cast<std::size_t>(next - at_.begin());
    const double whole = at_[k] - at_[k - 1];
    const double t = whole > 0 ? (s - at_[k - 1]) / whole : 0;
    return points_[k - 1] + t * (points_[k] - points_[k - 1]);
  }

  /// Angle in degrees between the chords from s - to to s - from and from s + from to s + to.
  double turn(double s, double from, double to) const {
    const Vec3 in = point(s - from) - point(s - to), out = point(s + to) - point(s + from);
    return arc_tangent(lpq::length(cross(in, out)), dot(in, out)) * (180 / pi);
  }

 private:
  bool loop_;
  std::vector<Vec3> points_;
  std::vector<double> at_;
};

class BendFinder {
 public:
  BendFinder(const SurfaceMesh& mesh, std::span<const double> size, double angle,
             SurfaceFeatures& features)
      : mesh_(mesh), size_(size), angle_(angle), features_(features) {}

  void run() {
    const SurfaceCurves curves = trace_curves(mesh_, features_);
    for (Index c = 0; c < curves.count(); ++c) search(curves.vertices.row(c), curves.is_loop[c]);
  }

 private:
  struct Bend {
    double depth, at;
    Index vertex;
  };

  void search(std::span<const Index> vertices, bool loop) {
    const Line line(mesh_, vertices, loop);
    std::vector<Bend> bends;
    for (std::size_t k = loop ? 0 : 1; k + 1 < vertices.size(); ++k) {
      const double h = size_[vertices[k]], s = line.at(k);
      if (loop ? line.length() < shortest_loop * h : std::min(s, line.length() - s) < from_ends * h)
        continue;
      if (is_bend(line, s, h)) bends.push_back({depth(line, s, h), s, vertices[k]});
    }
    sort_values(bends, [](const Bend& a, const Bend& b) {
      return a.depth != b.depth ? a.depth > b.depth : a.at < b.at;
    });
    std::vector<double> taken;  // ascending
    for (const Bend& bend : bends) {
      const double whole = loop ? line.length() : std::numeric_limits<double>::infinity();
      if (!taken.empty() && distance_to(taken, bend.at, whole) < apart * size_[bend.vertex])
        continue;
      taken.insert(std::lower_bound(taken.begin(), taken.end(), bend.at), bend.at);
      features_.corner[bend.vertex] = 1;
    }
  }

  /// Least distance of s from those taken, on a line that closes after `whole`: on the way round
  /// the first and the last are nearest.
  static double distance_to(const std::vector<double>& taken, double s, double whole) {
    const double far = std::max(std::abs(s - taken.front()), std::abs(s - taken.back()));
    double least = whole - far;
    const auto next = std::lower_bound(taken.begin(), taken.end(), s);
    if (next != taken.end()) least = std::min(least, *next - s);
    if (next != taken.begin()) least = std::min(least, s - *std::prev(next));
    return least;
  }

  bool is_bend(const Line& line, double s, double h) const {
    const double turn = line.turn(s, inner * h, outer * h);
    return turn >= angle_ &&
           line.turn(s, wide_inner * h, wide_outer * h) <= turns_on * turn + turns_on_degrees;
  }

  /// Distance of the curve from its chord over a mesh size.
  static double depth(const Line& line, double s, double h) {
    const Vec3 a = line.point(s - half_chord * h), b = line.point(s + half_chord * h);
    return std::sqrt(squared_distance_to_segment(line.point(s), a, b));
  }

  const SurfaceMesh& mesh_;
  std::span<const double> size_;
  double angle_;
  SurfaceFeatures& features_;
};

}  // namespace

void mark_bends(const SurfaceMesh& mesh, std::span<const double> size, double bend_angle,
                SurfaceFeatures& features) {
  BendFinder(mesh, size, bend_angle, features).run();
}

}  // namespace lpq
