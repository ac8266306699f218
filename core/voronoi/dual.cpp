#include "voronoi/dual.h"

#include <algorithm>

#include "base/check.h"
#include "geometry/box.h"

namespace lpq {
namespace {

// Below this share of the squared edge length twice a triangle's area is rounding noise. Such a
// triangle lies flat on a wall and only the direction of its far circumcentre matters.
constexpr double least_area_share = 0x1p-60;
// A crossing further than this beyond its wall's ends is counted as clamped; less is rounding.
constexpr double crossing_slack = 1e-9;

// Triangles flatter than this take more care; any value far above rounding and below usual shapes.
constexpr double needle_share = 0x1p-8;

Vec2 circumcentre_from(Vec2 a, Vec2 u, Vec2 v, double uu, double vv, double area) {
  const double inverse = 1 / area;
  return {a.x + (v.y * uu - u.y * vv) * inverse, a.y + (u.x * vv - v.x * uu) * inverse};
}

// Seen from the corner between the two shorter edges nothing cancels in the numerators.
Vec2 needle_circumcentre(Vec2 a, Vec2 b, Vec2 c) {
  const double ab = squared_length(b - a), bc = squared_length(c - b), ca = squared_length(a - c);
  if (ab > bc && ab >= ca) return needle_circumcentre(c, a, b);
  if (ca > bc && ca > ab) return needle_circumcentre(b, c, a);
  const double area = std::max(2 * cross(b - a, c - a), least_area_share * (ab + ca));
  return circumcentre_from(a, b - a, c - a, ab, ca, area);
}

bool behind(Vec2 a, Vec2 b, Vec2 point) { return cross(b - a, point - a) < 0; }

// Squared diagonal of the domain's bounding box: no circumradius inside the domain is larger.
double squared_extent(const TriMesh& mesh) {
  const std::size_t count =
      mesh.fixed > 0 ? static_cast<std::size_t>(mesh.fixed) : mesh.points.size();
  if (count == 0) return 0;
  const Box box = box_of(std::span(mesh.points).first(count));
  return squared_length(box.hi - box.lo);
}

class Clipper {
 public:
  Clipper(const TriMesh& mesh, ClippedDual& dual) : mesh_(mesh), dual_(dual) {}

  void run() {
    find_circumcentres();
    find_walls();
    for (const Index w : dual_.walls) claim_root(w);
    for (const Index w : dual_.walls) clip_by_wall(w);
    replace_runaways();
    for (const Index f : dual_.chain) add_rim_edge(f);
  }

 private:
  void find_circumcentres();
  void find_walls();
  void claim_root(Index w);
  void clip_by_wall(Index w);
  bool extends(Index f, Index w);
  Index add_crossing(Index w, Index s, Index t);
  Index add_midpoint(Index w);
  Index add_vertex(Vec2 point, RimVertex vertex);
  void replace_runaways();
  void add_rim_edge(Index f);
  Index left_end(Index e) const { return dual_.end[e] == none ? triangle_of(e) : dual_.end[e]; }
  void add_fan(Index site, Index c1, Index c2) { dual_.fans.push_back({site, c1, c2}); }

