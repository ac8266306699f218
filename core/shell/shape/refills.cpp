// See refills.h.
#include "shell/shape/refills.h"

#include <algorithm>

#include "cleanup/quad_topology.h"
#include "shell/place.h"
#include "shell/topology.h"

namespace lpq {
namespace {

class PatchEdit {
 public:
  PatchEdit(const ShapeGround& ground, const ShapePatch& patch)
      : ground_(ground), patch_(patch), before_(patch.mesh.faces) {
    patch_.changed = true;
  }

  const Face& face(Index f) const { return patch_.mesh.faces[f]; }
  bool may_go(Index v) const { return !patch_.rim[v] && patch_.mesh.is_free(v); }

  bool is_wall(Index a, Index b) const {
    return std::binary_search(patch_.mesh.edges.begin(), patch_.mesh.edges.end(),
                              std::array<Index, 2>{std::min(a, b), std::max(a, b)});
  }

  /// The face of the patch that has the edge in this direction.
  Index face_with(Index a, Index b) const {
    for (std::size_t f = 0; f < patch_.mesh.faces.size(); ++f) {
      const Index k = corner_of(face(static_cast<Index>(f)), a);
      if (k != none && face(static_cast<Index>(f))[(k + 1) & 3] == b) return static_cast<Index>(f);
    }
    return none;
  }

  /// Face f goes, and its corners k and k + 2 become one.
  bool collapse(Index f, Index k) {
    Index stays = face(f)[k], goes = face(f)[(k + 2) & 3];
    if (!may_go(goes)) std::swap(stays, goes);
    if (!may_go(goes)) return false;
    patch_.mesh.faces[f] = dead;
    for (Face& other : patch_.mesh.faces)
      for (Index& v : other)
        if (v == goes) v = stays;
    return true;
  }

  /// The edge from corner k of f turns by one or two places in the hexagon of its two quads.
  bool turn(Index f, Index k, int places) {
    const Index a = face(f)[k], b = face(f)[(k + 1) & 3];
    const Index g = is_wall(a, b) ? none : face_with(b, a);
    if (g == none || g == f || face(g)[3] == none) return false;
    const Index j = corner_of(face(g), b);
    // Counter-clockwise from a: first round g, then round f.
    const std::array<Index, 6> ring{a, face(g)[(j + 2) & 3], face(g)[(j + 3) & 3],
                                    b, face(f)[(k + 2) & 3], face(f)[(k + 3) & 3]};
    const auto at = [&](int i) { return ring[(i + places) % 6]; };
    patch_.mesh.faces[f] = {at(3), at(4), at(5), at(0)};
    patch_.mesh.faces[g] = {at(0), at(1), at(2), at(3)};
    return true;
  }

  /// Faces round v from the one right after a wall, or from any if there is none; counter-clockwise
  /// while there is a next one in the patch and no wall between.
  std::vector<Index> fan(Index v, Index f) const {
    for (std::size_t i = 0; i < patch_.mesh.faces.size(); ++i) {
      const Index k = corner_of(face(f), v), before = face(f)[(k + 1) & 3];
      const Index next = is_wall(v, before) ? none : face_with(before, v);
      if (next == none) break;
      f = next;
    }
    std::vector<Index> result{f};
    for (;;) {
      const Index k = corner_of(face(result.back()), v), after = face(result.back())[(k + 3) & 3];
      const Index next = is_wall(v, after) ? none : face_with(v, after);
      if (next == none || next == f) return result;
      result.push_back(next);
    }
  }

  /// A new vertex takes these faces of v, a fan of at least two; a quad opens between the two.
  bool open(Index v, std::span<const Index> taken) {
    const auto corner = [&](Index f) { return corner_of(face(f), v); };
    const Index a = face(taken.front())[(corner(taken.front()) + 1) & 3];
    const Index b = face(taken.back())[(corner(taken.back()) + 3) & 3];
    const Index towards = face(taken.front())[(corner(taken.front()) + 3) & 3];
    if (a == b) return false;
    const Vec3 middle = midpoint(patch_.mesh.points[v], patch_.mesh.points[towards]);
    const Index opened = add_vertex(towards, middle, patch_.mesh.face[taken.front()]);
    for (const Index f : taken) patch_.mesh.faces[f][corner(f)] = opened;
    patch_.mesh.faces.push_back({v, a, opened, b});
    patch_.mesh.face.push_back(patch_.mesh.face[taken.front()]);
    return true;
  }

