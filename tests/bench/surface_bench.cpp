// lpquad_bench surface [--quads N] [--obj FILE]
// A machined part of more than 350 faces at 44k quads, as many as the paper's mechanical part has
// (Fig. 25: 250 faces, 44,489 quads, mean eta 0.84, 962 triangles left), and a coarser one. One
// JSON object per line. `--obj` writes the part's triangles, for other programs.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "bench.h"
#include "io/surface/surface_write.h"
#include "shell/mesh_surface.h"
#include "support/machined_part.h"

namespace {

double area_of(const lpq::SurfaceSoup& soup) {
  double area = 0;
  for (const auto& [a, b, c] : soup.triangles)
    area += 0.5 * lpq::length(
                      lpq::cross(soup.points[b] - soup.points[a], soup.points[c] - soup.points[a]));
  return area;
}

void measure(const lpq::SurfaceSoup& soup, double quads) {
  lpq::SurfaceOptions options;
  options.size = std::sqrt(area_of(soup) / quads);
  const auto outcome = lpq::mesh_surface(soup, options);
  if (!outcome) {
    std::printf("{\"asked\":%.0f,\"error\":\"%s\"}\n", quads, outcome.error().message.c_str());
    return;
  }
  const lpq::ShellReport& report = outcome->report;
  const lpq::QuadQuality& quality = report.quality;
  std::printf("{\"input_triangles\":%d,\"faces\":%d,\"size\":%.5f,\"quads\":%d,\"triangles\":%d",
              outcome->surface.triangle_count(), report.faces, options.size, quality.quads,
              quality.triangles);
  std::printf(",\"eta\":%.4f,\"eta_min\":%.4f,\"nonconvex\":%d,\"four_valent\":%.2f",
              quality.eta_mean, quality.eta_min, quality.nonconvex, quality.four_valent_percent);
  double whole = 0;
  for (const lpq::StageTime& time : report.times) {
    whole += time.cpu_seconds;
    std::printf(",\"%s\":%.3f", time.stage.c_str(), time.cpu_seconds);
  }
  std::printf(",\"whole\":%.3f}\n", whole);
  std::fflush(stdout);
}

}  // namespace

int lpq_bench::surface(int argc, char** argv) {
  double quads = 0;
  const lpq::SurfaceSoup soup = lpq_test::MachinedPart::make(6, 4, 16);
  for (int i = 0; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--quads") == 0) quads = std::atof(argv[i + 1]);
    if (std::strcmp(argv[i], "--obj") != 0) continue;
    lpq::SurfaceMesh triangles;
    triangles.points = soup.points;
    triangles.triangles = soup.triangles;
    triangles.group = soup.group;
    std::ofstream(argv[i + 1]) << lpq::write_surface_obj(triangles, soup.group_names);
  }
  if (quads > 0) {
    measure(soup, quads);
    return 0;
  }
  for (const double count : {11000.0, 44000.0}) measure(soup, count);
  return 0;
}
