// lpquad_bench [pipeline | energy | matching | surface] [options]: JSON on standard output. No
// benchmark is a test: compare ratios of runs on a quiet machine.
#include <cstdio>
#include <cstring>

#include "bench.h"

int main(int argc, char** argv) {
  const char* name = argc > 1 ? argv[1] : "";
  if (std::strcmp(name, "pipeline") == 0) return lpq_bench::pipeline(argc - 2, argv + 2);
  if (std::strcmp(name, "energy") == 0) return lpq_bench::energy(argc - 2, argv + 2);
  if (std::strcmp(name, "matching") == 0) return lpq_bench::matching(argc - 2, argv + 2);
  if (std::strcmp(name, "surface") == 0) return lpq_bench::surface(argc - 2, argv + 2);
  std::fprintf(stderr,
               "usage: lpquad_bench pipeline [--max VERTICES] [--method best|paper]\n"
               "       lpquad_bench energy\n"
               "       lpquad_bench matching [--no-lemon] [--repeat N] [INSTANCE...]\n"
               "       lpquad_bench surface [--quads N] [--obj FILE]\n");
  return 2;
}
