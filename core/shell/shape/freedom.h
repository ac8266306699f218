// What the vertices of a mesh on a surface may do: corners stay, vertices on features slide along
// their track between their neighbours, all others walk on the surface. Unknowns are displacements
// from an anchor, in units of the vertex; positions are on the surface whatever the unknowns are.
#pragma once

#include <array>
#include <vector>

#include "shell/shape/ground.h"

namespace lpq {

/// What a vertex may do. A vertex on a track that is fixed still bounds its neighbours there.
struct VertexRole {
  enum class Kind : char { fixed, slides, walks };
  Kind kind = Kind::walks;
  TrackPosition on_track;
};

/// Of all vertices of a mesh that has its nodes first (shape.h).
std::vector<VertexRole> vertex_roles(const Charted& charted, const Tracks& tracks,
                                     const ShellMesh& mesh);

class Freedom {
 public:
  using Kind = VertexRole::Kind;

  /// Puts fixed vertices on corners of the surface exactly there.
  Freedom(const ShapeGround& ground, std::vector<VertexRole> roles, ShellMesh& mesh);

  int unknowns(Index v) const { return static_cast<int>(role_[v].kind); }
  const std::vector<VertexRole>& roles() const { return role_; }

  /// Starts displacements of these vertices anew from where they are.
  void anchor(std::span<const Index> vertices);
  /// Moves v to a displacement from its anchor: one number for vertices that slide, two for those
  /// that walk.
  void place(Index v, const double* displacement);
  /// The derivative by the displacement, of something with this derivative by the position.
  void pull_back(Index v, Vec3 by_position, double* by_displacement) const;

  /// A vertex as it is, to be put back.
  struct State {
    SurfacePlace place;
    double s = 0;
    Vec3 point;
  };
  State state(Index v) const { return {mesh_.places[v], role_[v].on_track.s, mesh_.points[v]}; }
  void restore(Index v, const State& state);

 private:
  struct Anchor {
    SurfacePlace place;
    double s = 0, low = 0, high = 0;  // on the track, with bounds
  };
  void find_neighbours();
  void anchor_on_track(Index v);
  double slide_towards(Index track, double behind, double s, double ahead, double bound) const;
  void slide(Index v, double by);
  void walk(Index v, Vec2 by);

  const ShapeGround& ground_;
  ShellMesh& mesh_;
  std::vector<VertexRole> role_;                  // #V
  std::vector<std::array<Index, 2>> neighbours_;  // #V  on the track, none at its ends
  std::vector<Anchor> anchor_;                    // #V
  std::vector<std::array<Vec3, 2>> axes_;         // #V  d position / d displacement
};

}  // namespace lpq
