// How many points there are, and where one too many or too few is. L_p moves points and never makes
// or removes one, so that a start of the wrong count, or of the right count in the wrong places,
// leaves gaps and crowds: cells of high energy and of low.
//
// To compare meshes of different counts, F needs a price per point: more points always have less
// energy. N square cells of side s (in units of h) on an area of N* h^2 have F = N* E s^p with E
// the energy of the unit square and N = N* / s^2; F + m N is least at s = 1 for m = p E / 2 and no
// other price. In units of E that is F/E + p/2 N: 1 + p/2 per unit of area / h^2 in a perfect grid.
#pragma once

#include <vector>

#include "lpcvt/energy.h"

namespace lpq {

/// Energy of a square cell of side h in line with the cross.
double square_cell_energy(double p);

/// F/E + p/2 N: falls with every exchange worth making. N: points that are not fixed.
double priced_energy(double energy, Index free_points, double p);

struct Exchange {
  std::vector<Vec2> inserted;
  std::vector<Index> removed;  // vertices of the mesh, none of them fixed
  Index size() const { return static_cast<Index>(inserted.size() + removed.size()); }
};

/// Up to `most` points for gaps, and as many vertices that crowd: cells of most and of least
/// energy, at least a few h from each other so that each change has a neighbourhood of its own. A
/// new point is put at the corner of its cell that lies farthest from the site in the maximum norm
/// along the cross. Of `missing` points (negative: too many) that many are inserted beyond those
/// removed, and never more, so that the count comes nearer to what is expected or stays. Empty for
/// a perfect grid. `workspace` holds the energy of `mesh` (lp_energy). Cost O(#V log #V).
Exchange propose_exchange(const TriMesh& mesh, const EnergyWorkspace& workspace, double p,
                          Index most, Index missing);

/// The free points after the exchange: those that stay, in their order, then the new ones.
std::vector<Vec2> points_after(const TriMesh& mesh, const Exchange& exchange);

}  // namespace lpq
