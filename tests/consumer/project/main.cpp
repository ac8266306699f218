// Meshes the unit square with nothing but what was installed.
#include <lpquad.h>

#include <cstdio>

#include "io/mesh/obj.h"

int main() {
  lpq::DomainInput square;
  square.regions.push_back({"", {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {}});
  lpq::Options options;
  options.size = 0.1;
  const auto outcome = lpq::mesh_domain(square, options);
  if (!outcome) {
    std::fprintf(stderr, "%s\n", outcome.error().message.c_str());
    return 1;
  }
  const lpq::QuadQuality& quality = outcome->report.quality;
  std::printf("%d quads, %d triangles\n", quality.quads, quality.triangles);
  return lpq::write_obj(outcome->mesh).empty() ? 1 : 0;
}
