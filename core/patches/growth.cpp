#include "patches/growth.h"

#include <algorithm>

namespace lpq {

PatchGrowth::PatchGrowth(const QuadTopology& mesh, const IdealValence& ideal, bool takes_triangles)
    : mesh_(mesh), ideal_(ideal), takes_triangles_(takes_triangles) {}

void PatchGrowth::clear() {
  for (const Index f : faces_) inside_[f] = 0;
  for (const Index v : vertices_) count_[v] = 0;
  faces_.clear();
  vertices_.clear();
  unchecked_.clear();
  triangles_ = 0;
  broken_ = false;
  inside_.resize(mesh_.face_slots(), 0);
  count_.resize(mesh_.vertex_count(), 0);
  on_loop_.resize(mesh_.vertex_count(), 0);
}

void PatchGrowth::add_face(Index f) {
  if (inside_[f]) return;
  const Face& face = mesh_.face(f);
  const int n = corner_count(face);
  if (n == 3 && !takes_triangles_) {
    broken_ = true;
    return;
  }
  triangles_ += n == 3;
  inside_[f] = 1;
  faces_.push_back(f);
  for (int k = 0; k < n; ++k) {
    const Index v = face[k], w = face[(k + 1) % n];
    if (count_[v]++ == 0) vertices_.push_back(v);
    unchecked_.push_back(v);
    if (!mesh_.is_wall(v, w)) continue;
    const Index beyond = mesh_.face_with_edge(w, v);
    if (beyond != none && inside_[beyond]) broken_ = true;
  }
}

void PatchGrowth::add_star(Index v) {
  if (mesh_.is_fixed(v) && ideal_.is_divided(v)) return;
  for (const Index f : mesh_.faces_of(v)) add_face(f);
}

void PatchGrowth::add_ring() {
  const std::size_t vertices = vertices_.size();
  for (std::size_t i = 0; i < vertices; ++i) add_star(vertices_[i]);
}

// Three quads or more are wanted where faces outside are left to give.
bool PatchGrowth::bends_inwards(Index v) const {
  if (!mesh_.is_fixed(v)) return count_[v] < mesh_.valence(v) && mesh_.valence(v) - count_[v] <= 1;
  for (const Index f : mesh_.faces_of(v)) {
    if (!inside_[f]) continue;
    const IdealValence::Count now = ideal_.sector_count(mesh_, v, f);
    const Index outside = now.quads - count_[v];
    return outside > 0 && now.ideal - outside >= 3;
  }
  return false;
}

// The faces left in the sector of v that the patch has begun.
void PatchGrowth::add_faces_beside(Index v) {
  const auto star = mesh_.faces_of(v);
  const std::vector<Index> faces(star.begin(), star.end());
  for (bool grown = true; grown;) {
    grown = false;
    for (const Index f : faces) {
      if (inside_[f]) continue;
      const Face& face = mesh_.face(f);
      const Index k = corner_of(face, v), first = next_corner(face, k), last = prev_corner(face, k);
      const Index before = mesh_.is_wall(v, first) ? none : mesh_.face_with_edge(first, v);
      const Index after = mesh_.is_wall(v, last) ? none : mesh_.face_with_edge(v, last);
      if (!(before != none && inside_[before]) && !(after != none && inside_[after])) continue;
      add_face(f);
      if (broken_) return;
      grown = true;
    }
  }
}

bool PatchGrowth::close(Index limit) {
  while (!unchecked_.empty()) {
    if (broken_ || static_cast<Index>(faces_.size()) > limit) return false;
    const Index v = unchecked_.back();
    unchecked_.pop_back();
    if (bends_inwards(v)) add_faces_beside(v);
  }
  return !broken_ && static_cast<Index>(faces_.size()) <= limit;
}

// From the rim edge that enters v through face f of the patch to the one that leaves v.
PatchGrowth::Rim PatchGrowth::rim_after(Index v, Index f) const {
  for (;;) {
    const Index next = next_corner(mesh_.face(f), corner_of(mesh_.face(f), v));
    const Index beyond = mesh_.is_wall(v, next) ? none : mesh_.face_with_edge(next, v);
    if (beyond == none || !inside_[beyond]) return {f, next};
    f = beyond;
  }
}

// The loop that holds the first rim vertex found, with a face of the patch at each vertex; false
// when it meets itself.
bool PatchGrowth::walk(std::vector<Index>& loop, std::vector<Index>& face) const {
  const auto on_rim = [&](Index v) { return mesh_.is_fixed(v) || count_[v] < mesh_.valence(v); };
  const auto start = std::find_if(vertices_.begin(), vertices_.end(), on_rim);
  if (start == vertices_.end()) return false;
  Index f = none;
  for (const Index g : mesh_.faces_of(*start)) {
    if (!inside_[g]) continue;
    const Face& corners = mesh_.face(g);
    const Index last = prev_corner(corners, corner_of(corners, *start));
    const Index beyond = mesh_.is_wall(*start, last) ? none : mesh_.face_with_edge(*start, last);
    if (beyond == none || !inside_[beyond]) f = g;
  }
  if (f == none) return false;  // a fixed vertex inside
  bool simple = true;
  Index v = *start;
  do {
    if (on_loop_[v]) {
      simple = false;
      break;
    }
    on_loop_[v] = 1;
    loop.push_back(v);
    const Rim rim = rim_after(v, f);
    face.push_back(rim.face);
    f = rim.face;
    v = rim.next;
  } while (v != *start);
  return simple;
}

bool PatchGrowth::outline(PatchOutline& result) const {
  std::vector<Index> loop, face;
  result = {};
  const bool simple = !broken_ && walk(loop, face);
  if (simple)
    for (const Index v : vertices_)
      if (!on_loop_[v]) result.inside.push_back(v);
  for (const Index v : loop) on_loop_[v] = 0;
  if (!simple) return false;
  // Euler: V - E + F = 1 with E = (4 F - T + L) / 2, and of quads alone if it is refilled.
  const std::size_t length = loop.size(), triangles = static_cast<std::size_t>(triangles_);
  if (length % 2 != 0 || triangles % 2 != 0 ||
      vertices_.size() + triangles / 2 != 1 + faces_.size() + length / 2)
    return false;
  for (const Index v : result.inside) {
    if (mesh_.is_fixed(v)) return false;
    result.weight += irregularity(mesh_.valence(v), 4, false);
  }
  std::vector<Index> corners;
  for (std::size_t i = 0; i < length; ++i) {
    const Index v = loop[i];
    const IdealValence::Count now = ideal_.sector_count(mesh_, v, face[i]);
    const Index outside = now.quads - count_[v], want = now.ideal - outside;
    if (want >= 3) return false;
    result.weight += now.weight(now.quads);
    if (want < 1) result.rim_weight += now.weight(outside + 1);
    if (want <= 1) corners.push_back(static_cast<Index>(i));
  }
  if (corners.empty()) return false;
  for (const Index i : corners) result.corner.push_back(i - corners[0]);
  std::rotate(loop.begin(), loop.begin() + corners[0], loop.end());
  result.loop = std::move(loop);
  return true;
}

}  // namespace lpq
