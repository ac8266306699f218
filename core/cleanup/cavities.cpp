#include "cleanup/cavities.h"

#include <algorithm>

namespace lpq {
namespace {

bool contains(const std::vector<Index>& list, Index value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

std::vector<Index> neighbours(const QuadTopology& mesh, Index v) {
  std::vector<Index> result;
  for (const Index f : mesh.faces_of(v)) {
    const Face& face = mesh.face(f);
    const Index k = corner_of(face, v);
    for (const Index w : {next_corner(face, k), prev_corner(face, k)})
      if (!contains(result, w)) result.push_back(w);
  }
  return result;
}

// Faces across the edges of the set, each once.
std::vector<Index> faces_beside(const QuadTopology& mesh, const Cavity& cavity) {
  std::vector<Index> result;
  for (const Index f : cavity) {
    const Face& face = mesh.face(f);
    const int n = corner_count(face);
    for (int k = 0; k < n; ++k) {
      const Index g = mesh.face_with_edge(face[(k + 1) % n], face[k]);
      if (g != none && !contains(cavity, g) && !contains(result, g)) result.push_back(g);
    }
  }
  return result;
}

// Face f at v, then `count` - 1 more counter-clockwise around v; empty where a border comes first.
Cavity run_at(const QuadTopology& mesh, Index v, Index f, int count) {
  Cavity run;
  for (Index g = f; g != none && static_cast<int>(run.size()) < count;) {
    if (contains(run, g)) return {};
    run.push_back(g);
    const Index last = prev_corner(mesh.face(g), corner_of(mesh.face(g), v));
    g = mesh.is_wall(v, last) ? none : mesh.face_with_edge(v, last);
  }
  return static_cast<int>(run.size()) == count ? run : Cavity{};
}

Cavity star(const QuadTopology& mesh, Index v) {
  const auto faces = mesh.faces_of(v);
  return {faces.begin(), faces.end()};
}

Cavity joined(Cavity a, const Cavity& b) {
  for (const Index f : b)
    if (!contains(a, f)) a.push_back(f);
  return a;
}

void add_widened(const QuadTopology& mesh, const Cavity& cavity, std::vector<Cavity>& result) {
  for (const Index f : faces_beside(mesh, cavity)) result.push_back(joined(cavity, {f}));
}

}  // namespace

std::vector<Cavity> cavities_at(const QuadTopology& mesh, Index v, bool wide) {
  std::vector<Cavity> result;
  const std::vector<Index> beside = neighbours(mesh, v);
  for (int count = wide ? 1 : 2; count <= 3; ++count)
    for (const Index f : mesh.faces_of(v))
      if (Cavity run = run_at(mesh, v, f, count); !run.empty()) result.push_back(std::move(run));
  if (!mesh.is_fixed(v)) result.push_back(star(mesh, v));
  for (const Index u : beside)
    if (!mesh.is_fixed(u)) result.push_back(star(mesh, u));
  if (!mesh.is_fixed(v)) {
    add_widened(mesh, star(mesh, v), result);
    for (const Index u : beside)
      if (!mesh.is_fixed(u)) result.push_back(joined(star(mesh, v), star(mesh, u)));
  } else {
    for (const Index f : mesh.faces_of(v)) add_widened(mesh, {f}, result);
  }
  if (wide)
    for (const Index u : beside)
      if (!mesh.is_fixed(u)) add_widened(mesh, star(mesh, u), result);
  return result;
}

}  // namespace lpq
