// The L_p energy of the clipped Voronoi cells and its exact gradient (paper section 3.2,
// [Levy, Liu 2010]): F = sum_i int_{R_i} rho ||M (y - x_i)||_p^p dy with rho = h^-(p+2) and
// M = M(theta), or M(theta) S(mu) in a plane where lengths are not those that count: S v = (v + mu
// conj v) / sqrt(1 - |mu|^2), of determinant 1 (field.h). F has no unit: each cell is measured in
// its own h.
#pragma once

#include <span>
#include <vector>

#include "field/field.h"
#include "lpcvt/integrand.h"
#include "mesh/tri_mesh.h"
#include "voronoi/dual.h"

namespace lpq {

struct EnergyOptions {
  double p = 6;                 // exponent, 2 .. 20; even integers use the closed form
  bool gauss = false;           // force Gauss integration (any p); otherwise closed form for even p
  int gauss_degree = 0;         // degree of the Gauss rule, 0 = chosen from p
  bool metric_gradient = true;  // include d theta / d x and d rho / d x
};

/// Reused between evaluations: after the first one nothing is allocated.
struct EnergyWorkspace {
  /// A site with its frame: M / h = ((xx, xy), (yx, yy)).
  struct SiteFrame {
    double x, y, xx, xy, yx, yy;
  };

  ClippedDual dual;
  std::vector<FieldSample> metric;     // #V  sampled at the sites
  std::vector<StretchSample> stretch;  // #V  or empty: mu there
  std::vector<Index> hints;            // #V  background triangle of each site
  std::vector<double> cell_energy;     // #V  energy of each cell (Fig. 22: divide by the area)
  std::vector<double> cell_area;       // #V

  std::vector<SiteFrame> frames;      // #V
  std::vector<double> torque;         // #V  derivative of the cell's energy by theta
  std::vector<Vec2> shear;            // #V with a stretch: sum of dI/du u, complex
  std::vector<Vec2> vertex_gradient;  // #Voronoi vertices  dF / dC
  std::vector<TriangleNode> rule;     // Gauss rule of degree rule_degree
  int rule_degree = -1;
};

/// Energy and gradient at the positions in `mesh` (a valid constrained Delaunay triangulation).
/// `gradient` has one entry per vertex, zero for fixed ones; pass an empty span for the value only.
/// theta and rho are constant per cell, taken at the site. Cost O(#V).
double lp_energy(const TriMesh& mesh, const Fields& fields, const EnergyOptions& options,
                 EnergyWorkspace& workspace, std::span<Vec2> gradient);

/// The same in steps, for callers that measure or replace one: the metric at the sites, then the
/// energy for a given dual and metric.
void sample_metric(const TriMesh& mesh, const Fields& fields, EnergyWorkspace& workspace);
double integrate_energy(const TriMesh& mesh, const EnergyOptions& options,
                        EnergyWorkspace& workspace, std::span<Vec2> gradient);

}  // namespace lpq
