// What a run on a surface gives, and what it tells of itself.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "pipeline/report.h"
#include "shell/distance.h"
#include "shell/seams.h"
#include "shell/shape/shape.h"
#include "shell/shell_mesh.h"
#include "surface/charts/charts.h"
#include "surface/cross_field.h"
#include "surface/features.h"
#include "surface/repair.h"

namespace lpq {

/// The mesh of one of the file's bodies.
struct BodyReport {
  std::string name;
  Index vertices = 0, quads = 0, triangles = 0;
  Index parts = 0;         // connected across edges
  Index border_edges = 0;  // 0: closed
};

struct ShellReport {
  RepairReport repair;
  Index feature_edges = 0, corners = 0, curves = 0, faces = 0;
  Index charts = 0;
  std::vector<SurfaceSingularity> singularities;
  Index rounds = 1;                // of the charts: one more whenever sizes became smaller
  std::vector<BodyReport> bodies;  // empty if the input does not tell them
  SeamStats seams;
  ShapeStats shape;
  QuadQuality quality;  // in space
  SizeFidelity size;
  SurfaceDistance distance;
  double target_size = 0;  // the constant one
  std::uint64_t hash = 0;  // of points and faces
  std::vector<StageTime> times;
  std::vector<Warning> warnings;
};

struct ShellOutcome {
  SurfaceMesh surface;  // as repaired
  ShellMesh mesh;
  std::vector<std::string> group_names;  // of surface.group
  std::vector<std::string> body_names;   // of surface.body
  Atlas atlas;                           // how the surface was cut and mapped
  std::vector<Index> face_group;         // group of each face of the surface; none: of several
  ShellReport report;
};

/// Fills in what is known once the mesh is there: counts of features, charts and bodies, groups of
/// faces, quality, sizes, distances and hash; warnings when quads are not convex, look against the
/// surface or go through each other, or the given surface or its bodies do. `size`: #V, of the
/// surface. Cost O(#T + #F log #F).
void summarise(const SurfaceFeatures& features, const SurfaceCrossField& cross,
               std::span<const double> size, ShellOutcome& outcome);

}  // namespace lpq