  /// A smaller quad inside f, joined to it by four more: halves every angle at its corners, which
  /// mends a straight one even where all sides are on features.
  bool put_ring(Index f) {
    const Face outer = face(f);
    Vec3 centre{};
    for (const Index v : outer) centre += 0.25 * patch_.mesh.points[v];
    Face inner;
    for (int k = 0; k < 4; ++k)
      inner[k] =
          add_vertex(outer[k], midpoint(patch_.mesh.points[outer[k]], centre), patch_.mesh.face[f]);
    patch_.mesh.faces[f] = inner;
    for (int k = 0; k < 4; ++k) {
      const int next = (k + 1) & 3;
      patch_.mesh.faces.push_back({outer[k], outer[next], inner[next], inner[k]});
      patch_.mesh.face.push_back(patch_.mesh.face[f]);
    }
    return true;
  }

  /// Corner k of f, straight between two sides on features, gets a second quad: f and the quad
  /// beyond one of its other sides (b c, after the corner or before it) are divided in four, and
  /// what was irregular at the corner is so inside:
  ///
  ///   b---v---a      b---v---a
  ///   | \     |      |\  |   |
  ///   |   \   |  >   | s-r   |      b v and v a lie on features
  ///   |     \ |      | |  \  |
  ///   d-e-----c      d-e-----c
  bool share_corner(Index f, Index k, bool before) {
    const auto corner = [&](int i) { return face(f)[(k + i) & 3]; };
    const Index v = corner(0), c = corner(2), b = corner(before ? 3 : 1);
    if (!is_wall(corner(3), v) || !is_wall(v, corner(1)) || is_wall(b, c)) return false;
    const Index g = before ? face_with(b, c) : face_with(c, b);
    if (g == none || g == f || face(g)[3] == none) return false;
    const Index at_b = corner_of(face(g), b), e = face(g)[(at_b + 2) & 3];
    const Index d = face(g)[(at_b + (before ? 3 : 1)) & 3], a = corner(before ? 1 : 3);
    const Index side = patch_.mesh.face[f], r = add_between(v, c, e, side);
    const Index s = add_between(b, e, c, patch_.mesh.face[g]);
    std::array<Face, 4> parts{Face{a, v, r, c}, {v, b, s, r}, {b, d, e, s}, {r, s, e, c}};
    if (before)
      for (Face& part : parts) std::reverse(part.begin(), part.end());
    patch_.mesh.faces[f] = parts[0];
    patch_.mesh.faces[g] = parts[2];
    for (const Face& part : {parts[1], parts[3]}) {
      patch_.mesh.faces.push_back(part);
      patch_.mesh.face.push_back(side);
    }
    return true;
  }

  /// Removes doublets and dead faces; false if the patch is no mesh any more.
  bool tidy() {
    while (remove_doublet()) {
    }
    std::size_t kept = 0;
    for (std::size_t f = 0; f < patch_.mesh.faces.size(); ++f) {
      if (patch_.mesh.faces[f] == dead) continue;
      patch_.mesh.faces[kept] = patch_.mesh.faces[f];
      patch_.mesh.face[kept++] = patch_.mesh.face[f];
    }
    patch_.mesh.faces.resize(kept);
    patch_.mesh.face.resize(kept);
    return is_mesh() && hangs_together_as_before();
  }

  ShapePatch take() { return std::move(patch_); }

 private:
  static constexpr Face dead{none, none, none, none};

  /// Half-way from a vertex to the side opposite, nearer to its end a.
  Index add_between(Index from, Index a, Index b, Index face) {
    const std::vector<Vec3>& points = patch_.mesh.points;
    const Vec3 opposite = (2.0 / 3) * points[a] + (1.0 / 3) * points[b];
    return add_vertex(from, midpoint(points[from], opposite), face);
  }

  /// On a straight way from a vertex towards a point near it.
  Index add_vertex(Index from, Vec3 to, Index face) {
    const Vec3 way = to - patch_.mesh.points[from];
    const SurfacePlace start = ground_.outside.on_side(patch_.mesh.places[from], face, way);
    const TriangleAxes axes = axes_of(ground_.surface, start.triangle);
    const SurfacePlace place =
        ground_.walker.walk(start, {dot(way, axes.x), dot(way, axes.y)}).place;
    patch_.mesh.places.push_back(place);
    patch_.mesh.points.push_back(point_at(ground_.surface, place));
    patch_.mesh.pins.push_back(Pin::free);
    patch_.roles.push_back({});
    patch_.rim.push_back(0);
    patch_.vertex.push_back(none);
    return static_cast<Index>(patch_.vertex.size()) - 1;
  }

