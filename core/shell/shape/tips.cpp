// See tips.h.
#include "shell/shape/tips.h"

#include <algorithm>
#include <limits>

#include "shell/face_fans.h"
#include "shell/nearest_triangle.h"
#include "shell/shape/mend.h"

namespace lpq {
namespace {

constexpr double far_off = 0.3;         // of the mean side of the nearest quad
constexpr int rings = 3;                // that may move
constexpr double poor = 0.4;            // eta that quads may fall to
constexpr double slack = 0.005;         // of a worse one
constexpr int passes = 2;               // the second for what the first uncovered
constexpr std::size_t most_tips = 200;  // of a pass: a mesh that is too coarse all over stays

/// A vertex of the surface that is far from the mesh.
struct Tip {
  Index vertex = none, quad = none;
  double distance = 0;  // in sides of the quad
};

double mean_side(const ShellMesh& mesh, Index f) {
  const Face& face = mesh.faces[f];
  const int n = corner_count(face);
  double sum = 0;
  for (int k = 0; k < n; ++k) sum += distance(mesh.points[face[k]], mesh.points[face[(k + 1) % n]]);
  return sum / n;
}

class TipFinder {
 public:
  explicit TipFinder(const Charted& charted)
      : charted_(charted), triangle_(charted.mesh.points.size(), none) {
    for (Index t = 0; t < charted.mesh.triangle_count(); ++t)
      for (const Index v : charted.mesh.triangles[t])
        if (triangle_[v] == none) triangle_[v] = t;
    for (Index i = 0; i < charted.features.edges.count(); ++i)
      if (charted.features.is_feature(i))
        for (const Index v : charted.features.edges.ends[i]) triangle_[v] = none;
  }

  /// Those inside faces, the farthest first.
  std::vector<Tip> find(const ShellMesh& mesh) const {
    const FaceFans fans = face_fans(mesh);
    const NearestTriangle nearest(fans.points, fans.triangles);
    std::vector<Tip> tips;
    Index hint = 0;
    for (std::size_t v = 0; v < triangle_.size(); ++v) {
      if (triangle_[v] == none) continue;
      const double d = nearest.distance(charted_.mesh.points[v], hint);
      const Index f = fans.face[hint];
      const double side = mean_side(mesh, f);
      if (d > far_off * side && mesh.face[f] == face_of(static_cast<Index>(v)))
        tips.push_back({static_cast<Index>(v), f, d / side});
    }
    std::sort(tips.begin(), tips.end(), [](const Tip& a, const Tip& b) {
      return a.distance != b.distance ? a.distance > b.distance : a.vertex < b.vertex;
    });
    return tips;
  }

  Index face_of(Index v) const { return charted_.features.face[triangle_[v]]; }

  SurfacePlace place(Index v) const {
    SurfacePlace place{triangle_[v], {0, 0, 0}};
    for (int k = 0; k < 3; ++k)
      place.weight[k] = charted_.mesh.triangles[place.triangle][k] == v ? 1 : 0;
    return place;
  }

 private:
  const Charted& charted_;
  std::vector<Index> triangle_;  // #V  one of those at each vertex, none on features
};

/// Distance of p from faces, over the mean side of the nearest.
double distance_from(const ShellMesh& mesh, Vec3 p) {
  double least = std::numeric_limits<double>::infinity(), side = 1;
  const FaceFans fans = face_fans(mesh);
  for (std::size_t t = 0; t < fans.triangles.size(); ++t) {
    const auto& [a, b, c] = fans.triangles[t];
    const double d =
        distance(p, nearest_in_triangle(p, fans.points[a], fans.points[b], fans.points[c]));
    if (d >= least) continue;
    least = d;
    side = mean_side(mesh, fans.face[t]);
  }
  return least / side;
}

class TipReacher {
 public:
  TipReacher(const Charted& charted, const ShapeGround& ground, const SmoothOptions& options,
             ShellMesh& mesh, std::vector<VertexRole>& roles)
      : finder_(charted),
        points_(charted.mesh.points),
        ground_(ground),
        options_(options),
        mesh_(mesh),
        roles_(roles),
        stars_(faces_at_vertices(mesh)) {}

  Index run() {
    for (int pass = 0; pass < passes; ++pass) {
      const std::vector<Tip> tips = finder_.find(mesh_);
      if (tips.empty() || tips.size() > most_tips) break;
      for (const Tip& tip : tips) reached_ += reach(tip);
    }
    return reached_;
  }

 private:
  bool reach(const Tip& tip) {
    const Vec3 p = points_[tip.vertex];
    const ShapePatch patch =
        take_patch(mesh_, roles_, stars_, faces_around(mesh_, stars_, tip.quad, rings));
    if (distance_from(patch.mesh, p) <= far_off) return false;  // by what others did
    const auto before = ShapeSmoother(ground_, patch.roles, options_, copy(patch)).verdict();
    for (const Index v : free_corners(tip.quad, p)) {
      ShapePatch moved = patch;
      if (!put_on(tip.vertex, v, moved)) continue;
      const auto after = smooth_patch(ground_, options_, moved);
      if (after.tangled > before.tangled || after.worst < std::min(before.worst - slack, poor))
        continue;
      put_back(moved, mesh_, roles_);
      return true;
    }
    return false;
  }

  ShellMesh& copy(const ShapePatch& patch) { return scratch_ = patch.mesh; }

  /// Corners of the quad that walk, the nearest to p first.
  std::vector<Index> free_corners(Index quad, Vec3 p) const {
    std::vector<Index> corners;
    for (const Index v : mesh_.faces[quad])
      if (v != none && roles_[v].kind == VertexRole::Kind::walks) corners.push_back(v);
    std::sort(corners.begin(), corners.end(), [&](Index a, Index b) {
      const double to_a = distance(mesh_.points[a], p), to_b = distance(mesh_.points[b], p);
      return to_a != to_b ? to_a < to_b : a < b;
    });
    return corners;
  }

  bool put_on(Index tip, Index v, ShapePatch& patch) const {
    const Index local = index_of(v, patch.vertex);
    if (patch.rim[local]) return false;
    patch.mesh.places[local] = finder_.place(tip);
    patch.mesh.points[local] = points_[tip];
    patch.roles[local].kind = VertexRole::Kind::fixed;
    return true;
  }

  TipFinder finder_;
  const std::vector<Vec3>& points_;
  const ShapeGround& ground_;
  const SmoothOptions& options_;
  ShellMesh& mesh_;
  std::vector<VertexRole>& roles_;
  Csr<Index> stars_;
  ShellMesh scratch_;
  Index reached_ = 0;
};

}  // namespace

Index reach_tips(const Charted& charted, const ShapeGround& ground, const SmoothOptions& options,
                 ShellMesh& mesh, std::vector<VertexRole>& roles) {
  return TipReacher(charted, ground, options, mesh, roles).run();
}

}  // namespace lpq
