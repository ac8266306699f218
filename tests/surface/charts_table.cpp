// What the maps of surfaces are like: charts, methods, splits, scales and speed, a line per file.
//   lpquad_charts SURFACE.obj ...
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>

#include "support/shared_surfaces.h"
#include "surface/charts/charts.h"
#include "surface/components.h"

using namespace lpq;
using namespace lpq_test;

namespace {

struct Row {
  double triangles = 0, seconds = 0, faces = 0, charts = 0, small = 0;
  double methods[5] = {};
  double range = 1, q95 = 1;
  ChartCounts counts;
};

void add(Row& sum, const Row& row) {
  sum.triangles += row.triangles, sum.seconds += row.seconds, sum.faces += row.faces;
  sum.charts += row.charts, sum.small += row.small;
  for (int i = 0; i < 5; ++i) sum.methods[i] += row.methods[i];
  sum.range = std::max(sum.range, row.range), sum.q95 = std::max(sum.q95, row.q95);
  sum.counts.maps += row.counts.maps, sum.counts.opened += row.counts.opened;
  sum.counts.topology += row.counts.topology, sum.counts.flips += row.counts.flips;
  sum.counts.crossings += row.counts.crossings, sum.counts.distortions += row.counts.distortions;
  sum.counts.merged += row.counts.merged, sum.counts.rejected += row.counts.rejected;
}

Row measure(const SurfaceMesh& mesh) {
  const std::vector<char> feature = sharp_edges(mesh);
  const std::clock_t start = std::clock();
  const Atlas atlas = make_charts(mesh, feature);
  Row row;
  row.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  row.triangles = mesh.triangle_count();
  row.faces = components_of(mesh.twins, feature).count;
  row.counts = atlas.counts;
  for (const Chart& chart : atlas.charts) {
    ++row.charts;
    ++row.methods[static_cast<int>(chart.method)];
    row.small += chart.triangles.size() <= 3;
    row.range = std::max(row.range, chart.check.scale_range);
    row.q95 = std::max(row.q95, chart.check.anisotropy);
  }
  return row;
}

void print(const char* name, const Row& row) {
  const ChartCounts& c = row.counts;
  std::printf(
      "| %s | %.0f | %.0f | %.0f (%.0f) | %.0f/%.0f/%.0f/%.0f/%.0f | %d/%d/%d/%d | %d | %d | %d | "
      "%.2f | %.2f | %.2f |\n",
      name, row.triangles, row.faces, row.charts, row.small, row.methods[0], row.methods[1],
      row.methods[2], row.methods[3], row.methods[4], c.topology, c.flips, c.crossings,
      c.distortions, c.opened, c.merged, c.maps, row.q95, row.range,
      1e5 * row.seconds / row.triangles);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: lpquad_charts SURFACE.obj ...\n");
    return 2;
  }
  std::printf(
      "| surface | triangles | faces | charts (of up to 3 triangles) | BFF/LSCM/SCP/SD/none | "
      "split "
      "for topology/flips/crossing/distortion | opened | merged | maps solved | "
      "largest Q95 | largest scale range | s per 100k |\n|---|---|---|---|---|---|---|---|---|---|"
      "---|---|\n");
  Row sum;
  for (int i = 1; i < argc; ++i) {
    const std::filesystem::path path = argv[i];
    const Row row = measure(read_obj(path));
    print(path.stem().c_str(), row);
    add(sum, row);
  }
  print("**all**", sum);
}
