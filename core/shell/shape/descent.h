// L-BFGS over some vertices of a mesh on a surface, in the manner of cleanup/descent.h: unknowns
// are displacements over the size of their vertex, and every trial lies on the surface.
#pragma once

#include <vector>

#include "base/function_ref.h"
#include "numerics/lbfgs.h"
#include "shell/shape/freedom.h"
#include "shell/shape/space_energy.h"

namespace lpq {

SpaceQuad corners_of(const ShellMesh& mesh, Index quad);

/// Energy of face f with these corners; adds to the gradient by the corners.
using FaceEnergy = FunctionRef<Evaluation(Index f, const SpaceQuad& p, SpaceQuad& gradient)>;

/// Vertices that move, and the quads that count; ascending.
struct DescentPart {
  std::vector<Index> vertices, faces;
};

class ShellDescent {
 public:
  ShellDescent(ShellMesh& mesh, Freedom& freedom);

  /// Moves the vertices downhill for at most `iterations` steps of at most 0.2 of their size each;
  /// fewer when five steps together save less than the share `tolerance` of the energy. Returns the
  /// steps made.
  int run(const DescentPart& part, int iterations, double tolerance, FaceEnergy energy);

 private:
  void find_sizes(const DescentPart& part);
  Evaluation evaluate(const DescentPart& part, FaceEnergy energy, std::span<double> by_unknown);
  void place(const DescentPart& part, std::span<const double> unknowns);

  ShellMesh& mesh_;
  Freedom& freedom_;
  std::vector<double> size_;    // #V
  std::vector<Vec3> gradient_;  // #V
};

}  // namespace lpq
