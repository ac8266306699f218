// Incremental Delaunay triangulation: each point is found by a visibility walk from the last
// insertion, splits its triangle, and Lawson flips restore empty circles around it. Cocircular ties
// are not flipped, so the result depends on the input alone. All signs are exact, hence the walk
// ends (in a Delaunay triangulation it cannot cycle) and so do the flips.
#include "delaunay/whole_plane.h"

#include <array>
#include <string>

#include "geometry/predicates_inline.h"

namespace lpq {
namespace {

class Inserter {
 public:
  explicit Inserter(WholePlane& plane) : plane_(plane) {
    const std::size_t half_edges = 6 * plane.points.size();  // 3 (2 n - 2) with ghosts
    plane.triangles.reserve(half_edges / 3);
    plane.twins.reserve(half_edges);
    pending_.reserve(64);
  }

  // A counter-clockwise triangle and the three ghosts around it.
  void start(Index a, Index b, Index c) {
    plane_.triangles = {{a, b, c}, {b, a, none}, {c, b, none}, {a, c, none}};
    plane_.twins = {3, 6, 9, 0, 11, 7, 1, 5, 10, 2, 8, 4};
    last_ = 0;
  }

  // The vertex that coincides with v, or none after v has been inserted.
  Index insert(Index v) {
    const Place place = find(plane_.points[v]);
    if (place.vertex != none) return place.vertex;
    const Index t = triangle_of(place.half_edge);
    split_triangle(t, v);
    if (place.on_edge) {
      // The split left a triangle of zero area on the edge: the flip removes it.
      const Index e = edge_opposite(place, t, v);
      flip(e);
    }
    restore_empty_circles(v);
    last_ = pending_base_;
    return none;
  }

 private:
  struct Place {
    Index half_edge = none;  // of the triangle (or ghost) to split; on it if on_edge
    bool on_edge = false;
    Index vertex = none;  // coincides with this one
  };

  Place find(Vec2 p) const {
    const std::vector<Index>& twins = plane_.twins;
    const auto side = [&](Index e) {
      return orient2d_inline(plane_.points[plane_.origin(e)], plane_.points[plane_.target(e)], p);
    };
    Index e = real_half_edge(last_);
    int at_e = side(e);
    if (at_e < 0) {
      e = twins[e];
      at_e = 1;
    }
    while (true) {
      if (plane_.apex(e) == none) return {e, false, none};
      const Index n = next_in_triangle(e), q = prev_in_triangle(e);
      const int at_n = side(n);
      if (at_n < 0) {
        e = twins[n];
        at_e = 1;
        continue;
      }
      const int at_q = side(q);
      if (at_q < 0) {
        e = twins[q];
        at_e = 1;
        continue;
      }
      return classify({e, n, q}, {at_e, at_n, at_q});
    }
  }

  // p lies in the closed triangle: inside, on the one edge of sign zero, or on the corner of two.
  Place classify(const std::array<Index, 3>& e, const std::array<int, 3>& side) const {
    Place place{e[0], false, none};
    for (int k = 0; k < 3; ++k) {
      if (side[k] != 0) continue;
      if (side[(k + 1) % 3] == 0) place.vertex = plane_.target(e[k]);
      place.half_edge = e[k];
      place.on_edge = true;
    }
    return place;
  }

  Index real_half_edge(Index t) const {
    for (Index e = 3 * t; e < 3 * t + 3; ++e) {
      if (plane_.origin(e) != none && plane_.target(e) != none) {
        return plane_.apex(e) == none ? plane_.twins[e] : e;
      }
    }
    return none;
  }

  // Triangle (a, b, c) becomes (a, b, v), (b, c, v), (c, a, v); the outer edges become suspects.
  void split_triangle(Index t, Index v) {
    const auto [a, b, c] = plane_.triangles[t];
    const Index outer_bc = plane_.twins[3 * t + 1], outer_ca = plane_.twins[3 * t + 2];
    const Index t1 = plane_.triangle_count(), t2 = t1 + 1;
    plane_.triangles[t][2] = v;
    plane_.triangles.push_back({b, c, v});
    plane_.triangles.push_back({c, a, v});
    plane_.twins.resize(plane_.twins.size() + 6);
    plane_.link(3 * t1, outer_bc);
    plane_.link(3 * t2, outer_ca);
    plane_.link(3 * t + 1, 3 * t1 + 2);
    plane_.link(3 * t1 + 1, 3 * t2 + 2);
    plane_.link(3 * t2 + 1, 3 * t + 2);
    pending_base_ = t;
    pending_.assign({3 * t, 3 * t1, 3 * t2});
  }

