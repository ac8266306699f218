#include "field/background.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "delaunay/delaunay.h"
#include "field/inside.h"
#include "geometry/box.h"
#include "geometry/predicates.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

// A leaf may exceed the size asked for by this factor: leaf sizes are powers of two of the root,
// so they then lie within 5/8 .. 5/4 of it.
constexpr double leaf_slack = 1.25;
// Interior points keep this share of their leaf's side off the walls. Below one half, so that only
// walls through the leaf itself can come that near.
constexpr double wall_clearance = 0.45;
// A triangle of the coarse mesh lower than this share of the leaf asked for holds no new point; to
// refine along it would only fill a needle's surroundings with cells.
constexpr double thinnest = 0.25;

// A root with a leaf level equal to the median spacing, placed so that leaf centres of that level
// fall on multiples of it from the domain's lower left corner: an axis-parallel square gets the
// background that its ideal mesh has.
Quadtree root_for(const BoundaryMesh& boundary) {
  const Box box = box_of(boundary.points);
  std::vector<double> spacing;
  for (const double s : boundary.spacing)
    if (s > 0) spacing.push_back(s);
  std::sort(spacing.begin(), spacing.end());
  const double extent = longer_side(box);
  const double unit = spacing.empty() ? extent : spacing[spacing.size() / 2];
  double side = unit;
  while (side < extent + unit) side *= 2;
  return Quadtree({box.lo.x - 0.5 * unit, box.lo.y - 0.5 * unit}, side);
}

// Whether the box meets the segment, or the triangle: no axis and no edge separates them.
bool edge_separates(const Quadtree::Box& box, Vec2 a, Vec2 b) {  // box entirely right of a -> b
  const Vec2 d = b - a;
  const Vec2 leftmost{box.low.x + (d.y < 0 ? box.side : 0), box.low.y + (d.x > 0 ? box.side : 0)};
  return cross(d, leftmost - a) < 0;
}

template <std::size_t n>
bool box_misses(const Quadtree::Box& box, const std::array<Vec2, n>& p) {
  double low_x = p[0].x, high_x = low_x, low_y = p[0].y, high_y = low_y;
  for (const Vec2 q : p) {
    low_x = std::min(low_x, q.x), high_x = std::max(high_x, q.x);
    low_y = std::min(low_y, q.y), high_y = std::max(high_y, q.y);
  }
  return low_x > box.low.x + box.side || high_x < box.low.x || low_y > box.low.y + box.side ||
         high_y < box.low.y;
}

bool meets_segment(const Quadtree::Box& box, Vec2 a, Vec2 b) {
  return !box_misses(box, std::array{a, b}) && !edge_separates(box, a, b) &&
         !edge_separates(box, b, a);
}

bool meets_triangle(const Quadtree::Box& box, const std::array<Vec2, 3>& p) {
  return !box_misses(box, p) && !edge_separates(box, p[0], p[1]) &&
         !edge_separates(box, p[1], p[2]) && !edge_separates(box, p[2], p[0]);
}

// Barycentric weights of the box's centre, moved into the triangle.
void clamped_weights(Vec2 c, const std::array<Vec2, 3>& p, double (&weights)[3]) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    weights[k] = std::max(cross(p[(k + 2) % 3] - p[(k + 1) % 3], c - p[(k + 1) % 3]), 0.0);
    sum += weights[k];
  }
  for (double& w : weights) w = sum > 0 ? w / sum : 1.0 / 3;
}

bool contains(const std::array<Vec2, 3>& p, Vec2 c) {
  return orient2d(p[0], p[1], c) >= 0 && orient2d(p[1], p[2], c) >= 0 &&
         orient2d(p[2], p[0], c) >= 0;
}

// Least height: twice the area over the longest edge.
double height_of(const std::array<Vec2, 3>& p) {
  const double longest2 = std::max(
      {squared_length(p[1] - p[0]), squared_length(p[2] - p[1]), squared_length(p[0] - p[2])});
  return cross(p[1] - p[0], p[2] - p[0]) / std::sqrt(longest2);
}

std::array<Vec2, 3> corners(const TriMesh& mesh, Index t) {
  const Tri& tri = mesh.triangles[t];
  return {mesh.points[tri[0]], mesh.points[tri[1]], mesh.points[tri[2]]};
}

}  // namespace

BackgroundBuilder::BackgroundBuilder(const BoundaryMesh& boundary,
                                     const std::vector<Source>& sources, double coarsest)
    : boundary_(boundary), tree_(root_for(boundary)) {
  for (std::size_t i = 0; i < boundary.points.size(); ++i)
    if (boundary.spacing[i] > 0)
      tree_.refine_at(boundary.points[i], leaf_slack * boundary.spacing[i]);
  for (const Segment& s : boundary.edges) {
    const Vec2 a = boundary.points[s.a], b = boundary.points[s.b];
    tree_.refine_at(midpoint(a, b), leaf_slack * distance(a, b));
  }
  refine(sources);
  if (coarsest > 0) refine_inside(coarsest);
  tree_.balance();
}

