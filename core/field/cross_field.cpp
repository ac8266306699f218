#include "field/cross_field.h"

#include <algorithm>

#include "base/csr.h"
#include "numerics/sparse.h"

namespace lpq {
namespace {

// Below this length the mean of two unit values of walls or guides says nothing: their crosses
// differ by more than about 36 degrees of the possible 45.
constexpr double consistent_mean = 0.3;
// Areas of needle triangles are kept above this share of their squared longest edge, or rounding
// could make an entry of the stiffness matrix negative.
constexpr double least_area_ratio = 1e-13;

struct Edges {
  std::vector<Index> of_half_edge;  // #half-edges
  std::vector<Index> half_edge;     // #edges  one of its half-edges
  std::vector<char> wall, guided;   // #edges
};

Edges edges_of(const TriMesh& mesh) {
  Edges edges;
  edges.of_half_edge.assign(mesh.twins.size(), none);
  for (Index e = 0; e < static_cast<Index>(mesh.twins.size()); ++e) {
    const Index twin = mesh.twins[e];
    if (twin != none && twin < e) {
      edges.of_half_edge[e] = edges.of_half_edge[twin];
      continue;
    }
    edges.of_half_edge[e] = static_cast<Index>(edges.half_edge.size());
    edges.half_edge.push_back(e);
    edges.wall.push_back(twin == none);
  }
  return edges;
}

Vec2 edge_vector(const TriMesh& mesh, Index e) {
  return mesh.points[mesh.target(e)] - mesh.points[mesh.origin(e)];
}

Vec2 normalised(Vec2 z) {
  const double norm = length(z);
  return norm > 0 ? (1 / norm) * z : Vec2{0, 0};
}

// Crouzeix-Raviart stiffness: K_km = e_k . e_m / area for the edge vectors of a triangle.
void assemble(const TriMesh& mesh, const Edges& edges, std::span<const Index> unknown,
              std::span<const Vec2> value, std::vector<Triplet>& matrix, std::vector<double>& rhs) {
  const std::size_t n = rhs.size() / 2;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    Vec2 side[3];
    double longest2 = 0;
    for (Index k = 0; k < 3; ++k) {
      side[k] = edge_vector(mesh, 3 * t + k);
      longest2 = std::max(longest2, squared_length(side[k]));
    }
    const double area = std::max(0.5 * cross(side[0], side[1]), least_area_ratio * longest2);
    for (Index k = 0; k < 3; ++k) {
      const Index row = unknown[edges.of_half_edge[3 * t + k]];
      if (row == none) continue;
      for (Index m = 0; m < 3; ++m) {
        const double entry = dot(side[k], side[m]) / area;
        const Index edge = edges.of_half_edge[3 * t + m], column = unknown[edge];
        if (column == none) {
          rhs[row] -= entry * value[edge].x;
          rhs[n + row] -= entry * value[edge].y;
        } else if (column <= row) {
          matrix.push_back({row, column, entry});
        }
      }
    }
  }
}

// The value that holds on an edge; zero where there is none.
Vec2 given_on(const TriMesh& mesh, Index e, bool wall, const ChordTree& guides) {
  if (wall) return cross_of(edge_vector(mesh, e));
  const auto [sum, count] =
      guides.meeting(mesh.points[mesh.origin(e)], mesh.points[mesh.target(e)]);
  return length(sum) > consistent_mean * count ? normalised(sum) : Vec2{0, 0};
}

std::vector<Vec2> solve_on_edges(const TriMesh& mesh, Edges& edges, const ChordTree& guides) {
  std::vector<Vec2> value(edges.half_edge.size());
  edges.guided.assign(value.size(), 0);
  std::vector<Index> unknown(edges.half_edge.size(), none);
  Index n = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    value[i] = given_on(mesh, edges.half_edge[i], edges.wall[i] != 0, guides);
    if (value[i] == Vec2{0, 0})
      unknown[i] = n++;
    else
      edges.guided[i] = !edges.wall[i];
  }
  std::vector<Triplet> matrix;
  matrix.reserve(static_cast<std::size_t>(3) * mesh.twins.size());
  std::vector<double> rhs(2 * static_cast<std::size_t>(n), 0.0), solution;
  assemble(mesh, edges, unknown, value, matrix, rhs);
  solve_spd(n, matrix, rhs, 2, solution);
  for (std::size_t i = 0; i < value.size(); ++i)
    if (unknown[i] != none)
      value[i] = {solution[unknown[i]], solution[static_cast<std::size_t>(n) + unknown[i]]};
  return value;
}

