#include "figures.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "cleanup/cleanup.h"
#include "field/make_fields.h"
#include "lpcvt/optimizer.h"
#include "recombine/recombine.h"

namespace lpq_paper {
namespace {

template <class T>
T need(lpq::Result<T> result) {
  if (!result) {
    std::fprintf(stderr, "%s: %s\n", lpq::code_name(result.error().code),
                 result.error().message.c_str());
    std::exit(4);
  }
  return std::move(*result);
}

}  // namespace

const Start starts[4] = {
    {"A", 0.15, 1, 0.999}, {"B", 0.35, 1, 0.999}, {"C", 0.40, 1, 0.990}, {"D", 0.60, 1, 0.980}};

std::unique_ptr<Scene> make_scene(const lpq::DomainInput& input) {
  auto scene = std::make_unique<Scene>();
  scene->domain = need(lpq::make_domain(input));
  scene->boundary = need(lpq::sample_boundary(scene->domain));
  scene->fields = need(lpq::make_fields(scene->boundary));
  return scene;
}

Optimised optimise(const Scene& scene, const std::vector<lpq::Vec2>& seeds, double p,
                   int iterations, const std::vector<int>& frames) {
  lpq::LpOptions options;
  options.energy.p = p;
  options.max_iterations = iterations;
  lpq::LpOptimizer optimizer =
      need(lpq::LpOptimizer::start(scene.boundary, scene.fields, seeds, options));
  Optimised result;
  result.before = optimizer.mesh();
  for (int i = 0; i <= iterations; ++i) {
    if (std::count(frames.begin(), frames.end(), i) > 0) result.frames.push_back(optimizer.mesh());
    if (optimizer.status() == lpq::LpStatus::running) optimizer.step(1);
  }
  result.after = optimizer.mesh();
  result.tau_before = lpq::tau(result.before);
  result.tau_after = lpq::tau(result.after);
  result.energies = optimizer.energy_history();
  return result;
}

lpq::QuadMesh to_quads(const Scene& scene, const lpq::TriMesh& triangles) {
  lpq::RecombineOptions recombine;
  recombine.alignment_weight = 0;
  lpq::CleanupOptions cleanup;
  cleanup.topology = false;
  return lpq::clean_up(lpq::recombine(triangles, scene.fields, recombine).mesh, scene.fields,
                       cleanup)
      .mesh;
}

}  // namespace lpq_paper
