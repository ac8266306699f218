// See submapped_grid.h.
#include "shell/grids/submapped_grid.h"

#include <algorithm>

#include "cleanup/untangle.h"
#include "geometry/polygon.h"
#include "numerics/elementary.h"
#include "shell/grids/border_slide.h"
#include "shell/grids/hole_places.h"
#include "shell/grids/loop_turns.h"
#include "shell/grids/springs.h"

namespace lpq {
namespace {

/// The nodes of the border's loops, the domain on their left; empty if something divides the
/// inside.
std::vector<LatticeLoop> loops_of(const BoundaryMesh& boundary) {
  std::vector<Index> next(boundary.points.size(), none);
  for (const Segment& edge : boundary.edges) {
    const bool inside = edge.left != none && edge.right != none;
    const Index from = edge.left != none ? edge.a : edge.b;
    if (inside || next[from] != none) return {};
    next[from] = edge.left != none ? edge.b : edge.a;
  }
  std::vector<LatticeLoop> loops;
  std::vector<char> done(next.size(), 0);
  for (std::size_t first = 0; first < next.size(); ++first) {
    if (done[first]) continue;
    loops.emplace_back();
    for (auto v = static_cast<Index>(first); !done[v]; v = next[v]) {
      if (next[v] == none) return {};
      done[v] = 1;
      loops.back().nodes.push_back(v);
    }
  }
  return loops;
}

/// The direction that most of the border keeps, but for quarter turns.
double axis_of(const BoundaryMesh& boundary) {
  const auto square = [](Vec2 z) { return Vec2{z.x * z.x - z.y * z.y, 2 * z.x * z.y}; };
  Vec2 sum;
  for (const Segment& edge : boundary.edges) {
    const Vec2 d = boundary.points[edge.b] - boundary.points[edge.a];
    const double size = length(d);
    sum += (1 / (size * size * size)) * square(square(d));
  }
  return arc_tangent(sum.y, sum.x) / 4;
}

/// Lays all loops, each beginning at {0, 0}, the outer one first. False if one does not close.
bool lay_loops(const BoundaryMesh& boundary, std::vector<LatticeLoop>& loops) {
  const double axis = axis_of(boundary);
  std::vector<Vec2> points;
  for (LatticeLoop& loop : loops) {
    points.clear();
    for (const Index v : loop.nodes) points.push_back(boundary.points[v]);
    LatticePlace place;
    for (const Index d : loop_turns(points, axis)) {
      loop.places.push_back(place);
      place = place + lattice_step(d);
    }
    if (loop.places.empty()) return false;
    if (signed_area(points) > 0) std::swap(loops.front(), loop);
  }
  return !loops.empty();
}

constexpr double most_off = 1.5;

/// But for some quads, and half a one at every edge of the border: counts are whole.
bool is_near(double quads, double wanted, double border_edges) {
  const double rounding = 4 + 0.5 * border_edges;
  return quads < most_off * (wanted + rounding) && wanted < most_off * (quads + rounding);
}

/// The nodes stay, every other vertex lies between its neighbours.
QuadMesh in_the_plane(const BoundaryMesh& boundary, LatticeQuads quads) {
  QuadMesh grid;
  grid.points = boundary.points;
  grid.fixed = static_cast<Index>(grid.points.size());
  const Segment& edge = boundary.edges[0];
  grid.region.assign(quads.faces.size(), edge.left != none ? edge.left : edge.right);
  grid.faces = std::move(quads.faces);
  std::vector<Index> body(grid.points.size(), none);
  for (Index b = 0; b < quads.inside; ++b) body.push_back(b);
  grid.points.resize(body.size());
  Springs springs(std::move(body), grid.points, quads.inside);
  for (const Face& face : grid.faces)
    for (int k = 0; k < 4; ++k) springs.add(face[k], face[(k + 1) % 4]);
  const std::vector<Vec2> at = springs.rest();
  std::copy(at.begin(), at.end(), grid.points.begin() + grid.fixed);
  return grid;
}

// The share of quads that may be tangled before positions are looked for that undo it, and after
// that: nodes of the border will slide along their curves.
constexpr double most_tangled = 0.2, most_left = 0.02;

bool make_convex(QuadMesh& grid, const std::vector<LatticeLoop>& loops) {
  const auto faces = static_cast<double>(grid.faces.size());
  const auto tangled = static_cast<double>(invalid_faces(grid).size());
  if (tangled == 0) return true;
  if (tangled > most_tangled * faces) return false;
  untangle(grid);
  const auto left = static_cast<double>(invalid_faces(grid).size());
  return left == 0 || (left <= most_left * faces && is_convex_after_sliding(grid, loops));
}

}  // namespace

bool touches_border(const QuadMesh& grid, const Face& face) {
  return std::any_of(face.begin(), face.end(), [&](Index v) { return v < grid.fixed; });
}

std::optional<QuadMesh> submapped_grid(const BoundaryMesh& boundary, const TriMesh& triangles,
                                       double wanted) {
  std::vector<LatticeLoop> loops = loops_of(boundary);
  if (!lay_loops(boundary, loops)) return std::nullopt;
  const auto nodes = static_cast<Index>(boundary.points.size());
  if (loops.size() > 1 && (triangles.fixed != nodes || !place_holes(triangles, loops)))
    return std::nullopt;
  const auto border = static_cast<double>(boundary.edges.size());
  // A face that fills less than a tenth of the lattice that it spans is no grid.
  auto quads = lattice_quads(loops, nodes, 10 * (wanted + border));
  if (!quads || !is_near(static_cast<double>(quads->faces.size()), wanted, border))
    return std::nullopt;
  QuadMesh grid = in_the_plane(boundary, std::move(*quads));
  if (!make_convex(grid, loops)) return std::nullopt;
  return grid;
}

}  // namespace lpq
