#include "cleanup/star_centre.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "cleanup/quad_topology.h"

namespace lpq {
namespace {

constexpr double reach = 2;             // half width of the box searched, in units of the size
constexpr std::size_t most_lines = 27;  // nine quads: beyond, all triples take too long
constexpr double finest_step = 1e-3;    // of the search for larger stars
constexpr double tolerance = 1e-12;     // of a distance, in units of the size
constexpr double parallel = 1e-10;      // least determinant of three unit rows worth dividing by

// Signed distance to a directed line, positive on its left: dot(normal, x) + offset, with x the
// displacement of v in units of its size.
struct Line {
  Vec2 normal;
  double offset = 0;
  double distance(Vec2 x) const { return dot(normal, x) + offset; }
};

class Kernel {
 public:
  void keep_left_of(Vec2 a, Vec2 b) {
    const double size = length(b - a);
    if (!(size > 0)) return;
    const Vec2 normal = (1 / size) * perpendicular(b - a);
    lines_.push_back({normal, -dot(normal, a)});
  }

  double least_distance(Vec2 x) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Line& line : lines_) least = std::min(least, line.distance(x));
    return least;
  }

  // The line that was too near before mostly is so again.
  bool is_farther(Vec2 x, double than) const {
    if (lines_[nearest_].distance(x) <= than) return false;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (lines_[i].distance(x) <= than) {
        nearest_ = i;
        return false;
      }
    return true;
  }

  // At the optimum of "largest t with distance_i(x) >= t" three conditions are tight. There are
  // few, so all triples are tried; ties keep the first.
  Vec2 centre() const { return lines_.size() <= most_lines ? exact_centre() : searched_centre(); }

 private:
  Vec2 exact_centre() const {
    Vec2 best;
    double best_distance = least_distance(best);
    const std::size_t n = lines_.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        for (std::size_t k = j + 1; k < n; ++k) {
          Vec2 x;
          if (!equidistant(lines_[i], lines_[j], lines_[k], x)) continue;
          if (std::max(std::abs(x.x), std::abs(x.y)) > reach) continue;
          if (!is_farther(x, best_distance + tolerance)) continue;
          best = x;
          best_distance = least_distance(x);
        }
    return best;
  }

  // For very many faces: a compass search, which need not find the best but never makes it worse.
  Vec2 searched_centre() const {
    Vec2 best;
    double best_distance = least_distance(best);
    for (double step = 0.5 * reach; step > finest_step; step *= 0.5) {
      const Vec2 at = best;
      for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy) {
          const Vec2 x = at + Vec2{step * dx, step * dy};
          if (!is_farther(x, best_distance + tolerance)) continue;
          best = x;
          best_distance = least_distance(x);
        }
    }
    return best;
  }

  static bool equidistant(const Line& a, const Line& b, const Line& c, Vec2& x) {
    const Vec2 ab = a.normal - b.normal, ac = a.normal - c.normal;
    const double determinant = cross(ab, ac);
    if (std::abs(determinant) < parallel) return false;
    const double p = b.offset - a.offset, q = c.offset - a.offset;
    x = (1 / determinant) * Vec2{p * ac.y - q * ab.y, q * ab.x - p * ac.x};
    return true;
  }

  std::vector<Line> lines_;
  mutable std::size_t nearest_ = 0;
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
