// A hole in the mesh and the faces around it as a small mesh of their own, in which fillings are
// tried: the outline and a few rings of vertices outside it give way, everything else stays.
#pragma once

#include "cleanup/shape_energy.h"
#include "field/field.h"
#include "patches/growth.h"
#include "patches/plan.h"

namespace lpq {

/// What the fields ask of each face.
struct Aims {
  std::vector<double> target;  // 1/h^2
  std::vector<double> share;   // of the size terms
  std::vector<Vec2> pull;      // empty where fields have none
  std::vector<Vec2> stretch;   // likewise

  void append(const Aims& others);
  void clear();
};

/// A filling in its surroundings.
struct Trial {
  QuadMesh mesh;      // vertices of the surroundings first, as numbered there
  Aims aims;          // #F
  Index filled = 0;   // the first faces are the filling's
  double energy = 0;  // of all faces
};

struct RelaxOptions {
  EtaEnergyOptions energy;
  int untangling = 12, first_look = 5, smoothing = 16;  // iterations
  double bound = 1e300;  // a trial that will hardly get below is given up after the first look
};

class Surroundings {
 public:
  /// `rings` of vertices outside the outline may move.
  Surroundings(const QuadTopology& mesh, const Fields& fields, const PatchGrowth& patch,
               const PatchOutline& outline, int rings);

  /// Energy of patch and rings as they are; `invalid` faces count as much as the worst valid one.
  double energy_now(const EtaEnergyOptions& options) const;
  /// Least eta of the same faces.
  double worst_eta_now() const;
  /// How much wider any of them is than the least size in it, 0 where fields have no spots; and the
  /// same of a trial.
  double coarseness_now() const;
  double coarseness(const QuadMesh& mesh) const;

  Trial place(const Filling& filling) const;
  /// Untangles where needed and lowers the energy. False when given up, or when a face stays that
  /// is not strictly convex.
  bool relax(Trial& trial, const RelaxOptions& options) const;

  /// Numbers in the whole mesh, vertices that may not move first.
  const std::vector<Index>& vertices() const { return vertices_; }
  Index pinned() const { return pinned_; }

 private:
  void collect(const PatchGrowth& patch, int rings);
  Index local(Index v) const;
  void aim(Vec2 centre, Aims& aims) const;

  const QuadTopology& mesh_;
  const Fields& fields_;
  const PatchOutline& outline_;
  std::vector<Index> vertices_;
  Index pinned_ = 0;
  std::vector<std::array<Index, 2>> numbers_;  // (vertex, local number), sorted
  std::vector<Index> outside_;                 // faces of the rings
  std::vector<Face> ring_;                     // the same in local numbers
  Aims ring_aims_;
  std::vector<Index> patch_;
  mutable Index hint_ = none;
};

}  // namespace lpq
