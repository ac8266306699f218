#include "surface/sharp_chains.h"

#include <algorithm>

namespace lpq {
namespace {

// Of the bend of a chain: how uneven the surface beside a crease may be. Machined parts, with flat
// or evenly round faces, have 0.1 and less; scans mostly 0.3 and more.
constexpr double uneven = 0.2;
// The same beside a side that is flat, but for what rounding leaves.
constexpr double flat = 0.02;
// How many sides of triangles say whether it is: as many as are looked at where the triangles along
// the chain have fewer, and the fewest that are enough, which a hexagon has inside. Fewer are flat
// by chance, such as the diagonals of quads. Sides that are features are not counted.
constexpr double sides_seen = 16, fewest_sides = 6;
// Cosine of the turn with which what is left at a junction is one chain.
constexpr double straight_on = 0.5;

}  // namespace

bool Unevenness::is_beyond(double most) const {
  const double limit = most * bend / on;
  return squares > limit * limit * beside;
}

SharpChains::SharpChains(const SurfaceMesh& mesh, std::span<const double> angles,
                         double sharp_angle, SurfaceFeatures& features)
    : mesh_(mesh),
      edges_(features.edges),
      points_(mesh.points),
      angles_(angles),
      sharp_angle_(sharp_angle),
      features_(features),
      at_(edges_at_vertices(features.edges, mesh.vertex_count())),
      valence_(mesh.points.size(), 0),
      sharp_valence_(mesh.points.size(), 0) {
  for (Index i = 0; i < edges_.count(); ++i)
    for (const Index v : edges_.ends[i]) {
      valence_[v] += features.is_feature(i);
      sharp_valence_[v] += features.kind[i] == FeatureKind::sharp;
    }
  for (const Index n : sharp_valence_) was_junction_.push_back(n > 2);
}

Index SharpChains::feature_at(Index v) const {
  const auto row = at_.row(v);
  const auto found =
      std::find_if(row.begin(), row.end(), [this](Index i) { return features_.is_feature(i); });
  return found == row.end() ? none : *found;
}

SharpChain SharpChains::through(Index edge) const {
  SharpChain chain{{edge}, {edges_.ends[edge][0], edges_.ends[edge][1]}};
  walk(chain);
  if (chain.is_closed()) return chain;
  std::reverse(chain.edges.begin(), chain.edges.end());
  std::reverse(chain.vertices.begin(), chain.vertices.end());
  walk(chain);
  return chain;
}

/// On from its last vertex.
void SharpChains::walk(SharpChain& chain) const {
  while (!chain.is_closed()) {
    const Index v = chain.vertices.back();
    if (sharp_valence_[v] != 2) return;
    const auto row = at_.row(v);
    const auto next = std::find_if(row.begin(), row.end(), [&](Index i) {
      return features_.kind[i] == FeatureKind::sharp && i != chain.edges.back();
    });
    if (was_junction_[v] && !goes_on(chain.edges.back(), v, *next)) return;
    chain.edges.push_back(*next);
    chain.vertices.push_back(edges_.other_end(*next, v));
  }
}

bool SharpChains::goes_on(Index edge, Index v, Index next) const {
  const Vec3 in = points_[v] - points_[edges_.other_end(edge, v)];
  const Vec3 out = points_[edges_.other_end(next, v)] - points_[v];
  return dot(in, out) > straight_on * length(in) * length(out);
}

void SharpChains::remove(const SharpChain& chain) {
  for (const Index edge : chain.edges) {
    features_.kind[edge] = FeatureKind::smooth;
    for (const Index v : edges_.ends[edge]) {
      --valence_[v];
      --sharp_valence_[v];
    }
  }
}

/// What a chain that fades becomes beyond its end is not beside it.
bool SharpChains::is_ahead(const SharpChain& chain, std::size_t k, Index edge) const {
  return !chain.is_closed() &&
         ((k == 0 && goes_on(chain.edges.front(), chain.vertices.front(), edge)) ||
          (k == chain.edges.size() && goes_on(chain.edges.back(), chain.vertices.back(), edge)));
}

bool SharpChains::is_rough(const SharpChain& chain, bool may_fade) const {
  Unevenness around;
  for (const Index edge : chain.edges) around.bend += angles_[edge];
  around.on = static_cast<double>(chain.edges.size());
  for (std::size_t k = 0; k < chain.vertices.size(); ++k)
    for (const Index i : at_.row(chain.vertices[k])) {
      if (features_.is_feature(i) || angles_[i] > sharp_angle_) continue;
      if (may_fade && is_ahead(chain, k, i)) continue;
      around.squares += angles_[i] * angles_[i];
      ++around.beside;
    }
  return around.is_beyond(uneven);
}

std::vector<Index> SharpChains::triangles_beside(const SharpChain& chain, bool left) const {
  std::vector<Index> triangles;
  for (std::size_t k = 0; k < chain.edges.size(); ++k)
    for (const Index e : edges_.half_edges.row(chain.edges[k]))
      if ((mesh_.origin(e) == chain.vertices[k]) == left) triangles.push_back(triangle_of(e));
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

/// Looks at their sides, and on from there to the nearest others.
bool SharpChains::is_flat_from(std::vector<Index> triangles, Unevenness around) const {
  const auto for_each_open_side = [&](Index t, auto&& visit) {
    for (Index e = 3 * t; e < 3 * t + 3; ++e)
      if (const Index i = edges_.edge_of[e]; !features_.is_feature(i)) visit(e, i);
  };
  const auto add = [&](Index t) {
    for_each_open_side(t, [&](Index, Index i) {
      around.squares += angles_[i] * angles_[i];
      ++around.beside;
    });
  };
  for (const Index t : triangles) add(t);
  for (std::size_t n = 0; n < triangles.size() && around.beside < sides_seen; ++n)
    for_each_open_side(triangles[n], [&](Index e, Index) {
      const Index t = triangle_of(mesh_.twins[e]);
      if (std::find(triangles.begin(), triangles.end(), t) != triangles.end()) return;
      triangles.push_back(t);
      add(t);
    });
  return around.beside >= fewest_sides && !around.is_beyond(flat);
}

/// A bump of one vertex, seen from its foot.
bool SharpChains::is_around_vertex(const SharpChain& chain, bool left) const {
  if (!chain.is_closed()) return false;
  Index apex = none;
  for (std::size_t k = 0; k < chain.edges.size(); ++k)
    for (const Index e : edges_.half_edges.row(chain.edges[k])) {
      if ((mesh_.origin(e) == chain.vertices[k]) != left) continue;
      const Index v = mesh_.origin(prev_in_triangle(e));
      if (apex != none && v != apex) return false;
      apex = v;
    }
  return true;
}

bool SharpChains::has_flat_side(const SharpChain& chain) const {
  Unevenness around;
  for (const Index edge : chain.edges) around.bend += angles_[edge];
  around.on = static_cast<double>(chain.edges.size());
  const auto is_flat = [&](bool left) {
    return !is_around_vertex(chain, !left) && is_flat_from(triangles_beside(chain, left), around);
  };
  return is_flat(true) || is_flat(false);
}

}  // namespace lpq
