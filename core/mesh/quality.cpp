// Quality measures. eta asks for the largest deviation of an interior angle from a right angle:
// with c = |e1 x e2| and d = e1 . e2 at a corner, |pi/2 - alpha| = atan(|d| / c) while c > 0, so
// the worst corner is the one of largest |d| / c and a single arc tangent is enough. A corner with
// c <= 0 has alpha = 0 or alpha >= pi, hence eta = 0. All figures cost O(#F) but the percentile,
// which sorts.
#include "mesh/quality.h"

#include <algorithm>

#include "base/csr.h"
#include "geometry/predicates.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

/// Neighbours of every vertex with a higher index, once per face that has the edge.
Csr<Index> higher_neighbours(const QuadMesh& mesh) {
  auto result = csr_from<Index>(mesh.points.size(), [&](auto&& emit) {
    for (const Face& face : mesh.faces) {
      const int corners = corner_count(face);
      for (int k = 0; k < corners; ++k) {
        const Index a = face[k], b = face[(k + 1) % corners];
        emit(std::min(a, b), std::max(a, b));
      }
    }
  });
  for (Index v = 0; v < result.rows(); ++v) std::sort(result.row(v).begin(), result.row(v).end());
  return result;
}

struct VertexEdges {
  std::vector<Index> valence;  // edges at the vertex, 0 if unused
  std::vector<char> on_rim;    // on an edge with exactly one face
};

VertexEdges vertex_edges(const QuadMesh& mesh) {
  VertexEdges result;
  result.valence.assign(mesh.points.size(), 0);
  result.on_rim.assign(mesh.points.size(), 0);
  const Csr<Index> neighbours = higher_neighbours(mesh);
  for (Index a = 0; a < neighbours.rows(); ++a) {
    const auto row = neighbours.row(a);
    for (std::size_t i = 0, run = 0; i < row.size(); i += run) {
      for (run = 1; i + run < row.size() && row[i + run] == row[i];) ++run;
      const Index b = row[i];
      ++result.valence[a];
      ++result.valence[b];
      if (run == 1) result.on_rim[a] = result.on_rim[b] = 1;
    }
  }
  return result;
}

void judge_quad(QuadQuality& quality, std::vector<double>& etas, std::array<Vec2, 4> corner) {
  const double area = cross(corner[2] - corner[0], corner[3] - corner[1]);
  if (!(area > 0)) ++quality.inverted;
  // Angles are those of the quad turned to positive area; that it was inverted is counted above.
  if (area < 0) std::swap(corner[1], corner[3]);
  bool convex = true;
  for (Index k = 0; k < 4; ++k)
    convex = convex && orient2d(corner[prev_in_quad(k)], corner[k], corner[next_in_quad(k)]) > 0;
  if (!convex) ++quality.nonconvex;
  const double eta = quad_eta(corner[0], corner[1], corner[2], corner[3]);
  etas.push_back(eta);
  ++quality.eta_histogram[std::min<std::size_t>(19, static_cast<std::size_t>(eta * 20))];
}

}  // namespace

void count_valences(std::span<const Index> valence, std::span<const char> border,
                    QuadQuality& quality) {
  for (std::size_t v = 0; v < valence.size(); ++v) {
    if (valence[v] == 0 || border[v]) continue;
    ++quality.interior_vertices;
    if (valence[v] == 4) ++quality.regular_vertices;
    ++quality.valence_histogram[std::min<Index>(9, valence[v])];
  }
  if (quality.interior_vertices > 0)
    quality.four_valent_percent = 100.0 * quality.regular_vertices / quality.interior_vertices;
}

double percentile(std::span<const double> sorted, double share) {
  if (sorted.empty()) return 0;
  const double position = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (position - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double quad_eta(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Vec2 side[4] = {b - a, c - b, d - c, a - d};
  double worst_cross = 1, worst_dot = 0, worst_ratio = 0;
  for (int k = 0; k < 4; ++k) {
    const Vec2 before = side[(k + 3) & 3];
    const double sine = cross(before, side[k]);
    if (!(sine > 0)) return 0;
    const double cosine = std::abs(dot(before, side[k]));
    const double ratio = cosine / sine;
    if (ratio > worst_ratio) worst_ratio = ratio, worst_cross = sine, worst_dot = cosine;
  }
  return std::max(1 - 2 / pi * arc_tangent(worst_dot, worst_cross), 0.0);
}

// The smallest angle is at least 0 and the largest at most pi; eta is 1 where both are pi / 3.
double triangle_eta(Vec2 a, Vec2 b, Vec2 c) {
  if (!(cross(b - a, c - a) > 0)) return 0;
  const Vec2 corner[3] = {a, b, c};
  double eta = 1;
  for (int k = 0; k < 3; ++k) {
    const Vec2 ahead = corner[(k + 1) % 3] - corner[k], back = corner[(k + 2) % 3] - corner[k];
    const double share = 3 / pi * arc_tangent(cross(ahead, back), dot(ahead, back));
    eta = std::min({eta, share, (3 - share) / 2});
  }
  return std::max(eta, 0.0);
}

double face_eta(const std::vector<Vec2>& points, const Face& face) {
  const Vec2 a = points[face[0]], b = points[face[1]], c = points[face[2]];
  return corner_count(face) == 3 ? triangle_eta(a, b, c) : quad_eta(a, b, c, points[face[3]]);
}

double tau(const TriMesh& mesh) {
  double sum = 0;
  for (const Tri& t : mesh.triangles) {
    const Vec2 side[3] = {mesh.points[t[1]] - mesh.points[t[0]],
                          mesh.points[t[2]] - mesh.points[t[1]],
                          mesh.points[t[0]] - mesh.points[t[2]]};
    const double twice_area = std::abs(cross(side[0], side[1]));
    double largest = 0;
    for (int k = 0; k < 3; ++k) {
      const double product = length(side[k]) * length(side[(k + 1) % 3]);
      if (product > 0) largest = std::max(largest, std::min(twice_area / product, 1.0));
    }
    sum += largest;
  }
  return mesh.triangles.empty() ? 0 : sum / static_cast<double>(mesh.triangles.size());
}

QuadQuality quad_quality(const QuadMesh& mesh) {
  QuadQuality quality;
  std::vector<double> etas;
  etas.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    const Vec2 a = mesh.points[face[0]], b = mesh.points[face[1]], c = mesh.points[face[2]];
    if (corner_count(face) == 4) {
      judge_quad(quality, etas, {a, b, c, mesh.points[face[3]]});
    } else {
      ++quality.triangles;
      if (!(cross(b - a, c - a) > 0)) ++quality.inverted;
    }
  }
  quality.quads = static_cast<Index>(etas.size());
  if (!etas.empty()) {
    double sum = 0;
    for (double eta : etas) sum += eta;
    quality.eta_mean = sum / static_cast<double>(etas.size());
    std::sort(etas.begin(), etas.end());
    quality.eta_min = etas.front();
    quality.eta_p5 = percentile(etas, 0.05);
  }
  const VertexEdges edges = vertex_edges(mesh);
  count_valences(edges.valence, edges.on_rim, quality);
  return quality;
}

}  // namespace lpq
