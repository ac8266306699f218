#include "surface/charts/intrinsic.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "numerics/elementary.h"

namespace lpq {
namespace {

// The triangle inequality holds with at least this share of the mean length to spare.
constexpr double least_slack = 1e-7;
// Angles across an edge must exceed half a turn by more than rounding to be worth a flip.
constexpr double least_gain = 1e-9;
// A bound on flips per triangle; convergence is proven for exact lengths only.
constexpr std::int64_t most_flips = 40;

void add_triangle(Intrinsic& surface, Tri tri, const double (&length)[3]) {
  surface.corners.push_back(tri);
  for (const double l : length) surface.length.push_back(l);
  for (int k = 0; k < 3; ++k) surface.twins.push_back(none);
}

void join(Intrinsic& surface, Index e, Index f) {
  surface.twins[e] = f;
  surface.twins[f] = e;
}

void fill_hole(const SurfaceMesh& mesh, const Part& part, Index loop, Intrinsic& surface) {
  const auto border = part.loops.row(loop);
  const auto at = [&](Index e) { return mesh.points[part.vertex[part.origin(e)]]; };
  Vec3 centre;
  for (const Index e : border) centre += (1.0 / static_cast<double>(border.size())) * at(e);
  const Index first = static_cast<Index>(surface.twins.size());
  const Index middle = surface.vertices++;
  const Index count = static_cast<Index>(border.size());
  for (Index i = 0; i < count; ++i) {
    const Index e = border[i], next = border[(i + 1) % count];
    const double from = distance(centre, at(e)), to = distance(centre, at(next));
    add_triangle(surface, {part.target(e), part.origin(e), middle}, {part.length[e], from, to});
    join(surface, e, first + 3 * i);
  }
  // Half-edge 1 runs inwards from the origin of the border edge, which the triangle before reaches.
  for (Index i = 0; i < count; ++i)
    join(surface, first + 3 * i + 1, first + 3 * ((i + count - 1) % count) + 2);
}

void keep_inequality(Intrinsic& surface) {
  double sum = 0, missing = 0;
  for (const double l : surface.length) sum += l;
  const double slack = least_slack * sum / static_cast<double>(surface.length.size());
  for (std::size_t e = 0; e < surface.length.size(); e += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const double* l = &surface.length[e];
      missing = std::max(missing, slack - (l[(k + 1) % 3] + l[(k + 2) % 3] - l[k]));
    }
  if (missing > 0)
    for (double& l : surface.length) l += missing;
}

struct Flipper {
  Intrinsic& s;
  std::vector<Index> stack;
  std::vector<char> waiting;  // #half-edges, set for the smaller of a pair

