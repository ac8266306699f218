// See submapped_grid.h.
#include "grids/submapped_grid.h"

#include <algorithm>

#include "cleanup/untangle.h"
#include "grids/laid_borders.h"
#include "grids/springs.h"

namespace lpq {
namespace {

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
// that.
constexpr double most_tangled = 0.2, most_left = 0.02;

/// All but the few that may be left.
bool make_convex(QuadMesh& grid) {
  const auto faces = static_cast<double>(grid.faces.size());
  const auto tangled = static_cast<double>(invalid_faces(grid).size());
  if (tangled == 0) return true;
  if (tangled > most_tangled * faces) return false;
  untangle(grid);
  return static_cast<double>(invalid_faces(grid).size()) <= most_left * faces;
}

std::optional<QuadMesh> grid_between(const std::optional<LaidLoops>& laid,
                                     const BoundaryMesh& boundary, double wanted) {
  if (!laid) return std::nullopt;
  const auto nodes = static_cast<Index>(boundary.points.size());
  const auto border = static_cast<double>(boundary.edges.size());
  // A face that fills less than a tenth of the lattice that it spans is no grid.
  auto quads = lattice_quads(*laid, nodes, 10 * (wanted + border));
  if (!quads || !is_near(static_cast<double>(quads->faces.size()), wanted, border))
    return std::nullopt;
  QuadMesh grid = in_the_plane(boundary, std::move(*quads));
  if (!make_convex(grid)) return std::nullopt;
  return grid;
}

}  // namespace

bool touches_border(const QuadMesh& grid, const Face& face) {
  return std::any_of(face.begin(), face.end(), [&](Index v) { return v < grid.fixed; });
}

std::optional<QuadMesh> submapped_grid(const BoundaryMesh& boundary, const TriMesh& triangles,
                                       double wanted) {
  return grid_between(laid_in_plane(boundary, triangles), boundary, wanted);
}

std::optional<QuadMesh> ring_grid(const BoundaryMesh& boundary, const TriMesh& triangles,
                                  double wanted) {
  return grid_between(laid_round(boundary, triangles, wanted), boundary, wanted);
}

}  // namespace lpq