/// Nothing outside: there may be far more of it than of the domain.
void BackgroundBuilder::refine_inside(double coarsest) {
  Quadtree walls = root_for(boundary_);
  for (const Segment& s : boundary_.edges)
    walls.descend([&](Index cell, const Quadtree::Box& box) {
      if (!meets_segment(box, boundary_.points[s.a], boundary_.points[s.b])) return false;
      if (walls.is_leaf(cell) && box.side > coarsest) walls.split(cell);
      return true;
    });
  std::vector<Vec2> centres;
  for (Index cell = 0; cell < walls.cell_count(); ++cell)
    centres.push_back(walls.box(cell).centre());
  const std::vector<Index> region = regions_of(boundary_, centres);
  tree_.descend([&](Index cell, const Quadtree::Box& box) {
    if (box.side <= coarsest) return false;
    const Index leaf = walls.leaf_at(box.centre());
    const bool crossed = walls.box(leaf).side < box.side;
    if (!crossed && region[leaf] == none) return false;
    if (tree_.is_leaf(cell)) tree_.split(cell);
    return true;
  });
}

void BackgroundBuilder::refine(const std::vector<Source>& sources) {
  for (const Source& s : sources) tree_.refine_at(s.position, leaf_slack * s.side);
}

// Leaves whose centre is too near a wall or an isolated node.
std::vector<char> BackgroundBuilder::blocked_leaves() const {
  std::vector<char> blocked(tree_.cell_count(), 0);
  const auto block = [&](Vec2 a, Vec2 b) {
    tree_.descend([&](Index cell, const Quadtree::Box& box) {
      if (!meets_segment(box, a, b)) return false;
      const double least = wall_clearance * box.side;
      if (tree_.is_leaf(cell) && squared_distance_to_segment(box.centre(), a, b) < least * least)
        blocked[cell] = 1;
      return true;
    });
  };
  std::vector<char> on_edge(boundary_.points.size(), 0);
  for (const Segment& s : boundary_.edges) {
    on_edge[s.a] = on_edge[s.b] = 1;
    block(boundary_.points[s.a], boundary_.points[s.b]);
  }
  for (std::size_t i = 0; i < on_edge.size(); ++i)
    if (!on_edge[i]) block(boundary_.points[i], boundary_.points[i]);
  return blocked;
}

Result<TriMesh> BackgroundBuilder::coarse() const {
  const std::vector<char> blocked = blocked_leaves();
  std::vector<Vec2> centres;
  for (Index cell = 0; cell < tree_.cell_count(); ++cell)
    if (tree_.is_leaf(cell) && !blocked[cell]) centres.push_back(tree_.box(cell).centre());
  const std::vector<Index> region = regions_of(boundary_, centres);
  std::vector<Vec2> inside;
  for (std::size_t i = 0; i < centres.size(); ++i)
    if (region[i] != none) inside.push_back(centres[i]);
  return triangulate(boundary_, inside);
}

Problem BackgroundBuilder::split_leaves(const TriMesh& coarse, OnCoarse largest_leaf,
                                        double most_leaves) {
  double weights[3];
  const double most_cells = tree_.cell_count() + most_leaves;
  for (Index t = 0; t < coarse.triangle_count(); ++t) {
    const auto p = corners(coarse, t);
    const double height = height_of(p);
    tree_.descend([&](Index cell, const Quadtree::Box& box) {
      if (!meets_triangle(box, p)) return false;
      if (!tree_.is_leaf(cell)) return true;
      clamped_weights(box.centre(), p, weights);
      const Vec2 q = weights[0] * p[0] + weights[1] * p[1] + weights[2] * p[2];
      const double largest = largest_leaf(t, weights, q);
      if (height < thinnest * largest || box.side <= leaf_slack * largest) return false;
      return tree_.cell_count() < most_cells && tree_.split(cell);
    });
  }
  if (tree_.cell_count() < most_cells) return std::nullopt;
  return Error{ErrorCode::too_many_elements,
               "The sizes are so small in places that more elements would be needed than the "
               "limit allows. Use larger sizes or raise maxElements.",
               {}};
}

/// Where the coarse triangle that contains a leaf's centre is known, so is that it lies inside.
BackgroundBuilder::Interior BackgroundBuilder::leaves_inside(const TriMesh& coarse,
                                                             OnCoarse value_at) const {
  const std::vector<char> blocked = blocked_leaves();
  std::vector<double> value(tree_.cell_count(), 0);
  std::vector<char> inside(tree_.cell_count(), 0);
  double weights[3];
  for (Index t = 0; t < coarse.triangle_count(); ++t) {
    const auto p = corners(coarse, t);
    tree_.descend([&](Index cell, const Quadtree::Box& box) {
      if (!meets_triangle(box, p)) return false;
      const Vec2 c = box.centre();
      if (tree_.is_leaf(cell) && !blocked[cell] && !inside[cell] && contains(p, c)) {
        clamped_weights(c, p, weights);
        value[cell] = value_at(t, weights, c);
        inside[cell] = 1;
      }
      return true;
    });
  }
  Interior interior;
  for (Index cell = 0; cell < tree_.cell_count(); ++cell)
    if (inside[cell]) {
      interior.centres.push_back(tree_.box(cell).centre());
      interior.values.push_back(value[cell]);
    }
  return interior;
}

Result<FineBackground> BackgroundBuilder::fine(const TriMesh& coarse, OnCoarse largest_leaf,
                                               OnCoarse interior_value, double most_leaves) {
  if (Problem too_many = split_leaves(coarse, largest_leaf, most_leaves)) return *too_many;
  tree_.balance();
  Interior interior = leaves_inside(coarse, interior_value);
  auto mesh = triangulate(boundary_, interior.centres);
  if (!mesh) return mesh.error();
  return FineBackground{std::move(*mesh), std::move(interior.values)};
}

}  // namespace lpq