  /// A free vertex of two quads goes, and the quads become one.
  bool remove_doublet() {
    std::vector<std::array<Index, 2>> of(patch_.vertex.size(), {none, none});
    std::vector<Index> count(patch_.vertex.size(), 0);
    for (std::size_t f = 0; f < patch_.mesh.faces.size(); ++f)
      for (const Index v : patch_.mesh.faces[f])
        if (v != none && count[v]++ < 2) of[v][count[v] - 1] = static_cast<Index>(f);
    for (std::size_t v = 0; v < count.size(); ++v) {
      const Index id = static_cast<Index>(v);
      if (count[v] != 2 || !may_go(id)) continue;
      const auto [f, g] = of[v];
      if (face(f)[3] == none || face(g)[3] == none) continue;
      patch_.mesh.faces[f][corner_of(face(f), id)] = face(g)[(corner_of(face(g), id) + 2) & 3];
      patch_.mesh.faces[g] = dead;
      return true;
    }
    return false;
  }

  bool is_mesh() const {
    std::vector<std::array<Index, 2>> edges;
    std::vector<Index> count(patch_.vertex.size(), 0);
    for (const Face& face : patch_.mesh.faces) {
      const int n = corner_count(face);
      for (int k = 0; k < n; ++k) {
        for (int j = 0; j < k; ++j)
          if (face[j] == face[k]) return false;
        edges.push_back({face[k], face[(k + 1) % n]});
        ++count[face[k]];
      }
    }
    std::sort(edges.begin(), edges.end());
    if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
    for (std::size_t v = 0; v < count.size(); ++v)
      if (count[v] == 0 ? !may_go(static_cast<Index>(v))
                        : count[v] < 3 && may_go(static_cast<Index>(v)))
        return false;
    return true;
  }

  /// A closed mesh of few quads could be collapsed to nothing.
  bool hangs_together_as_before() const {
    if (std::find(patch_.rim.begin(), patch_.rim.end(), 1) != patch_.rim.end()) return true;
    const ShellTopology old = shell_topology(before_), now = shell_topology(patch_.mesh.faces);
    return now.components == old.components && now.euler == old.euler;
  }

  const ShapeGround& ground_;
  ShapePatch patch_;
  std::span<const Face> before_;
};

class RefillList {
 public:
  RefillList(const ShapeGround& ground, const ShapePatch& patch, Index f)
      : ground_(ground), patch_(patch), f_(f) {}

  std::vector<ShapePatch> run() {
    for (Index k = 0; k < 2; ++k) try_edit([&](PatchEdit& edit) { return edit.collapse(f_, k); });
    for (Index k = 0; k < 4; ++k) {
      for (int places = 1; places <= 2; ++places)
        try_edit([&](PatchEdit& edit) { return edit.turn(f_, k, places); });
      open_at(patch_.mesh.faces[f_][k]);
    }
    for (Index k = 0; k < 4; ++k)
      for (const bool before : {false, true})
        try_edit([&](PatchEdit& edit) { return edit.share_corner(f_, k, before); });
    try_edit([&](PatchEdit& edit) { return edit.put_ring(f_); });
    return std::move(result_);
  }

 private:
  template <class Change>
  void try_edit(Change&& change) {
    PatchEdit edit(ground_, patch_);
    if (change(edit) && edit.tidy()) result_.push_back(edit.take());
  }

  /// Two or three faces in a row, of a vertex that keeps one at least.
  void open_at(Index v) {
    if (patch_.rim[v]) return;
    const std::vector<Index> fan = PatchEdit(ground_, patch_).fan(v, f_);
    for (std::size_t size = 2; size <= 3; ++size)
      for (std::size_t i = 0; i + size <= fan.size(); ++i) {
        const std::span<const Index> taken(fan.data() + i, size);
        if (size == fan.size() || std::find(taken.begin(), taken.end(), f_) == taken.end())
          continue;
        try_edit([&](PatchEdit& edit) { return edit.open(v, taken); });
      }
  }

  const ShapeGround& ground_;
  const ShapePatch& patch_;
  Index f_;
  std::vector<ShapePatch> result_;
};

}  // namespace

std::vector<ShapePatch> refills(const ShapeGround& ground, const ShapePatch& patch, Index f) {
  return RefillList(ground, patch, f).run();
}

}  // namespace lpq
