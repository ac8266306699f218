// Intermediate values of a run, for pictures and for checks from outside (--stages). All in the
// unit frame; `frame` leads back. Filled only when asked for.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "field/field.h"
#include "geometry/frame.h"
#include "matching/blossom.h"
#include "mesh/quad_mesh.h"
#include "mesh/tri_mesh.h"
#include "voronoi/clipped.h"

namespace lpq {

struct QuadStage {
  std::string name;
  QuadMesh mesh;
};

/// The triangulation after so many iterations of L_p.
struct Iterate {
  int iteration = 0;
  TriMesh mesh;
};

struct Trace {
  UnitFrame frame;
  // Background mesh, crosses, sizes, singularities; never null.
  std::shared_ptr<const Fields> fields = std::make_shared<const Fields>();
  std::vector<Vec2> seeds;
  TriMesh start;                    // triangulation of the seeds
  std::vector<Iterate> iterates;    // between start and end, of mesh_domain only
  TriMesh triangles;                // where the points ended
  TriMesh matched_triangles;        // the same after flips and splits: the nodes of `graph`
  ClippedVoronoi cells;             // of `triangles`
  std::vector<double> cell_energy;  // #V  of `triangles`
  std::vector<double> cell_area;    // #V
  std::vector<Vec2> gradient;       // #V
  double energy = 0;
  double norm = 6;
  std::vector<CostEdge> graph;  // dual graph of the matching
  Matching matching;
  std::vector<QuadStage> quads;  // after each stage
};

/// Where the points ended, with their cells and the energy of each.
void keep_triangles(Trace& trace, const TriMesh& triangles, const Fields& fields);

}  // namespace lpq
