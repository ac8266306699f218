// lpquad_bench energy
// Cost of one evaluation of the L_p energy, part by part, in nanoseconds per vertex: JSON on
// standard output. The best of many repetitions, on a disc with about 10 000 vertices.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "bench.h"
#include "delaunay/delaunay.h"
#include "domain/boundary.h"
#include "field/make_fields.h"
#include "lpcvt/energy.h"
#include "lpcvt/seeds.h"
#include "support/shapes.h"

namespace {

using namespace lpq;

template <class Work>
double best_nanoseconds(int repetitions, Work work) {
  double best = 1e300;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work(i);
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
    best = std::min(best, spent.count());
  }
  return best;
}

int run(double h) {
  const auto domain = make_domain(lpq_test::disc(h));
  if (!domain) return 1;
  const auto boundary = sample_boundary(*domain);
  if (!boundary) return 1;
  FieldOptions field_options;
  field_options.size = domain->h;
  const auto fields = make_fields(*boundary, field_options);
  if (!fields) return 1;
  const std::vector<Vec2> seeds = isotropic_seeds(*boundary, *fields);
  auto mesh = triangulate(*boundary, seeds);
  if (!mesh) return 1;

  // Positions that differ by a small move, as successive iterations do.
  std::vector<Vec2> moved = seeds;
  Rng rng(1);
  for (Vec2& p : moved) p += domain->h * Vec2{rng.between(-0.02, 0.02), rng.between(-0.02, 0.02)};
  constexpr int repetitions = 60;
  const double vertices = mesh->vertex_count();
  EnergyWorkspace work;
  UpdateWorkspace update_work;
  std::vector<Vec2> gradient(mesh->points.size());
  const auto report = [&](const char* name, double nanoseconds, const char* end = ",") {
    std::printf("  \"%s\": %.1f%s\n", name, nanoseconds / vertices, end);
  };

  std::printf("{\n  \"vertices\": %.0f,\n", vertices);
  report("update", best_nanoseconds(repetitions, [&](int i) {
           update(*mesh, i % 2 ? seeds : moved, &update_work);
         }));
  report("rebuild", best_nanoseconds(5, [&](int) { (void)triangulate(*boundary, seeds); }));
  report("circumcentres and clipping",
         best_nanoseconds(repetitions, [&](int) { clip_dual(*mesh, work.dual); }));
  report("sampling",
         best_nanoseconds(repetitions, [&](int) { sample_metric(*mesh, *fields, work); }));
  for (const double p : {2.0, 4.0, 6.0, 8.0}) {
    const EnergyOptions closed{.p = p}, gauss{.p = p, .gauss = true};
    char name[64];
    std::snprintf(name, sizeof name, "energy and gradient, p = %g, closed form", p);
    report(name, best_nanoseconds(repetitions,
                                  [&](int) { integrate_energy(*mesh, closed, work, gradient); }));
    std::snprintf(name, sizeof name, "energy and gradient, p = %g, Gauss", p);
    report(name, best_nanoseconds(repetitions / 6,
                                  [&](int) { integrate_energy(*mesh, gauss, work, gradient); }));
  }
  report("whole evaluation, p = 6",
         best_nanoseconds(repetitions,
                          [&](int i) {
                            update(*mesh, i % 2 ? seeds : moved, &update_work);
                            lp_energy(*mesh, *fields, {.p = 6}, work, gradient);
                          }),
         "");
  std::printf("}\n");
  return 0;
}

}  // namespace

int lpq_bench::energy(int, char**) { return run(0.0106); }
