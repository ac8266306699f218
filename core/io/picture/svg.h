// Pictures: meshes, cells and crosses as SVG, light background, y upwards.
#pragma once

#include <span>
#include <string>

#include "field/field.h"
#include "mesh/output_mesh.h"
#include "mesh/tri_mesh.h"
#include "voronoi/clipped.h"

namespace lpq {

/// Quads filled by eta (pale = 1, red = 0), left-over triangles grey, the boundary and inner walls
/// thick, interior vertices of valence other than four as dots: blue 3, red 5, violet others.
std::string draw_quads(const OutputMesh& mesh);
std::string draw_quads(const QuadMesh& mesh);

/// Triangles with vertices of the 1D mesh along thick walls (paper Figs. 2 and 3).
std::string draw_triangles(const TriMesh& mesh);

/// Clipped Voronoi cells filled by their energy per area, dark = high (paper Fig. 22).
/// `cell_energy` and `cell_area` hold one value per vertex of `mesh`.
std::string draw_cells(const TriMesh& mesh, const ClippedVoronoi& cells,
                       std::span<const double> cell_energy, std::span<const double> cell_area);

/// Crosses of the field on a subset of the background's vertices; singularities as dots: blue +1/4
/// (a vertex of valence 3), red -1/4.
std::string draw_crosses(const Fields& fields);

}  // namespace lpq
