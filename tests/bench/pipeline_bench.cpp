// lpquad_bench pipeline [--max VERTICES] [--method best|paper]
// The whole run and each of its stages on a plate with a hole at 1k, 10k, 100k and 1M vertices: CPU
// seconds, peak memory, and the growth exponents between the sizes. One JSON object per line.
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <string>

#include "bench.h"
#include "pipeline/mesh_domain.h"
#include "support/shapes.h"

namespace {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

struct Row {
  double vertices = 0;
  std::map<std::string, double> seconds;  // by stage, and "whole"
};

Row measure(double vertices, lpq::Options options) {
  const double area = 2 - std::acos(-1.0) * 0.04;
  const lpq::DomainInput input = lpq_test::plate_with_hole(std::sqrt(area / vertices));
  const double start = cpu_seconds();
  const auto outcome = lpq::mesh_domain(input, options);
  Row row;
  row.seconds["whole"] = cpu_seconds() - start;
  if (!outcome) {
    std::printf("{\"vertices\":%.0f,\"error\":\"%s\"}\n", vertices,
                outcome.error().message.c_str());
    return row;
  }
  row.vertices = static_cast<double>(outcome->mesh.points.size());
  for (const lpq::StageTime& time : outcome->report.times)
    row.seconds[time.stage] = time.cpu_seconds;
  const lpq::QuadQuality& quality = outcome->report.quality;
  std::printf("{\"vertices\":%.0f,\"quads\":%d,\"eta\":%.4f,\"four_valent\":%.2f,\"peak_mb\":%.0f",
              row.vertices, quality.quads, quality.eta_mean, quality.four_valent_percent,
              peak_megabytes());
  for (const auto& [stage, seconds] : row.seconds)
    std::printf(",\"%s\":%.4f", stage.c_str(), seconds);
  std::printf("}\n");
  std::fflush(stdout);
  return row;
}

void print_growth(const Row& small, const Row& large) {
  std::printf("{\"growth_from\":%.0f,\"to\":%.0f", small.vertices, large.vertices);
  for (const auto& [stage, seconds] : large.seconds) {
    const auto before = small.seconds.find(stage);
    if (before == small.seconds.end() || before->second <= 0 || seconds <= 0) continue;
    std::printf(",\"%s\":%.3f", stage.c_str(),
                std::log(seconds / before->second) / std::log(large.vertices / small.vertices));
  }
  std::printf("}\n");
}

}  // namespace

int lpq_bench::pipeline(int argc, char** argv) {
  double largest = 1e6;
  lpq::Options options;
  options.keep_boundary = true;
  for (int i = 0; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--max") == 0) largest = std::atof(argv[i + 1]);
    if (std::strcmp(argv[i], "--method") == 0 && std::strcmp(argv[i + 1], "paper") == 0)
      options.method = lpq::Method::paper;
  }
  Row previous;
  for (double vertices = 1e3; vertices <= largest; vertices *= 10) {
    const Row row = measure(vertices, options);
    if (previous.vertices > 0 && row.vertices > 0) print_growth(previous, row);
    previous = row;
  }
  return 0;
}
