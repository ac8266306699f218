// lpquad_ablation [--refine N] DOMAIN.json ...: what each step after the matching is worth. Runs
// the chain on every domain, boundary kept (refined where it cannot be; with --refine everywhere,
// the size an Nth of the diagonal), with steps left out one at a time, and prints the table of
// tests/FIGURES.md.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "cleanup/cleanup.h"
#include "cleanup/ideal_valence.h"
#include "cleanup/shape_energy.h"
#include "cleanup/smooth.h"
#include "delaunay/delaunay.h"
#include "io/domain/json_domain.h"
#include "lpcvt/restarts.h"
#include "lpcvt/seeds.h"
#include "mesh/quality.h"
#include "patches/remesh.h"
#include "pipeline/prepare.h"
#include "pipeline/shape_options.h"
#include "recombine/recombine.h"

using namespace lpq;

namespace {

struct Variant {
  const char* name;
  bool cavities = true, patches = true, rounded = true, annealed = false;
  int restarts = -1;  // of L_p from an isotropic start; -1 = the aligned start, no L_p
  double size = Options{}.size_weight;
  int smoothing = 300;
  std::vector<PatchPass> passes = PatchOptions{}.passes;
};

const Variant variants[] = {
    {.name = "all steps"},
    {.name = "without cavities", .cavities = false},
    {.name = "without patches", .patches = false},
    {.name = "patches up to 60 quads", .passes = {{20}, {60}}},
    {.name = "without the size terms", .size = 0},
    {.name = "without rounding of kinks", .rounded = false},
    {.name = "without the last smoothing", .smoothing = 0},
    {.name = "with annealing", .annealed = true},
    {.name = "isotropic start, L_p", .restarts = 0},
    {.name = "the same with restarts", .restarts = 10},
    {.name = "isotropic start, L_p, without patches", .patches = false, .restarts = 0},
    {.name = "the same with restarts", .patches = false, .restarts = 10},
};

struct Sums {
  double eta = 0, least = 0, p5 = 0, regular = 0, irregular = 0, forced = 0, cpu = 0, quads = 0;
  int domains = 0;
};

// Sum of (4 - quads) over the interior vertices, forced by the turning of the boundary.
double forced_irregularity(const QuadMesh& mesh, const IdealValence& ideal,
                           const QuadTopology& topology) {
  Index edges = 0;
  for (const Face& face : mesh.faces) edges += corner_count(face);
  edges = (edges + mesh.fixed) / 2;
  const Index chi = topology.vertex_count() - edges + static_cast<Index>(mesh.faces.size());
  double sum = 4.0 * chi;
  for (Index v = 0; v < mesh.fixed; ++v)
    sum -= 2.0 - ideal.sector_count(topology, v, topology.faces_of(v)[0]).ideal;
  return sum < 0 ? -sum : sum;
}

void remesh(const PatchOptions& options, const Fields& fields, QuadMesh& mesh) {
  PatchRemesher remesher(std::move(mesh), fields, options);
  while (remesher.step(1000)) {
  }
  mesh = remesher.mesh();
}

Result<TriMesh> triangles_with(const Variant& variant, const Preparation& prepared) {
  const BoundaryMesh& boundary = prepared.boundary;
  const Fields& fields = prepared.fields;
  if (variant.restarts < 0) return triangulate(boundary, aligned_seeds(boundary, fields));
  auto optimiser = LpRestarts::start(boundary, fields, isotropic_seeds(boundary, fields), {},
                                     {.rounds = variant.restarts});
  if (!optimiser) return optimiser.error();
  while (optimiser->step(100) == LpStatus::running) {
  }
  return optimiser->mesh();
}

QuadMesh mesh_with(const Variant& variant, const Preparation& prepared) {
  const auto triangles = triangles_with(variant, prepared);
  if (!triangles) return {};
  const Options options{.size_weight = variant.size};
  CleanupOptions cleanup = cleanup_before_patches(options);
  cleanup.topology = variant.cavities;
  SmoothOptions smoothing = shape_smoothing(options);
  PatchOptions patches = patch_options(options);
  patches.passes = variant.passes;
  if (variant.rounded) smoothing.rounding = coarse_rounding;
  cleanup.rounding = patches.energy.rounding = smoothing.rounding;
  QuadMesh mesh = recombine(*triangles, prepared.fields, {}).mesh;
  mesh = clean_up(std::move(mesh), prepared.fields, cleanup).mesh;
  if (variant.patches) remesh(patches, prepared.fields, mesh);
  const auto finish = [&] {
    for (int done = 0; done < variant.smoothing; done += smoothing.iterations) {
      smooth_eta(mesh, prepared.fields, smoothing);
      if (variant.rounded) smoothing.rounding = fine_rounding;
    }
  };
  finish();
  if (!variant.annealed) return mesh;
  remesh(annealing_options(options), prepared.fields, mesh);
  smoothing.rounding = coarse_rounding;
  finish();
  return mesh;
}

void add(const Variant& variant, const Preparation& prepared, Sums& sums) {
  const std::clock_t start = std::clock();
  const QuadMesh mesh = mesh_with(variant, prepared);
  sums.cpu += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (mesh.faces.empty()) return;
  const QuadTopology topology(mesh);
  const IdealValence ideal(topology);
  const QuadQuality quality = quad_quality(mesh);
  sums.eta += quality.eta_mean;
  sums.least += quality.eta_min;
  sums.p5 += quality.eta_p5;
  sums.regular += quality.four_valent_percent;
  sums.irregular += quality.interior_vertices - quality.regular_vertices;
  sums.forced += forced_irregularity(mesh, ideal, topology);
  sums.quads += quality.quads;
  ++sums.domains;
}

double diagonal(const DomainInput& input) {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  for (const auto& region : input.regions)
    for (const Loop& loop : region.loops)
      for (const Vec2 p : loop) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
  return length(high - low);
}

std::vector<Preparation> prepare_all(double refine, int count, char** files) {
  std::vector<Preparation> result;
  for (int i = 0; i < count; ++i) {
    std::ifstream file(files[i], std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto read = read_json_domain(text);
    if (!read) continue;
    const DomainInput& input = read->domain;
    const bool keep = refine == 0;
    const double size = keep ? 0 : diagonal(input) / refine;
    auto prepared = prepare(input, {.size = size, .keep_boundary = keep}, {});
    if (!prepared && keep) prepared = prepare(input, {}, {});
    if (prepared) result.push_back(std::move(*prepared));
  }
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  const bool refine = argc > 2 && std::string(argv[1]) == "--refine";
  const int first = refine ? 3 : 1;
  const std::vector<Preparation> domains =
      prepare_all(refine ? std::strtod(argv[2], nullptr) : 0, argc - first, argv + first);
  if (domains.empty()) {
    std::fprintf(stderr, "usage: lpquad_ablation [--refine N] DOMAIN.json ...\n");
    return 2;
  }
  std::printf(
      "| %zu domains | mean eta | mean least | mean 5th percentile | 4-valent | irregular "
      "(forced) | CPU s per 10k quads |\n|---|---|---|---|---|---|---|\n",
      domains.size());
  for (const Variant& variant : variants) {
    Sums sums;
    for (const Preparation& domain : domains) add(variant, domain, sums);
    const double n = sums.domains;
    std::printf("| %s | %.4f | %.3f | %.3f | %.2f %% | %.0f (%.0f) | %.2f |\n", variant.name,
                sums.eta / n, sums.least / n, sums.p5 / n, sums.regular / n, sums.irregular,
                sums.forced, 1e4 * sums.cpu / sums.quads);
  }
}
