// lpquad_paper OUT_DIR: reproduces the experiments of the paper, writes their pictures as SVG and
// prints the tables of tests/FIGURES.md.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "figures.h"
#include "io/picture/svg.h"
#include "lpcvt/energy.h"
#include "lpcvt/seeds.h"
#include "support/shapes.h"

using namespace lpq_paper;

namespace {

std::filesystem::path out_dir;

void save(const std::string& name, const std::string& content) {
  std::ofstream(out_dir / name, std::ios::binary) << content;
}

std::string cells_picture(const Scene& scene, const lpq::TriMesh& mesh, double p) {
  lpq::EnergyWorkspace workspace;
  lpq::EnergyOptions options;
  options.p = p;
  lpq::lp_energy(mesh, scene.fields, options, workspace, {});
  lpq::ClippedVoronoi cells;
  lpq::clip_voronoi(mesh, cells);
  return lpq::draw_cells(mesh, cells, workspace.cell_energy, workspace.cell_area);
}

// Fig. 19's curve: energy over its first value, by iteration.
std::string curve_picture(const std::vector<double>& energies) {
  std::string path;
  char point[64];
  const double last = static_cast<double>(energies.size() - 1);
  const double low = energies.back() / energies.front();
  for (std::size_t i = 0; i < energies.size(); ++i) {
    std::snprintf(point, sizeof point, "%s%.2f %.2f", i == 0 ? "M" : " L",
                  50 + 500 * static_cast<double>(i) / last,
                  280 - 240 * (energies[i] / energies.front() - low) / (1 - low));
    path += point;
  }
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 330\" "
         "font-family=\"sans-serif\" font-size=\"14\">"
         "<rect width=\"600\" height=\"330\" fill=\"white\"/>"
         "<path d=\"M50 30V285H570\" fill=\"none\" stroke=\"#444\"/>"
         "<text x=\"60\" y=\"40\">energy</text><text x=\"500\" y=\"310\">iteration</text>"
         "<path d=\"" +
         path + "\" fill=\"none\" stroke=\"#1f6feb\" stroke-width=\"2\"/></svg>\n";
}

std::vector<lpq::Vec2> to_frame(const Scene& scene, std::vector<lpq::Vec2> points) {
  for (lpq::Vec2& p : points) p = scene.domain.frame.to_frame(p);
  return points;
}

void figure_12() {
  std::printf(
      "| Fig. 12: 11 x 11 square, 100 iterations of L6 | tau before | tau after | paper "
      "|\n|---|---|---|---|\n");
  const auto scene = make_scene(lpq_test::square(1, 0.1));
  for (const Start& start : starts) {
    const auto seeds = to_frame(*scene, lpq_test::jittered_grid(11, start.jitter, start.seed));
    const Optimised result = optimise(*scene, seeds, 6, 100);
    std::printf("| mesh %s (grid moved by up to %.2f cells) | %.3f | %.4f | %.3f |\n", start.name,
                start.jitter, result.tau_before, result.tau_after, start.paper_tau);
    save(std::string("fig12_") + start.name + "_before.svg", lpq::draw_triangles(result.before));
    save(std::string("fig12_") + start.name + "_after.svg", lpq::draw_triangles(result.after));
  }
}

void figures_19_22_23() {
  const auto scene = make_scene(lpq_test::hood(0.025));
  const auto seeds = lpq::isotropic_seeds(scene->boundary, scene->fields);
  std::printf("\n| Fig. 23: hood, 80 iterations | tau | paper |\n|---|---|---|\n");
  const double paper_tau[3] = {0.910, 0.967, 0.982};
  for (int i = 0; i < 3; ++i) {
    const double p = 2 + 2 * i;
    const Optimised result = optimise(*scene, seeds, p, 80, {0, 10, 80});
    std::printf("| p = %.0f | %.3f | %.3f |\n", p, result.tau_after, paper_tau[i]);
    save("fig23_p" + std::to_string(2 + 2 * i) + ".svg", lpq::draw_triangles(result.after));
    if (p != 6) continue;
    std::printf("\n| Fig. 19: energy over its start, hood, L6 | |\n|---|---|\n");
    for (const std::size_t k : {10, 20, 40, 80})
      if (k < result.energies.size())
        std::printf("| iteration %zu | %.4f |\n", k, result.energies[k] / result.energies[0]);
    save("fig19_curve.svg", curve_picture(result.energies));
    for (std::size_t k = 0; k < result.frames.size(); ++k)
      save("fig19_cells_" + std::to_string(k) + ".svg", cells_picture(*scene, result.frames[k], 6));
    save("fig22_energy_density.svg", cells_picture(*scene, result.after, 6));
  }
}

void figure_24() {
  std::printf(
      "\n| Fig. 24: effect of L6 (80 iterations) before Blossom | eta | 4-valent | eta with L6 | "
      "4-valent with L6 |\n"
      "|---|---|---|---|---|\n| the paper, car body part | 0.80 | 71 %% | 0.90 | 89 %% |\n");
  const struct {
    const char* name;
    lpq::DomainInput input;
  } parts[] = {{"hood", lpq_test::hood(0.025)},
               {"plate with a hole", lpq_test::plate_with_hole(0.025)},
               {"disc", lpq_test::disc(0.025)}};
  for (const auto& part : parts) {
    const auto scene = make_scene(part.input);
    const auto seeds = lpq::isotropic_seeds(scene->boundary, scene->fields);
    const Optimised result = optimise(*scene, seeds, 6, 80);
    const lpq::QuadMesh without = to_quads(*scene, result.before),
                        with = to_quads(*scene, result.after);
    const lpq::QuadQuality q0 = lpq::quad_quality(without), q1 = lpq::quad_quality(with);
    std::printf("| %s, %d quads | %.3f | %.1f %% | %.3f | %.1f %% |\n", part.name, q1.quads,
                q0.eta_mean, q0.four_valent_percent, q1.eta_mean, q1.four_valent_percent);
    const std::string stem = std::string("fig24_") + part.name[0];
    save(stem + "_a_blossom_only.svg", lpq::draw_quads(without));
    save(stem + "_b_with_lp.svg", lpq::draw_quads(with));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: lpquad_paper OUT_DIR\n");
    return 2;
  }
  out_dir = argv[1];
  std::filesystem::create_directories(out_dir);
  figure_12();
  figures_19_22_23();
  figure_24();
}