  const TriMesh& mesh_;
  ClippedDual& dual_;
};

void Clipper::find_circumcentres() {
  const std::size_t count = mesh_.triangles.size();
  dual_.vertices.resize(count);
  dual_.sheet.assign(count, none);
  dual_.end.assign(3 * count, none);
  for (std::size_t t = 0; t < count; ++t) {
    const Tri& tri = mesh_.triangles[t];
    dual_.vertices[t] =
        circumcentre(mesh_.points[tri[0]], mesh_.points[tri[1]], mesh_.points[tri[2]]);
  }
}

void Clipper::find_walls() {
  dual_.rim.clear();
  dual_.fans.clear();
  dual_.walls.clear();
  dual_.chain.clear();
  dual_.clamped_crossings = dual_.replaced_centres = 0;
  const Index count = 3 * mesh_.triangle_count();
  for (Index e = 0; e < count; ++e)
    if (mesh_.twins[e] == none) dual_.walls.push_back(e);
}

// The circumcentre lies behind the wall of its own triangle when the angle opposite is obtuse. A
// triangle has one obtuse angle, so no two walls claim it. All roots go before any propagation.
void Clipper::claim_root(Index w) {
  const Vec2 a = mesh_.points[mesh_.origin(w)], b = mesh_.points[mesh_.target(w)];
  const Vec2 c = mesh_.points[mesh_.apex(w)];
  if (dot(a - c, b - c) < 0) dual_.sheet[triangle_of(w)] = w;
}

// Half-edge f bounds the tree of wall w from inside: does the tree grow through it?
bool Clipper::extends(Index f, Index w) {
  const Index g = mesh_.twins[f];
  if (g == none) return false;
  const Index t = triangle_of(g);
  if (dual_.sheet[t] != none) return false;  // taken: its circumcentre lies behind another wall
  if (!behind(mesh_.points[mesh_.origin(w)], mesh_.points[mesh_.target(w)], dual_.vertices[t]))
    return false;
  dual_.sheet[t] = w;
  return true;
}

// The cells that meet wall w, from its origin to its target: the origin's, those of the outline
// of the tree of triangles whose circumcentres lie behind w, the target's.
void Clipper::clip_by_wall(Index w) {
  if (dual_.sheet[triangle_of(w)] != w) {
    dual_.chain.push_back(w);
    return;
  }
  dual_.end[w] = ClippedDual::beyond;
  dual_.stack.assign({next_in_triangle(w), prev_in_triangle(w)});
  Index last_crossing = none;
  while (!dual_.stack.empty()) {
    const Index f = dual_.stack.back();
    dual_.stack.pop_back();
    if (extends(f, w)) {
      const Index g = mesh_.twins[f];
      dual_.end[f] = dual_.end[g] = ClippedDual::beyond;
      dual_.stack.push_back(next_in_triangle(g));
      dual_.stack.push_back(prev_in_triangle(g));
      continue;
    }
    const Index crossing = add_crossing(w, mesh_.target(f), mesh_.origin(f));
    dual_.end[f] = crossing;
    if (mesh_.twins[f] != none) dual_.chain.push_back(f);  // a wall is listed on its own account
    if (last_crossing != none) add_fan(mesh_.target(f), last_crossing, crossing);
    last_crossing = crossing;
  }
}

// Where the bisector of sites s, t (in the order of their cells along the wall) crosses wall w.
// Along a wall cells follow each other in the order of their sites' projections, so the bisector is
// never parallel to the wall but for rounding.
Index Clipper::add_crossing(Index w, Index s, Index t) {
  const Vec2 a = mesh_.points[mesh_.origin(w)], d = mesh_.points[mesh_.target(w)] - a;
  const Vec2 from = mesh_.points[s], across = mesh_.points[t] - from;
  const double along = dot(across, d);
  const double share = (dot(across, from - a) + 0.5 * squared_length(across)) / along;
  if (along > 0 && share >= 0 && share <= 1)
    return add_vertex(a + share * d, {VertexKind::bisector_and_wall, s, t, w});
  // Deviation: a point that stands still at the wall's end.
  const double clamped = share < 0 ? 0.0 : (share > 1 ? 1.0 : 0.5);
  if (!(along > 0 && share > -crossing_slack && share < 1 + crossing_slack))
    ++dual_.clamped_crossings;
  return add_vertex(a + clamped * d, {VertexKind::corner, s, t, w});
}

// Fig. 17: the bisector of a wall's two ends meets the wall at its midpoint, which never moves.
Index Clipper::add_midpoint(Index w) {
  const Index a = mesh_.origin(w), b = mesh_.target(w);
  return add_vertex(midpoint(mesh_.points[a], mesh_.points[b]), {VertexKind::corner, a, b, w});
}

Index Clipper::add_vertex(Vec2 point, RimVertex vertex) {
  dual_.vertices.push_back(point);
  dual_.rim.push_back(vertex);
  return static_cast<Index>(dual_.vertices.size()) - 1;
}

// By Seidel's theorem a circumcentre behind no wall lies in the domain. Should rounding say
// otherwise (a needle flatter than double precision), its share of the area is divided at the
// midpoint of its longest edge. Deviation: that point stands still in the gradient.
void Clipper::replace_runaways() {
  const double limit = squared_extent(mesh_);
  for (Index t = 0; t < mesh_.triangle_count(); ++t) {
    const Tri& tri = mesh_.triangles[t];
    const Vec2 to_centre = dual_.vertices[t] - mesh_.points[tri[0]];
    if (squared_length(to_centre) <= limit || dual_.sheet[t] != none) continue;
    double longest = -1;
    for (int k = 0; k < 3; ++k) {
      const Vec2 p = mesh_.points[tri[k]], q = mesh_.points[tri[(k + 1) % 3]];
      if (squared_length(q - p) <= longest) continue;
      longest = squared_length(q - p);
      dual_.vertices[t] = midpoint(p, q);
    }
    dual_.sheet[t] = ClippedDual::replaced;
    ++dual_.replaced_centres;
  }
}

// The dual edge of half-edge f, which ends on the rim on one side or both.
void Clipper::add_rim_edge(Index f) {
  const Index g = mesh_.twins[f];
  if (g != none && dual_.end[g] >= 0 && g < f) return;  // both sides listed f: once is enough
  const Index left = left_end(f), right = g == none ? add_midpoint(f) : left_end(g);
  LPQ_ASSERT(left >= 0 && right >= 0);
  add_fan(mesh_.origin(f), right, left);
  add_fan(mesh_.target(f), left, right);
}

}  // namespace

Vec2 circumcentre(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 u = b - a, v = c - a;
  const double uu = squared_length(u), vv = squared_length(v), area = 2 * cross(u, v);
  if (area < needle_share * (uu + vv)) return needle_circumcentre(a, b, c);
  return circumcentre_from(a, u, v, uu, vv, area);
}

void clip_dual(const TriMesh& mesh, ClippedDual& dual) { Clipper(mesh, dual).run(); }

}  // namespace lpq
