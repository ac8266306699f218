// Regions of one name, as an assembly of parts that are one material: to the programs that read
// meshes a name is a group, and everything that bears it belongs to it (Gmsh's physical surfaces,
// the sets of Abaqus, properties of Nastran).
#pragma once

#include <string>
#include <vector>

#include "base/csr.h"
#include "mesh/output_mesh.h"

namespace lpq {

struct RegionGroups {
  std::vector<Index> group;  // #R, one at least  numbered in the order of their first regions
  Csr<Index> regions;        // of each group, ascending

  Index count() const { return regions.rows(); }
  Index first(Index g) const { return regions.row(g)[0]; }
  Index of(Index region) const { return region == none ? none : group[region]; }
};

/// A region without a name is a group of its own. Cost O(#R log #R).
RegionGroups region_groups(const OutputMesh& mesh);

/// The name of each group, "" where it has none; empty where the mesh has no regions.
std::vector<std::string> group_names(const OutputMesh& mesh, const RegionGroups& groups);

}  // namespace lpq
