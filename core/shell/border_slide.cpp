// See border_slide.h.
#include "shell/border_slide.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cleanup/quad_topology.h"
#include "cleanup/untangle.h"

namespace lpq {
namespace {

constexpr int most_rounds = 8;
constexpr double least_cosine = 0.98;  // of the turn at a node where the border is straight
// Of the way to the next node, and to the one before.
constexpr std::array<double, 4> shares{0.12, 0.24, 0.36, 0.48};

double sine(Vec2 a, Vec2 b) {
  return cross(a, b) / std::sqrt(squared_length(a) * squared_length(b));
}

class Slider {
 public:
  Slider(QuadMesh grid, const std::vector<std::vector<Index>>& loops)
      : grid_(std::move(grid)),
        faces_at_(faces_at_vertices(grid_)),
        ways_(static_cast<std::size_t>(grid_.fixed)) {
    for (const std::vector<Index>& loop : loops)
      for (std::size_t k = 0, n = loop.size(); k < n; ++k)
        add(loop[(k + n - 1) % n], loop[k], loop[(k + 1) % n]);
  }

  bool run() {
    for (int round = 0; round < most_rounds; ++round) {
      const std::vector<Index> bent = invalid_faces(grid_);
      if (bent.empty()) return true;
      for (const Index f : bent)
        for (const Index v : grid_.faces[f])
          if (v < grid_.fixed && ways_[v].is_straight) slide(v);
      untangle(grid_);
    }
    return invalid_faces(grid_).empty();
  }

 private:
  /// From where a node was, to the nodes beside it.
  struct Ways {
    Vec2 from, back, ahead;
    bool is_straight = false;
  };

  void add(Index before, Index v, Index after) {
    const std::vector<Vec2>& p = grid_.points;
    Ways& ways = ways_[v];
    ways = {p[v], p[before] - p[v], p[after] - p[v]};
    const double size = std::sqrt(squared_length(ways.back) * squared_length(ways.ahead));
    ways.is_straight = -dot(ways.back, ways.ahead) > least_cosine * size;
  }

  void slide(Index v) {
    const Ways& ways = ways_[v];
    Vec2 best = grid_.points[v];
    double most = worst_corner(v);
    for (const Vec2 way : {ways.back, ways.ahead})
      for (const double share : shares) {
        grid_.points[v] = ways.from + share * way;
        const double worst = worst_corner(v);
        if (!(worst > most)) continue;
        most = worst;
        best = grid_.points[v];
      }
    grid_.points[v] = best;
  }

  /// The least sine of a corner of a quad at v.
  double worst_corner(Index v) const {
    double worst = 1;
    for (const Index f : faces_at_.row(v)) {
      const Face& face = grid_.faces[f];
      for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 p = grid_.points[face[k]];
        worst = std::min(
            worst, sine(grid_.points[face[(k + 1) % 4]] - p, grid_.points[face[(k + 3) % 4]] - p));
      }
    }
    return worst;
  }

  QuadMesh grid_;
  Csr<Index> faces_at_;     // #V
  std::vector<Ways> ways_;  // #fixed
};

}  // namespace

bool is_convex_after_sliding(QuadMesh grid, const std::vector<std::vector<Index>>& loops) {
  return Slider(std::move(grid), loops).run();
}

}  // namespace lpq