struct Mean {
  Vec2 sum;
  Index count = 0;
  void add(Vec2 z) {
    sum += z;
    ++count;
  }
  bool agrees() const { return count > 0 && length(sum) > consistent_mean * count; }
};

// Wall vertices take their walls' values where these agree, others those of guided edges; where
// they cancel (a corner of 45 degrees is the worst) the solution beside the corner decides, and
// only then the first wall.
std::vector<Vec2> average_to_vertices(const TriMesh& mesh, const Edges& edges,
                                      std::span<const Vec2> value) {
  const std::size_t count = mesh.points.size();
  std::vector<Vec2> inner(count), first(count);
  std::vector<Mean> walls(count), guides(count);
  for (std::size_t i = 0; i < value.size(); ++i) {
    const Index e = edges.half_edge[i];
    for (const Index v : {mesh.origin(e), mesh.target(e)}) {
      if (edges.wall[i]) {
        if (walls[v].count == 0) first[v] = value[i];
        walls[v].add(value[i]);
      } else {
        inner[v] += value[i];
        if (edges.guided[i]) guides[v].add(value[i]);
      }
    }
  }
  std::vector<Vec2> z(count);
  for (std::size_t v = 0; v < count; ++v) {
    z[v] = normalised(walls[v].agrees()    ? walls[v].sum
                      : guides[v].agrees() ? guides[v].sum
                                           : inner[v]);
    if (squared_length(z[v]) == 0) z[v] = first[v];
  }
  return z;
}

// Every end of an edge that a guide holds is held.
std::vector<Vec2> pull_of(const TriMesh& mesh, const Edges& edges, std::span<const Vec2> z) {
  std::vector<Vec2> pull(z.size());
  for (std::size_t i = 0; i < edges.guided.size(); ++i)
    if (edges.guided[i])
      for (const Index v : {mesh.origin(edges.half_edge[i]), mesh.target(edges.half_edge[i])})
        pull[v] = z[v];
  return pull;
}

// Winding number of z round a triangle by counting crossings of the negative real axis along the
// shorter arcs: signs of products, no angles.
int winding(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 z[3] = {a, b, c};
  int turns = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec2 from = z[k], to = z[(k + 1) % 3];
    const double side = cross(from, to);
    if (from.y >= 0 && to.y < 0 && side > 0) ++turns;
    if (from.y < 0 && to.y >= 0 && side < 0) --turns;
  }
  return turns;
}

}  // namespace

CrossField solve_cross_field(const TriMesh& mesh, std::span<const Chord> guides) {
  Edges edges = edges_of(mesh);
  const std::vector<Vec2> value = solve_on_edges(mesh, edges, ChordTree(guides));
  CrossField field{average_to_vertices(mesh, edges, value), {}};
  if (!guides.empty()) field.pull = pull_of(mesh, edges, field.z);
  return field;
}

std::vector<Singularity> find_singularities(const TriMesh& mesh, std::span<const Vec2> z) {
  std::vector<int> index(mesh.triangles.size());
  std::vector<Index> turning;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    index[t] = winding(z[a], z[b], z[c]);
    if (index[t] != 0) turning.push_back(t);
  }
  // Opposite pairs that share a vertex are one resolved defect of the discrete field, not two.
  std::vector<std::array<Index, 2>> at_vertex;  // (vertex, triangle)
  for (const Index t : turning)
    for (const Index v : mesh.triangles[t]) at_vertex.push_back({v, t});
  std::sort(at_vertex.begin(), at_vertex.end());
  for (std::size_t i = 0; i < at_vertex.size(); ++i)
    for (std::size_t j = i + 1; j < at_vertex.size() && at_vertex[j][0] == at_vertex[i][0]; ++j) {
      int &first = index[at_vertex[i][1]], &second = index[at_vertex[j][1]];
      if (first * second < 0) first = second = 0;
    }
  std::vector<Singularity> result;
  for (const Index t : turning) {
    if (index[t] == 0) continue;
    const auto [a, b, c] = mesh.triangles[t];
    result.push_back({(1.0 / 3) * (mesh.points[a] + mesh.points[b] + mesh.points[c]), index[t]});
  }
  return result;
}

}  // namespace lpq
