// The mesh as JSON: plain arrays for scripts and for the web.
#pragma once

#include <string>

#include "mesh/output_mesh.h"

namespace lpq {

/// {"points":[[x,y],..], "quads":[[a,b,c,d],..], "quadRegion":[..], "triangles":[[a,b,c],..],
///  "triangleRegion":[..], "edges":[[a,b],..], "edgeTag":[..], "edgeRegions":[[left,right],..],
///  "taggedPoints":[[point,tag],..], "regions":[name,..], "tags":[name,..]}
/// Indices count from 0; -1 means none. Points in space have three numbers.
std::string write_mesh_json(const OutputMesh& mesh);

}  // namespace lpq
