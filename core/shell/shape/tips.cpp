// See tips.h.
#include "shell/shape/tips.h"

#include <algorithm>
#include <limits>

#include "shell/face_fans.h"
#include "shell/nearest_triangle.h"
#include "shell/shape/mend.h"

namespace lpq {
namespace {

constexpr double long_edge = 0.25;  // of the mesh size: from there its middle is looked at, too
constexpr double half_a_size = 0.5;
constexpr double most_steps = 1000;     // along an edge
constexpr double far_off = 0.3;         // of the mean side of the nearest quad
constexpr int rings = 3;                // that may move
constexpr double poor = 0.4;            // eta that quads may fall to
constexpr double slack = 0.005;         // of a worse one
constexpr int passes = 3;               // the later ones for what the first uncovered
constexpr std::size_t most_tips = 200;  // of a pass: a mesh that is too coarse all over stays

/// A place of the surface that is far from the mesh.
struct Tip {
  SurfacePlace place;
  Vec3 point;
  Index quad = none;
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
  explicit TipFinder(const Charted& charted) : charted_(charted) {
    take_vertices();
    take_middles();
    take_insides();
  }

  /// Those inside faces, the farthest first.
  std::vector<Tip> find(const ShellMesh& mesh) const {
    const FaceFans fans = face_fans(mesh);
    const NearestTriangle nearest(fans.points, fans.triangles);
    std::vector<Tip> tips;
    Index hint = 0;
    for (const SurfacePlace& place : places_) {
      const Vec3 point = point_at(charted_.mesh, place);
      const double d = nearest.distance(point, hint);
      const Index f = fans.face[hint];
      const double side = mean_side(mesh, f);
      if (d > far_off * side && mesh.face[f] == charted_.features.face[place.triangle])
        tips.push_back({place, point, f, d / side});
    }
    std::stable_sort(tips.begin(), tips.end(),
                     [](const Tip& a, const Tip& b) { return a.distance > b.distance; });
    return tips;
  }

 private:
  void take_vertices() {
    const SurfaceFeatures& features = charted_.features;
    std::vector<char> passed(charted_.mesh.points.size());
    for (Index i = 0; i < features.edges.count(); ++i)
      if (features.is_feature(i))
        for (const Index v : features.edges.ends[i]) passed[v] = 1;
    for (Index e = 0; e < 3 * charted_.mesh.triangle_count(); ++e) {
      const Index v = charted_.mesh.triangles[triangle_of(e)][e % 3];
      if (passed[v]) continue;
      passed[v] = 1;
      places_.push_back({triangle_of(e), {0, 0, 0}});
      places_.back().weight[e % 3] = 1;
    }
  }

  void take_middles() {
    const SurfaceFeatures& features = charted_.features;
    for (Index i = 0; i < features.edges.count(); ++i) {
      const auto [a, b] = features.edges.ends[i];
      const double length = distance(charted_.mesh.points[a], charted_.mesh.points[b]);
      if (features.is_feature(i) || length < long_edge * charted_.size[a]) continue;
      const Index e = features.edges.half_edges.row(i)[0];
      places_.push_back({triangle_of(e), {0.5, 0.5, 0.5}});
      places_.back().weight[(e + 2) % 3] = 0;
    }
  }

  /// The middle of a triangle, or points half a mesh size apart.
  void take_insides() {
    for (Index t = 0; t < charted_.mesh.triangle_count(); ++t) {
      const Tri& corners = charted_.mesh.triangles[t];
      double longest = 0;
      for (int k = 0; k < 3; ++k)
        longest = std::max(longest, distance(charted_.mesh.points[corners[k]],
                                             charted_.mesh.points[corners[(k + 1) % 3]]));
      const double steps = longest / (half_a_size * charted_.size[corners[0]]);
      if (steps <= 1) continue;
      const int n = std::max(3, static_cast<int>(std::min(steps, most_steps)) + 1);
      for (int i = 1; i < n; ++i)
        for (int j = 1; i + j < n; ++j)
          places_.push_back({t, {1.0 * i / n, 1.0 * j / n, 1.0 * (n - i - j) / n}});
    }
  }

  const Charted& charted_;
  std::vector<SurfacePlace> places_;  // that are looked at: none on features
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
    const Vec3 p = tip.point;
    const ShapePatch patch =
        take_patch(mesh_, roles_, stars_, faces_around(mesh_, stars_, tip.quad, rings));
    if (distance_from(patch.mesh, p) <= far_off) return false;  // by what others did
    const auto before = ShapeSmoother(ground_, patch.roles, options_, copy(patch)).verdict();
    for (const Index v : free_corners(tip.quad, p)) {
      ShapePatch moved = patch;
      if (!put_on(tip, v, moved)) continue;
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

  bool put_on(const Tip& tip, Index v, ShapePatch& patch) const {
    const Index local = index_of(v, patch.vertex);
    if (patch.rim[local]) return false;
    patch.mesh.places[local] = tip.place;
    patch.mesh.points[local] = tip.point;
    patch.roles[local].kind = VertexRole::Kind::fixed;
    return true;
  }

  TipFinder finder_;
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
