// Smoothing that cannot do harm: vertices of the 1D mesh stay, a strictly convex face stays
// strictly convex, and the worst eta of the mesh falls at most to a floor.
#pragma once

#include "field/field.h"
#include "mesh/quad_mesh.h"

namespace lpq {

struct SmoothOptions {
  int iterations = 100;
  double size_weight = 0.02;  // of the edge-length term beside 1 - eta
  double area_weight = 0;     // of the area term
  double eta_floor = 0.64;    // quads below are pushed up harder
  double rounding = 1e-4;     // of the kinks of 1 - eta (shape_energy.h)
  bool lift = true;           // the flattest faces first; once is enough when smoothing goes on
};

/// Maximises the sum of eta over all free vertices together (shape_energy.h) by L-BFGS. The
/// flattest faces are smoothed first, each with its neighbours alone, so that their tiny steps do
/// not hold up the rest; what stays flat is pinned. In the end moves are taken back where a face is
/// worse than the worst that touched it at the start (and worse than 0.5). Faces that are not
/// strictly convex stay as they are, with their vertices. Cost O(iterations #F).
void smooth_eta(QuadMesh& mesh, const Fields& fields, const SmoothOptions& options = {});

/// 1/h^2 at the centre of every face, from the size field.
std::vector<double> target_inverse_squares(const QuadMesh& mesh, const Fields& fields);
/// The pull at the centre of every face; empty where fields have none.
std::vector<Vec2> target_pulls(const QuadMesh& mesh, const Fields& fields);
/// The stretch there; empty where fields have none.
std::vector<Vec2> target_stretches(const QuadMesh& mesh, const Fields& fields);
/// Shares of the size terms there (shape_energy.h).
std::vector<double> size_shares(const QuadMesh& mesh, const Fields& fields);

}  // namespace lpq
