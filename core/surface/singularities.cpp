// The index of a vertex: how often a cross turns, against parallel transport, on a walk round it,
// plus four times the vertex's angle defect; both in quarters. Angles enter as unit complex numbers
// halved by square roots, and whole turns are counted where the running product crosses the
// negative real axis. What two neighbouring vertices see of one edge cancels exactly, so the sum
// over a closed surface is 4 chi whatever the rounding.
#include <cmath>

#include "base/sort_numbers.h"
#include "field/field.h"
#include "surface/cross_field.h"
#include "surface/fans.h"
#include "surface/frames.h"

namespace lpq {
namespace {

struct Turning {
  Vec2 at{1, 0};
  int turns = 0;

  /// By less than half a turn.
  void by(Vec2 rotation) {
    const Vec2 to = complex_product(at, rotation);
    const double side = cross(at, to);
    if (at.y >= 0 && to.y < 0 && side > 0) ++turns;
    if (at.y < 0 && to.y >= 0 && side < 0) --turns;
    at = to;
  }
};

// Half of what z turns across each half-edge, at most a quarter turn; opposite on its twin.
std::vector<Vec2> half_turns(const SurfaceMesh& mesh, std::span<const Vec2> z) {
  const std::vector<Vec2> transport = cross_transport(mesh);
  std::vector<Vec2> half(mesh.twins.size(), {1, 0});
  for (Index e = 0; e < static_cast<Index>(mesh.twins.size()); ++e) {
    const Index twin = mesh.twins[e];
    if (twin == none || twin < e) continue;
    const Vec2 arrived = complex_product(transport[e], z[triangle_of(e)]);
    half[e] = unit_root(complex_product(z[triangle_of(twin)], conjugate(arrived)));
    half[twin] = conjugate(half[e]);
  }
  return half;
}

Vec2 unit(Vec2 a) {
  const double norm = length(a);
  return norm > 0 ? (1 / norm) * a : Vec2{1, 0};
}

// Half the angle at corner e, as a unit complex number in the first quadrant.
Vec2 half_corner(const TriangleLayout& layout, Index k) {
  const Vec2 out = unit(layout.side[k]), in = unit(layout.side[(k + 2) % 3]);
  return unit_root(unit({-dot(out, in), std::abs(cross(out, in))}));
}

}  // namespace

std::vector<SurfaceSingularity> find_surface_singularities(const SurfaceMesh& mesh,
                                                           std::span<const Vec2> z) {
  const std::vector<Vec2> half = half_turns(mesh, z);
  const SurfaceFans fans = fans_of(mesh.twins);
  std::vector<SurfaceSingularity> result;
  for (Index f = 0; f < fans.count(); ++f) {
    if (!fans.closed[f]) continue;
    Turning turning;
    for (const Index e : fans.corners.row(f)) {
      const Vec2 corner = conjugate(half_corner(layout_of(mesh, triangle_of(e)), e % 3));
      for (int i = 0; i < 8; ++i) turning.by(corner);
      const Index left = prev_in_triangle(e);
      turning.by(half[left]);
      turning.by(half[left]);
    }
    const int index = 4 + turning.turns;  // a flat vertex is 2 pi: four whole turns of z
    if (index != 0) result.push_back({mesh.origin(fans.corners.row(f)[0]), index});
  }
  sort_values(result, [](const auto& a, const auto& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.index < b.index;
  });
  return result;
}

}  // namespace lpq
