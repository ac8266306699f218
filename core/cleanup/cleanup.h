// After the matching: topological repairs and guarded smoothing. Boundary vertices never move,
// walls are never crossed, and every accepted change keeps validity and does not lower the worst
// quality of its neighbourhood below a floor.
#pragma once

#include "field/field.h"
#include "mesh/quad_mesh.h"

namespace lpq {

struct CleanupOptions {
  int smoothing_iterations = 100;  // of the eta optimisation
  double size_weight = 0.02;       // of the edge-length term beside 1 - eta
  double eta_floor = 0.62;         // quads below are pushed up harder
  double rounding = 1e-4;          // of the kinks of 1 - eta
  // Local operations for regularity. Without them only doublets are removed, and connectivity
  // changes elsewhere only where no positions make the faces valid.
  bool topology = true;
  bool cut_darts = false;  // seven quads for each that nothing else made convex (darts.h)
};

struct CleanupStats {
  Index still_invalid = 0;  // faces that are not strictly convex; 0 is the goal
};

struct CleanupResult {
  QuadMesh mesh;
  CleanupStats stats;
};

CleanupResult clean_up(QuadMesh mesh, const Fields& fields, const CleanupOptions& options = {});

}  // namespace lpq
