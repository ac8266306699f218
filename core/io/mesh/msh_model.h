// The geometric model behind a .msh file: which point, curve and surface each node and element
// belongs to, with physical names. Version 4.1 writes it out as $Entities, 2.2 as element tags;
// other formats take their groups and names from it.
#pragma once

#include <string>
#include <vector>

#include "base/csr.h"
#include "io/mesh/region_groups.h"
#include "mesh/output_mesh.h"

namespace lpq {

struct MshModel {
  struct Curve {
    Index left = none, right = none;  // regions
    Index physical = 0;               // 1-based physical curve
    std::vector<Index> edges;         // of the OutputMesh
  };
  std::vector<Curve> curves;               // curve tag = index + 1
  std::vector<std::string> curve_names;    // physical curve tag = index + 1
  RegionGroups groups;                     // physical surface tag = group + 1
  std::vector<std::string> surface_names;  // of the groups
  std::vector<std::string> point_names;    // physical point tag = index + 1
  std::vector<Index> point_physical;       // #tagged_points  1-based
  Csr<Index> faces_of_region;              // surface tag = region + 1

  // The entity that owns each node: the one of lowest dimension it lies on.
  std::vector<Index> node_dimension;  // #V  0, 1 or 2
  std::vector<Index> node_entity;     // #V  0-based, of that dimension
};

/// Cost O(#V + #F + #E log #E).
MshModel make_msh_model(const OutputMesh& mesh);

/// The edges behind each of model.curve_names, in the order of the mesh.
std::vector<std::vector<Index>> edges_of_names(const MshModel& model);

}  // namespace lpq