  void push(Index e) {
    const Index twin = s.twins[e];
    if (twin == none) return;
    const Index edge = std::min(e, twin);
    if (waiting[edge]) return;
    waiting[edge] = 1;
    stack.push_back(edge);
  }
  double cotangent(Index e) const {
    const double l = s.length[e], m = s.length[next_in_triangle(e)];
    const double n = s.length[prev_in_triangle(e)];
    return (m * m + n * n - l * l) / four_areas({l, m, n});
  }
  // Length of the other diagonal of the two triangles laid flat; 0 if they make no convex quad.
  double other_diagonal(Index e, Index f) const {
    const double ab = s.length[e];
    const double bc = s.length[next_in_triangle(e)], ca = s.length[prev_in_triangle(e)];
    const double ad = s.length[next_in_triangle(f)], db = s.length[prev_in_triangle(f)];
    const double xc = (ab * ab + ca * ca - bc * bc) / (2 * ab);
    const double xd = (ab * ab + ad * ad - db * db) / (2 * ab);
    const double height = (four_areas({ab, bc, ca}) + four_areas({ab, ad, db})) / (2 * ab);
    const double cd = std::sqrt((xc - xd) * (xc - xd) + height * height);
    const bool convex = cd < ca + ad && cd < bc + db && cd + ca > ad && cd + ad > ca &&
                        cd + bc > db && cd + db > bc;
    return convex ? cd : 0;
  }
  // As flip_edge in mesh/tri_mesh.h, for triangles that may also meet each other, or themselves,
  // at their other sides.
  void turn(Index e, Index f, double diagonal) {
    const Index en = next_in_triangle(e), ep = prev_in_triangle(e);
    const Index fn = next_in_triangle(f), fp = prev_in_triangle(f);
    Index* corner = corners_of(s.corners);
    const Index b = corner[f], c = corner[ep], d = corner[fp];
    const auto moved = [=](Index h) { return h == en ? fn : h == fn ? e : h == fp ? f : h; };
    const Index before[4] = {en, ep, fn, fp};
    Index beyond[4];
    for (int i = 0; i < 4; ++i) beyond[i] = s.twins[before[i]];
    const double bc = s.length[en], ad = s.length[fn], db = s.length[fp];
    for (int i = 0; i < 4; ++i) {
      const Index here = moved(before[i]);
      const Index there = beyond[i] == none ? none : moved(beyond[i]);
      s.twins[here] = there;
      if (there != none) s.twins[there] = here;
    }
    s.twins[en] = fp;
    s.twins[fp] = en;
    corner[en] = corner[f] = d;
    corner[fn] = b;
    corner[fp] = c;
    s.length[e] = ad;
    s.length[f] = db;
    s.length[fn] = bc;
    s.length[en] = s.length[fp] = diagonal;
  }
  bool flip(Index e) {
    const Index f = s.twins[e];
    if (triangle_of(e) == triangle_of(f)) return false;
    if (!(cotangent(e) + cotangent(f) < -least_gain)) return false;
    const double diagonal = other_diagonal(e, f);
    if (!(diagonal > 0)) return false;
    turn(e, f, diagonal);
    for (const Index side : {e, prev_in_triangle(e), f, next_in_triangle(f)}) push(side);
    return true;
  }
};

}  // namespace

// 4 A = sqrt((a+b+c)(-a+b+c)(a-b+c)(a+b-c)) in the order that loses least [Kahan 2014].
double four_areas(const double (&length)[3]) {
  double a = length[0], b = length[1], c = length[2];
  if (a < b) std::swap(a, b);
  if (b < c) std::swap(b, c);
  if (a < b) std::swap(a, b);
  const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  constexpr double least = 1e-15;  // of the squared longest side: keeps cotangents finite
  return std::sqrt(std::max(product, least * least * a * a * a * a));
}

Intrinsic intrinsic_of(const SurfaceMesh& mesh, const Part& part) {
  Intrinsic surface{part.vertex_count(), part.corners, part.twins, part.length};
  for (Index loop = 1; loop < part.loops.rows(); ++loop) fill_hole(mesh, part, loop, surface);
  keep_inequality(surface);
  return surface;
}

void flip_to_delaunay(Intrinsic& surface) {
  Flipper flipper{surface, {}, std::vector<char>(surface.twins.size(), 0)};
  for (Index e = static_cast<Index>(surface.twins.size()); e-- > 0;) flipper.push(e);
  std::int64_t left = most_flips * static_cast<std::int64_t>(surface.corners.size());
  while (!flipper.stack.empty() && left > 0) {
    const Index e = flipper.stack.back();
    flipper.stack.pop_back();
    flipper.waiting[e] = 0;
    // Flips nearby may have moved the edge to other half-edges; those are waiting as well.
    if (surface.twins[e] != none && flipper.flip(e)) --left;
  }
}

std::vector<double> half_cotangents(const Intrinsic& surface) {
  std::vector<double> weights(surface.length.size());
  for (std::size_t e = 0; e < weights.size(); e += 3) {
    const double l[3] = {surface.length[e], surface.length[e + 1], surface.length[e + 2]};
    const double area4 = four_areas(l);
    for (int k = 0; k < 3; ++k) {
      const double m = l[(k + 1) % 3], n = l[(k + 2) % 3];
      weights[e + k] = 0.5 * (m * m + n * n - l[k] * l[k]) / area4;
    }
  }
  return weights;
}

std::vector<double> angle_sums(const Intrinsic& surface) {
  std::vector<double> sums(surface.vertices, 0.0);
  for (std::size_t t = 0; t < surface.corners.size(); ++t) {
    const double l[3] = {surface.length[3 * t], surface.length[3 * t + 1],
                         surface.length[3 * t + 2]};
    const double area4 = four_areas(l);
    for (int k = 0; k < 3; ++k) {
      const double opposite = l[(k + 1) % 3], m = l[k], n = l[(k + 2) % 3];
      sums[surface.corners[t][k]] += arc_tangent(area4, m * m + n * n - opposite * opposite);
    }
  }
  return sums;
}

}  // namespace lpq
