// What can be seen of a run at any moment, layer by layer, in the caller's units: plain arrays for
// pictures, debuggers and JavaScript.
#pragma once

#include <vector>

#include "base/csr.h"
#include "pipeline/mesher.h"

namespace lpq {

/// The current triangulation (before the matching: what L_p moves).
struct TriangleLayer {
  std::vector<Vec2> points;    // #V
  std::vector<Tri> triangles;  // #T
  Index fixed = 0;             // vertices of the 1D mesh come first
};

/// Clipped Voronoi cells of the current triangulation, and their energy (paper Fig. 22).
struct CellLayer {
  Csr<Vec2> polygons;           // one row per piece of a cell, counter-clockwise
  std::vector<Index> site;      // #pieces  vertex of the triangulation
  std::vector<double> density;  // #V  energy of the cell / its area
  double energy = 0;            // of all cells
};

/// The cross field on its background mesh (paper section 4).
struct CrossLayer {
  std::vector<Vec2> points;  // #V background
  std::vector<Vec2> axis;    // #V  (cos theta, sin theta) of one arm
  std::vector<Singularity> singularities;
};

/// The size field on the same mesh.
struct SizeLayer {
  std::vector<Vec2> points;    // #V background
  std::vector<Tri> triangles;  // #T
  std::vector<double> h;       // #V  target edge length
};

/// What the matching chose: the triangles it worked on, and each one's partner.
struct MatchingLayer {
  std::vector<Vec2> points;    // #V
  std::vector<Tri> triangles;  // #T
  std::vector<Index> mate;     // #T  triangle merged with, none if left over
  std::vector<Index> extra;    // #T  1 where the pair is joined by an extra edge, not a common one
  std::vector<double> cost;    // #T  of the chosen edge; 10^4 (1 - eta + ...), see recombine.h
};

/// The quads, once matched.
struct QuadLayer {
  std::vector<Vec2> points;    // #V
  std::vector<Face> faces;     // #F  quads first, then triangles
  std::vector<double> eta;     // #F  of a triangle: triangle_eta (mesh/quality.h)
  std::vector<Index> valence;  // #V  faces at the vertex
  std::vector<Index> excess;   // #V  faces beyond the number wanted there; 0 = regular
  Index fixed = 0;
};

TriangleLayer triangle_layer(const Mesher& mesher);
CellLayer cell_layer(const Mesher& mesher);
CrossLayer cross_layer(const Mesher& mesher);
SizeLayer size_layer(const Mesher& mesher);
/// Empty before the matching and without keep_trace().
MatchingLayer matching_layer(const Mesher& mesher);
/// Empty before the matching.
QuadLayer quad_layer(const Mesher& mesher);

}  // namespace lpq
