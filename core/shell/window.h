// A window: some quads of a shell mesh laid out in a plane, with the part of the surface that they
// lie on, so that planar operations can work on them and the result goes back.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "field/field.h"
#include "mesh/quad_mesh.h"
#include "shell/ball.h"
#include "shell/shell_mesh.h"
#include "shell/stars.h"
#include "surface/charts/charts.h"
#include "surface/charts/part.h"
#include "surface/cross_field.h"

namespace lpq {

struct Window {
  Chart chart;                // one part of the surface in the plane
  Fields fields;              // on it
  QuadMesh quads;             // border vertices and pinned ones are fixed
  std::vector<Index> vertex;  // #V of quads: vertex of the shell mesh
  std::vector<Index> faces;   // of the shell mesh
};

/// Opens windows on one surface and one mesh of it.
class WindowMaker {
 public:
  WindowMaker(const SurfaceMesh& mesh, const SurfaceCrossField& cross,
              std::span<const double> size);

  /// The window of the quads inside the ball; none where it has no good map or holds no quads.
  /// `stars`: of the shell.
  std::optional<Window> open(const ShellMesh& shell, const ShellStars& stars, const Ball& ball);

 private:
  bool map(std::vector<Index> triangles, Chart& chart);
  std::vector<Index> faces_inside(const ShellMesh& shell, const ShellStars& stars, const Ball& ball,
                                  const Chart& chart);
  void drop_bad_rim(const ShellMesh& shell, const Chart& chart, std::vector<Index>& faces) const;
  Vec2 in_plane(const ShellMesh& shell, const Chart& chart, Index v) const;
  void count_outside(const ShellMesh& shell, const ShellStars& stars, Window& window) const;
  void lay_out(const ShellMesh& shell, Window& window);

  const SurfaceMesh& mesh_;
  const SurfaceCrossField& cross_;
  std::span<const double> size_;
  std::vector<char> uncut_;  // #half-edges
  PartTaker taker_;
  std::vector<Index> own_;  // #T of the surface  triangle of the window, none outside calls
};

}  // namespace lpq
