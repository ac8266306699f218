// Square packing along the cross field: a cheap stand-in for frontal Delaunay insertion in the
// maximum norm, and the filler of holes that the phase field leaves.
#include "lpcvt/packing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/csr.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

// Walls are filed at places this far apart (in h), so the query radius grows by half of it.
constexpr double sample_step = 0.5;
constexpr double sample_reach = 0.3;  // half a step, and room for the growth of h

// Triangles round each boundary node, for directions that start there.
Csr<Index> half_edges_at_nodes(const TriMesh& mesh, Index nodes) {
  return csr_from<Index>(nodes, [&](auto&& emit) {
    for (Index e = 0; e < 3 * mesh.triangle_count(); ++e)
      if (mesh.origin(e) < nodes) emit(mesh.origin(e), e);
  });
}

// The triangle at a node that direction d points into, none if it leaves the domain.
Index triangle_towards(const TriMesh& mesh, std::span<const Index> half_edges, Vec2 d) {
  for (const Index e : half_edges) {
    const Vec2 p = mesh.points[mesh.origin(e)];
    const Vec2 right = mesh.points[mesh.target(e)] - p, left = mesh.points[mesh.apex(e)] - p;
    if (cross(right, d) >= 0 && cross(d, left) >= 0) return triangle_of(e);
  }
  return none;
}

// The arm of a cross nearest to direction d.
Vec2 nearest_arm(Vec2 axis, Vec2 d) {
  const double along = dot(axis, d), across = cross(axis, d);
  if (std::abs(along) >= std::abs(across)) return along >= 0 ? axis : -axis;
  return across >= 0 ? perpendicular(axis) : -perpendicular(axis);
}

// Half the diagonal of a square over half its side, rounded up.
constexpr double to_corner = 1.4143;
static_assert(to_corner * to_corner > 2);

// No other point in the square about p along the cross.
bool is_free(const Packing& packing, Vec2 p, const Fields& fields, const FieldSample& f, Index t,
             double separation) {
  const double least = separation * f.h, reach = to_corner * fields.longest_step() * least;
  return !packing.grid.any_near(p, f.h, reach, [&](Index, Vec2 q) {
    const Vec2 way = fields.stretched_at(p, q - p, t);
    return std::abs(dot(f.axis, way)) < least && std::abs(cross(f.axis, way)) < least;
  });
}

}  // namespace

WallDistance::WallDistance(const BoundaryMesh& boundary, const Fields& fields)
    : boundary_(boundary) {
  std::vector<char> on_edge(boundary.points.size(), 0);
  const auto file = [&](Vec2 p, double h, Index segment) {
    samples_.insert(p, h, static_cast<Index>(segment_of_.size()));
    segment_of_.push_back(segment);
  };
  for (std::size_t i = 0; i < boundary.edges.size(); ++i) {
    const Segment& s = boundary.edges[i];
    const Vec2 a = boundary.points[s.a], d = boundary.points[s.b] - a;
    const double ha = fields.h[s.a], hb = fields.h[s.b], total = length(d);
    on_edge[s.a] = on_edge[s.b] = 1;
    for (double t = 0; t < 1;) {  // the size is linear along an edge of the background
      const double h = (1 - t) * ha + t * hb;
      file(a + t * d, h, static_cast<Index>(i));
      t += sample_step * h / total;
    }
  }
  for (std::size_t v = 0; v < on_edge.size(); ++v)
    if (!on_edge[v]) file(boundary.points[v], fields.h[v], none);
}

bool WallDistance::nearer_than(Vec2 p, double h, double r) const {
  return samples_.any_near(p, h, r + sample_reach * h, [&](Index sample, Vec2 q) {
    const Index i = segment_of_[sample];
    if (i == none) return squared_length(q - p) < r * r;
    const Segment& s = boundary_.edges[i];
    return squared_distance_to_segment(p, boundary_.points[s.a], boundary_.points[s.b]) < r * r;
  });
}

Packing::Packing(const BoundaryMesh& boundary, const Fields& fields)
    : fixed(static_cast<Index>(boundary.points.size())) {
  for (Index v = 0; v < fixed; ++v) add(boundary.points[v], fields.h[v], none);
}

void Packing::add(Vec2 p, double h, Index background_triangle) {
  grid.insert(p, h, static_cast<Index>(points.size()));
  points.push_back(p);
  triangle.push_back(background_triangle);
}

void pack_inward(const BoundaryMesh& boundary, const Fields& fields, const WallDistance& walls,
                 const PackingRule& rule, Packing& packing) {
  const TriMesh& mesh = fields.background;
  const Index nodes = static_cast<Index>(boundary.points.size());
  const Csr<Index> at_node = half_edges_at_nodes(mesh, nodes);
  for (Index i = 0; i < static_cast<Index>(packing.points.size()); ++i) {
    const Vec2 x = packing.points[i];
    const bool node = i < nodes;
    if (node && at_node.row(i).empty()) continue;
    Index at = node ? triangle_of(at_node.row(i)[0]) : packing.triangle[i];
    const FieldSample fx = fields.sample(x, at);
    const std::array<Vec2, 4> arms{fx.axis, perpendicular(fx.axis), -fx.axis,
                                   -perpendicular(fx.axis)};
    for (const Vec2 arm : arms) {
      const Vec2 way = fields.unstretched_at(x, arm, at);
      const Vec2 middle = x + 0.5 * fx.h * way;
      const Index start = node ? triangle_towards(mesh, at_node.row(i), way) : at;
      if (start == none) continue;
      Index t = fields.walk(middle, start);
      if (t == none) continue;
      const FieldSample fm = fields.sample(middle, t);
      const Vec2 y = x + fm.h * fields.unstretched_at(middle, nearest_arm(fm.axis, arm), t);
      t = fields.walk(y, t);
      if (t == none) continue;
      const FieldSample fy = fields.sample(y, t);
      if (!is_free(packing, y, fields, fy, t, rule.separation)) continue;
      if (walls.nearer_than(y, fy.h, rule.clearance * fy.h)) continue;
      if (packing.interior_count() >= rule.max_points) return;
      packing.add(y, fy.h, t);
    }
  }
}

}  // namespace lpq
