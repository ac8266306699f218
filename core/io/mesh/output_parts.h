// What the readers and writers of meshes share: used points, heights, labels, shapes of faces.
#pragma once

#include <string>

#include "mesh/output_mesh.h"

namespace lpq {

/// What a reader takes: meshes with z = 0, or of any height.
enum class MeshScope { plane, space };

/// Renumbers so that every point is a corner of a face; edges and tags of other points vanish.
void drop_unused_points(OutputMesh& mesh);

/// A mesh of which no point has a height is one in the plane.
void drop_flat_heights(OutputMesh& mesh);

/// A region's name, or "region 2" (1-based; "domain" if it is the only one) where it has none.
std::string region_label(const OutputMesh& mesh, Index region);

/// eta of a face (mesh/quality.h); in space of a quad (shell/quality.h), 0 for a triangle.
double output_eta(const OutputMesh& mesh, const Face& face);

}  // namespace lpq