  // After the split the edge v lies on is the first half-edge of one of the three triangles.
  Index edge_opposite(const Place& place, Index t, Index v) const {
    const Index k = place.half_edge % 3;
    const Index e = k == 0 ? 3 * t : 3 * (plane_.triangle_count() - 3 + k);
    LPQ_ASSERT(plane_.apex(e) == v);
    (void)v;
    return e;
  }

  // Gives v, the apex of e, two new outer edges.
  void flip(Index e) {
    pending_.push_back(e);
    pending_.push_back(plane_.twins[e]);
    flip_edge(corners_of(plane_.triangles), plane_.twins.data(), e);
  }

  void restore_empty_circles(Index v) {
    while (!pending_.empty()) {
      const Index e = pending_.back();
      pending_.pop_back();
      if (must_flip(e, v)) flip(e);
    }
  }

  // Is v strictly inside the circle of the triangle beyond e? A ghost's circle is the open half
  // plane beyond its hull edge.
  bool must_flip(Index e, Index v) const {
    const Index f = plane_.twins[e];
    const Index b = plane_.origin(f), a = plane_.target(f), d = plane_.apex(f);
    const auto& p = plane_.points;
    if (d == none) return false;
    if (a == none) return orient2d_inline(p[d], p[b], p[v]) > 0;
    if (b == none) return orient2d_inline(p[a], p[d], p[v]) > 0;
    return in_circle_inline(p[b], p[a], p[d], p[v]) > 0;
  }

  WholePlane& plane_;
  std::vector<Index> pending_;
  Index pending_base_ = 0;
  Index last_ = 0;
};

Error duplicate(const WholePlane& plane, Index v, Index w) {
  Error error;
  error.code = ErrorCode::duplicate_point;
  const Index first = plane.given[v] < plane.given[w] ? plane.given[v] : plane.given[w];
  const Index second = plane.given[v] < plane.given[w] ? plane.given[w] : plane.given[v];
  error.message = "Points " + std::to_string(first) + " and " + std::to_string(second) +
                  " are equal: remove one of them.";
  error.where.set_point(plane.points[v].x, plane.points[v].y);
  return error;
}

Error all_collinear() {
  Error error;
  error.code = ErrorCode::zero_area;
  error.message = "All points lie on one line: there is nothing to triangulate.";
  return error;
}

}  // namespace

Problem insert_all(WholePlane& plane, std::span<const Index> insertion) {
  LPQ_ASSERT(insertion.size() >= 3);
  const auto& p = plane.points;
  const Index a = insertion[0], b = insertion[1];
  if (p[a] == p[b]) return duplicate(plane, a, b);
  std::size_t third = 2;
  int turn = 0;
  while (third < insertion.size() &&
         (turn = orient2d_inline(p[a], p[b], p[insertion[third]])) == 0) {
    ++third;
  }
  if (turn == 0) return all_collinear();
  const Index c = insertion[third];
  Inserter inserter(plane);
  turn > 0 ? inserter.start(a, b, c) : inserter.start(b, a, c);
  for (std::size_t i = 2; i < insertion.size(); ++i) {
    if (i == third) continue;
    if (const Index other = inserter.insert(insertion[i]); other != none) {
      return duplicate(plane, insertion[i], other);
    }
  }
  return std::nullopt;
}

std::vector<Index> leaving_half_edges(const WholePlane& plane) {
  std::vector<Index> leaving(plane.points.size(), none);
  for (Index e = 0; e < 3 * plane.triangle_count(); ++e) {
    if (plane.origin(e) != none) leaving[plane.origin(e)] = e;
  }
  return leaving;
}

std::vector<Index> vertex_numbers(const WholePlane& plane) {
  std::vector<Index> vertex(plane.given.size());
  for (std::size_t v = 0; v < vertex.size(); ++v) vertex[plane.given[v]] = static_cast<Index>(v);
  return vertex;
}

}  // namespace lpq
