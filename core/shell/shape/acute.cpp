// See acute.h.
#include "shell/shape/acute.h"

#include <algorithm>
#include <optional>

#include "base/sort_numbers.h"
#include "shell/shape/mend.h"
#include "surface/sharp_chains.h"
#include "surface/sharp_edges.h"

namespace lpq {
namespace {

constexpr double fair = 0.3;         // eta that the poor quad must get
constexpr double poor = 0.32;        // eta of quads that corners move for, until they are that good
constexpr int rings = 3;             // that may move
constexpr double furthest = 0.23;    // of the mesh size: farther, the crease is lost at its end
constexpr int steps = 8;             // on the way there
constexpr double least_gain = 0.02;  // eta, from fair on
constexpr double slack = 0.01;       // eta that the worst quad of a patch may lose
constexpr std::size_t most_corners = 50;  // where more are poor, it is not for their corners

/// The creases that end at corners of the surface.
class Creases {
 public:
  Creases(const Charted& charted, const Tracks& tracks)
      : tracks_(tracks),
        features_(charted.features),
        angles_(edge_angles(charted.mesh, charted.size, features_.edges)),
        chains_(charted.mesh, angles_, FeatureOptions{}.angle, features_),
        curves_at_(curves_at_ends(tracks.curves(), charted.mesh.points.size())),
        roughness_(tracks.curves().is_loop.size(), Roughness::unknown) {}
  Creases(const Creases&) = delete;

  /// Their starts, as tracks with s at the corner's end; none unless all are sharp edges and one is
  /// noise.
  std::vector<TrackPosition> at(Index corner) {
    const SurfaceCurves& curves = tracks_.curves();
    std::vector<TrackPosition> ends;
    bool rough = false;
    for (const Index c : curves_at_.row(corner)) {
      const auto vertices = curves.vertices.row(c);
      if (features_.kind[curves.edges.row(c)[0]] != FeatureKind::sharp) return {};
      rough = rough || is_rough(c);
      if (vertices.front() == corner) ends.push_back({c, 0, none});
      if (vertices.back() == corner) ends.push_back({c, tracks_.length(c), none});
    }
    return rough ? ends : std::vector<TrackPosition>{};
  }

 private:
  enum class Roughness : char { unknown, smooth, rough };

  /// #V  curves that begin or end there, ascending, each once.
  static Csr<Index> curves_at_ends(const SurfaceCurves& curves, std::size_t vertices) {
    return csr_from<Index>(vertices, [&](auto&& emit) {
      for (Index c = 0; c < curves.count(); ++c) {
        const Index first = curves.vertices.row(c).front(), last = curves.vertices.row(c).back();
        emit(first, c);
        if (last != first) emit(last, c);
      }
    });
  }

  bool is_rough(Index c) {
    if (roughness_[c] == Roughness::unknown) {
      const auto vertices = tracks_.curves().vertices.row(c);
      const auto edges = tracks_.curves().edges.row(c);
      const SharpChain chain{{edges.begin(), edges.end()}, {vertices.begin(), vertices.end()}};
      roughness_[c] = chains_.is_rough(chain, false) ? Roughness::rough : Roughness::smooth;
    }
    return roughness_[c] == Roughness::rough;
  }

  const Tracks& tracks_;
  SurfaceFeatures features_;
  std::vector<double> angles_;
  SharpChains chains_;
  Csr<Index> curves_at_;              // #V
  std::vector<Roughness> roughness_;  // #curves
};

class CornerEaser {
 public:
  CornerEaser(const Charted& charted, const ShapeGround& ground, const SmoothOptions& options,
              ShellMesh& mesh, std::vector<VertexRole>& roles)
      : charted_(charted),
        ground_(ground),
        options_(options),
        mesh_(mesh),
        roles_(roles),
        stars_(mesh) {}

  Index run() {
    const std::vector<PoorCorner> corners = poor_corners();
    if (corners.size() > most_corners || is_poor_elsewhere(corners)) return 0;
    for (const auto& [f, v] : corners)
      if (roles_[v].on_track.vertex != none && is_poor(f)) eased_ += ease(f, v);
    return eased_;
  }

 private:
  struct PoorCorner {
    Index face = none, vertex = none;
  };

  /// One more than are looked at, at most.
  std::vector<PoorCorner> poor_corners() {
    std::vector<PoorCorner> corners;
    const auto count = static_cast<Index>(mesh_.faces.size());
    for (Index f = 0; f < count && corners.size() <= most_corners; ++f)
      for (const Index v : mesh_.faces[f])
        if (v != none && roles_[v].on_track.vertex != none && is_poor(f) && !creases_at(v).empty())
          corners.push_back({f, v});
    return corners;
  }

