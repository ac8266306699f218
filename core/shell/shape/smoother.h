// Descents over a mesh on a surface, or a part of it, and what they are judged by.
#pragma once

#include <compare>
#include <vector>

#include "cleanup/smooth.h"
#include "shell/shape/descent.h"
#include "shell/shape/space_energy.h"

namespace lpq {

struct SquaredSides {
  double least = 0, most = 0;
};
/// Of the sides of a face.
SquaredSides squared_sides(const ShellMesh& mesh, Index f);

/// eta of a quad, less than 0 if it is tangled: -1 if it is not strictly convex as the surface sees
/// it or a side has vanished beside the others, -1/2 if it is turned (outside.h); 1 for a triangle.
double signed_eta(const ShapeGround& ground, const ShellMesh& mesh, Index f);

/// For descents that cover the mesh; quads that are mended need their freedom. Takes the size rms
/// of six scans from 0.114 to 0.098, and their mean eta from 0.944 to 0.941.
constexpr double evenness = 3.5;

class ShapeSmoother {
 public:
  ShapeSmoother(const ShapeGround& ground, std::vector<VertexRole> roles,
                const SmoothOptions& options, ShellMesh& mesh);
  ShapeSmoother(const ShapeSmoother&) = delete;

  const Freedom& freedom() const { return freedom_; }

  double judge(Index f) const { return signed_eta(ground_, mesh_, f); }
  std::vector<double> judge_all() const;

  /// Less is better; a quad that is not convex is worse than any that are turned only.
  struct Tangles {
    Index nonconvex = 0, turned = 0;
    auto operator<=>(const Tangles&) const = default;
  };
  struct Verdict {
    Tangles tangled;
    double worst = 1;   // eta
    double energy = 0;  // eta energy of those that are not tangled
  };
  Verdict verdict() const;

  /// All faces at least as good as the bound, and the vertices of such faces alone.
  DescentPart part_above(double bound) const;

  /// Both return the steps made. `area_factor`: times the area term of quads where the surface is
  /// flat.
  int descend_eta(const DescentPart& part, int iterations, double tolerance,
                  double area_factor = 1);
  int descend_mean_ratio(const DescentPart& part, int iterations, double epsilon);
  /// Mean ratio until all faces are strictly convex, or it gets no further.
  void untangle(const DescentPart& part);

  std::vector<Freedom::State> states() const;
  void restore(Index v, const Freedom::State& state) { freedom_.restore(v, state); }
  void restore(const std::vector<Freedom::State>& states);

 private:
  SpaceEtaOptions eta_options() const;
  double target_unit(Index f) const;
  double own_unit(Index f) const;

  const ShapeGround& ground_;
  SmoothOptions options_;
  ShellMesh& mesh_;
  Freedom freedom_;
  ShellDescent descent_;
  std::vector<Vec3> normal_;  // #F  of the surface; during a descent
  std::vector<double> unit_;  // #F  1/h^2; during a descent
  std::vector<char> flat_;    // #F  of the surface; during a descent
};

}  // namespace lpq
