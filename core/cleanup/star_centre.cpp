#include "cleanup/star_centre.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "cleanup/quad_topology.h"
#include "geometry/vec3.h"

namespace lpq {
namespace {

constexpr double reach = 2;            // half width of the box searched, in units of the size
constexpr double tolerance = 1e-12;    // of a distance, in units of the size
constexpr double nearly_tight = 1e-9;  // a distance that may be the least but for rounding
constexpr double parallel = 1e-10;     // least determinant of three unit rows worth dividing by
constexpr double least_pivot = 1e-12;  // of an exchange, and least determinant of tight rows
constexpr int most_exchanges = 64;     // should rounding lead round in a circle

// The linear programme in z = (x, y, t), with (x, y) the displacement of v in units of its size:
// the largest t with dot(normal, z) + offset >= 0 for every row. A row is a directed line, of which
// (x, y) is to be left by t at least, or a side of the box.
struct Row {
  Vec3 normal;
  double offset = 0;

  double value(Vec3 z) const { return dot(normal, z) + offset; }
};

class Kernel {
 public:
  void keep_left_of(Vec2 a, Vec2 b) {
    const double size = length(b - a);
    if (!(size > 0)) return;
    const Vec2 normal = (1 / size) * perpendicular(b - a);
    lines_.push_back({{normal.x, normal.y, -1}, -dot(normal, a)});
  }

  double least_distance(Vec2 x) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Row& line : lines_) least = std::min(least, line.value({x.x, x.y, 0}));
    return least;
  }

  /// By the dual simplex method [L54]: three rows are tight; the one that is violated most
  /// takes the place of one of them, until none is. Where rounding ends that early, the best place
  /// seen.
  Vec2 centre() const {
    Vec2 best;
    if (lines_.empty()) return best;
    const double at_start = least_distance(best);
    double best_distance = at_start;
    std::array<Row, 3> tight = first_rows(lines_[0]);
    for (int exchange = 0; exchange < most_exchanges; ++exchange) {
      std::array<Vec3, 3> dual;
      if (!invert(tight, dual)) break;
      Vec3 z;
      for (int k = 0; k < 3; ++k) z -= tight[k].offset * dual[k];
      const Row worst = most_violated(z);
      const Vec2 x{z.x, z.y};
      if (const double distance = least_distance(x);
          is_in_box(x) && distance > best_distance + tolerance) {
        best = x;
        best_distance = distance;
      }
      if (worst.value(z) >= -tolerance || !exchange_for(worst, dual, tight)) break;
    }
    return best_distance > at_start ? from_first_lines(best, best_distance) : best;
  }

 private:
  // Farthest left of one line within the box.
  static std::array<Row, 3> first_rows(const Row& line) {
    const double x = line.normal.x < 0 ? 1 : -1, y = line.normal.y < 0 ? 1 : -1;
    return {line, Row{{x, 0, 0}, reach}, Row{{0, y, 0}, reach}};
  }

  // dot(dual[i], normal of rows[k]) is 1 for i = k, else 0.
  static bool invert(const std::array<Row, 3>& rows, std::array<Vec3, 3>& dual) {
    const double determinant = dot(rows[0].normal, cross(rows[1].normal, rows[2].normal));
    if (!(std::abs(determinant) > least_pivot)) return false;
    for (int k = 0; k < 3; ++k)
      dual[k] = (1 / determinant) * cross(rows[(k + 1) % 3].normal, rows[(k + 2) % 3].normal);
    return true;
  }

  Row most_violated(Vec3 z) const {
    Row worst = lines_[0];
    const auto look_at = [&](const Row& row) {
      if (row.value(z) < worst.value(z)) worst = row;
    };
    for (const Row& line : lines_) look_at(line);
    for (const double side : {1.0, -1.0}) {
      look_at({{side, 0, 0}, reach});
      look_at({{0, side, 0}, reach});
    }
    return worst;
  }

  // In place of the row whose multiplier becomes zero first, so that none becomes negative.
  static bool exchange_for(const Row& row, const std::array<Vec3, 3>& dual,
                           std::array<Row, 3>& tight) {
    int leaving = -1;
    double least = 0;
    for (int k = 0; k < 3; ++k) {
      const double pivot = dot(row.normal, dual[k]);
      if (pivot < least_pivot) continue;
      const double ratio = -dual[k].z / pivot;
      if (leaving >= 0 && ratio >= least) continue;
      leaving = k;
      least = ratio;
    }
    if (leaving >= 0) tight[leaving] = row;
    return leaving >= 0;
  }

  // The same place from the first three lines that are nearest to it: its last bits do not depend
  // on the way it was found.
  Vec2 from_first_lines(Vec2 best, double least) const {
    std::vector<Row> nearest;
    for (const Row& line : lines_)
      if (line.value({best.x, best.y, 0}) < least + nearly_tight) nearest.push_back(line);
    const std::size_t n = nearest.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        for (std::size_t k = j + 1; k < n; ++k) {
          Vec2 x;
          if (equidistant(nearest[i], nearest[j], nearest[k], x) && is_in_box(x) &&
              least_distance(x) > least - tolerance)
            return x;
        }
    return best;
  }

  static bool equidistant(const Row& a, const Row& b, const Row& c, Vec2& x) {
    const Vec3 ab = a.normal - b.normal, ac = a.normal - c.normal;
    const double determinant = ab.x * ac.y - ab.y * ac.x;
    if (std::abs(determinant) < parallel) return false;
    const double p = b.offset - a.offset, q = c.offset - a.offset;
    x = (1 / determinant) * Vec2{p * ac.y - q * ab.y, q * ab.x - p * ac.x};
    return true;
  }

  static bool is_in_box(Vec2 x) {
    return std::max(std::abs(x.x), std::abs(x.y)) <= reach + tolerance;
  }

  std::vector<Row> lines_;
};

}  // namespace

StarCentre star_centre(std::span<const Vec2> points, std::span<const Face> all,
                       std::span<const Index> faces, Index v, double size) {
  const Vec2 origin = points[v];
  const auto local = [&](Index w) { return (1 / size) * (points[w] - origin); };
  Kernel kernel;
  for (const Index f : faces) {
    const Face& face = all[f];
    const Index k = corner_of(face, v);
    const Vec2 next = local(next_corner(face, k)), prev = local(prev_corner(face, k));
    kernel.keep_left_of(next, prev);  // the corner at v itself: v before the diagonal
    if (face[3] == none) continue;
    const Vec2 opposite = local(face[(k + 2) & 3]);
    kernel.keep_left_of(next, opposite);
    kernel.keep_left_of(opposite, prev);
  }
  StarCentre result;
  const Vec2 x = kernel.centre();
  result.before = kernel.least_distance({});
  result.after = kernel.least_distance(x);
  result.position = origin + size * x;
  return result;
}

}  // namespace lpq