  /// Then no corner makes the whole mesh fair.
  bool is_poor_elsewhere(const std::vector<PoorCorner>& corners) const {
    std::vector<char> near(mesh_.faces.size(), 0);
    for (const PoorCorner& corner : corners)
      for (const Index f : faces_around(mesh_, stars_, corner.face, rings)) near[f] = 1;
    for (Index f = 0; f < static_cast<Index>(near.size()); ++f)
      if (!near[f] && signed_eta(ground_, mesh_, f) < fair) return true;
    return false;
  }

  std::vector<TrackPosition> creases_at(Index v) {
    if (!creases_) creases_.emplace(charted_, ground_.tracks);
    return creases_->at(roles_[v].on_track.vertex);
  }

  bool is_poor(Index f) const {
    const double eta = signed_eta(ground_, mesh_, f);
    return 0 <= eta && eta < poor;
  }

  bool ease(Index f, Index v) {
    const std::vector<TrackPosition> creases = creases_at(v);
    const ShapePatch patch =
        take_patch(mesh_, roles_, stars_, faces_around(mesh_, stars_, f, rings));
    const Index local = index_of(v, patch.vertex);
    const ShapePatch best = best_move(patch, index_of(f, patch.faces), local, creases);
    if (best.roles[local].on_track.vertex != none) return false;
    put_back(best, mesh_, roles_);
    roles_[v] = best.roles[local];
    mesh_.pins[v] = Pin::line;
    return true;
  }

  /// The patch itself if no move is worth it.
  ShapePatch best_move(const ShapePatch& patch, Index f, Index v,
                       const std::vector<TrackPosition>& creases) const {
    ShapePatch best = patch;
    ShapePatch moved = patch;
    const auto before = ShapeSmoother(ground_, patch.roles, options_, moved.mesh).verdict();
    smooth_patch(ground_, options_, moved, evenness);
    double eta = std::max(worst_at(patch, v), worst_at(moved, v));
    eta = eta < fair ? fair : eta + least_gain;
    const double step = furthest / steps * ground_.size_at(patch.mesh.places[v]);
    for (int k = 1; k <= steps && eta < poor; ++k)
      for (const TrackPosition& end : creases) {
        moved = patch;
        if (!put_on(end, k * step, v, moved)) continue;
        const auto now = smooth_patch(ground_, options_, moved, evenness);
        if (now.tangled > before.tangled || now.worst < before.worst - slack) continue;
        if (signed_eta(ground_, moved.mesh, f) < fair || worst_at(moved, v) < eta) continue;
        eta = worst_at(moved, v);
        best = moved;
      }
    return best;
  }

  /// At some way along a track from its end.
  bool put_on(TrackPosition end, double by, Index v, ShapePatch& patch) const {
    if (2 * by > ground_.tracks.length(end.track)) return false;
    end.s += end.s > 0 ? -by : by;
    patch.roles[v].on_track = end;
    patch.mesh.places[v] = ground_.tracks.at(end.track, end.s).place;
    patch.mesh.points[v] = point_at(ground_.surface, patch.mesh.places[v]);
    return true;
  }

  /// Least eta of the faces at a vertex.
  double worst_at(const ShapePatch& patch, Index v) const {
    double worst = 1;
    for (std::size_t f = 0; f < patch.mesh.faces.size(); ++f)
      for (const Index w : patch.mesh.faces[f])
        if (w == v) worst = std::min(worst, signed_eta(ground_, patch.mesh, static_cast<Index>(f)));
    return worst;
  }

  const Charted& charted_;
  const ShapeGround& ground_;
  const SmoothOptions& options_;
  ShellMesh& mesh_;
  std::vector<VertexRole>& roles_;
  FaceStars stars_;
  std::optional<Creases> creases_;  // from the first poor quad on
  Index eased_ = 0;
};

}  // namespace

Index ease_corners(const Charted& charted, const ShapeGround& ground, const SmoothOptions& options,
                   ShellMesh& mesh, std::vector<VertexRole>& roles) {
  const ShellMesh mesh_before = mesh;
  const std::vector<VertexRole> roles_before = roles;
  const Index eased = CornerEaser(charted, ground, options, mesh, roles).run();
  if (eased == 0 || ShapeSmoother(ground, roles, options, mesh).verdict().worst >= fair)
    return eased;
  mesh = mesh_before;
  roles = roles_before;
  return 0;
}

}  // namespace lpq
