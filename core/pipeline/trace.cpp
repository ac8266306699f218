#include "pipeline/trace.h"

#include "lpcvt/energy.h"

namespace lpq {

void keep_triangles(Trace& trace, const TriMesh& triangles, const Fields& fields) {
  trace.triangles = triangles;
  EnergyWorkspace workspace;
  EnergyOptions energy;
  energy.p = trace.norm;
  trace.gradient.assign(triangles.points.size(), {});
  trace.energy = lp_energy(triangles, fields, energy, workspace, trace.gradient);
  clip_voronoi(triangles, trace.cells);
  trace.cell_energy = workspace.cell_energy;
  trace.cell_area = workspace.cell_area;
}

}  // namespace lpq
