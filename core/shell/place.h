// From a chart's plane back to the surface.
#pragma once

#include <span>

#include "field/field.h"
#include "mesh/surface_mesh.h"
#include "shell/shell_mesh.h"
#include "surface/charts/charts.h"

namespace lpq {

/// Where p of the chart's plane lies on the surface; a point off the chart, which chords cut off
/// its border, goes to the nearest triangle. `fields` are those of chart_fields().
SurfacePlace place_on(const Chart& chart, const Fields& fields, Vec2 p, Index& hint);

Vec3 point_at(const SurfaceMesh& mesh, const SurfacePlace& place);

/// The size there, linear between the vertices of the surface. `size`: #V.
double size_at(std::span<const Tri> triangles, const SurfacePlace& place,
               std::span<const double> size);

/// #places  the body of each; empty if there is one.
std::vector<Index> bodies_at(const SurfaceMesh& mesh, std::span<const SurfacePlace> places);

struct Parting {
  double one_point = 1e-9;  // of the diagonal: vertices nearer to each other lie in one place
  double inward = 0.1;      // of the way to the centroid of the triangle that a vertex lies in
};

/// Free vertices that lie on another one of their body go a little way into their triangles, so
/// that nobody takes the two for one. Cost O(#V log #V).
void part_vertices(const SurfaceMesh& mesh, ShellMesh& shell, const Parting& parting = {});

}  // namespace lpq
