// The paper's experiments as functions from nothing to numbers and meshes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "domain/boundary.h"
#include "domain/domain.h"
#include "field/field.h"
#include "mesh/quad_mesh.h"
#include "mesh/quality.h"
#include "mesh/tri_mesh.h"

namespace lpq_paper {

/// A domain with its 1D mesh and fields; at a stable address, because optimisers point into it.
struct Scene {
  lpq::Domain domain;
  lpq::BoundaryMesh boundary;
  lpq::Fields fields;
};
std::unique_ptr<Scene> make_scene(const lpq::DomainInput& input);

struct Optimised {
  lpq::TriMesh before, after;
  double tau_before = 0, tau_after = 0;
  std::vector<double> energies;
  std::vector<lpq::TriMesh> frames;  // at the iterations asked for
};
/// L_p from the given interior points (unit frame).
Optimised optimise(const Scene& scene, const std::vector<lpq::Vec2>& seeds, double p,
                   int iterations, const std::vector<int>& frames = {});

/// Matching and the paper's smoothing.
lpq::QuadMesh to_quads(const Scene& scene, const lpq::TriMesh& triangles);

/// Fig. 12: four starts of the 11 x 11 square with 81 interior vertices, from nearly perfect to
/// poor.
struct Start {
  const char* name;
  double jitter;  // in cells
  std::uint64_t seed;
  double paper_tau;  // what the paper reaches from its own start of that name
};
extern const Start starts[4];

}  // namespace lpq_paper
