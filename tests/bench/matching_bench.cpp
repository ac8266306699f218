// lpquad_bench matching [--no-lemon] [--repeat N] [INSTANCE...]
// An instance is a text file "n m" followed by m lines "u v cost" (nodes from 0, integer costs);
// without any, duals of jittered grids with 20k and 200k triangles are made. Prints one JSON line
// each: median user CPU seconds of the solver (matching and duals), of the certificate check and of
// LEMON (runs interleaved), and whether the costs agree.
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bench.h"
#include "matching/blossom.h"
#include "matching/certificate.h"
#include "support/matching_graphs.h"
#include "support/matching_lemon.h"

namespace {

using namespace lpq;

using Instance = test::MatchingInstance;

bool read_instance(const char* path, Instance& instance) {
  std::FILE* file = std::fopen(path, "r");
  if (file == nullptr) return false;
  int edge_count = 0;
  bool good = std::fscanf(file, "%d %d", &instance.node_count, &edge_count) == 2 && edge_count >= 0;
  for (int i = 0; good && i < edge_count; ++i) {
    CostEdge e;
    long long cost = 0;
    good = std::fscanf(file, "%d %d %lld", &e.u, &e.v, &cost) == 3;
    e.cost = cost;
    instance.edges.push_back(e);
  }
  std::fclose(file);
  return good;
}

double user_seconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

double peak_megabytes() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

template <class F>
double timed(F f) {
  const double start = user_seconds();
  f();
  return user_seconds() - start;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? -1 : values[values.size() / 2];
}

bool bench(const char* path, const Instance& instance, int repeat, bool with_lemon) {
  std::vector<double> own, check, lemon;
  Matching matching;
  std::string fault;
  test::LemonAnswer answer{};
  std::vector<int> ends;
  std::vector<std::int64_t> costs;
  for (const CostEdge& e : instance.edges) {
    ends.insert(ends.end(), {e.u, e.v});
    costs.push_back(e.cost);
  }
  const double before = peak_megabytes();
  double after = 0;
  for (int i = 0; i < repeat; ++i) {
    matching = {};
    own.push_back(
        timed([&] { matching = min_cost_perfect_matching(instance.node_count, instance.edges); }));
    if (i == 0) after = peak_megabytes();
    check.push_back(
        timed([&] { fault = check_certificate(instance.node_count, instance.edges, matching); }));
    if (!with_lemon) continue;
    const double time = timed([&] {
      answer = test::lemon_matching(instance.node_count, static_cast<int>(costs.size()),
                                    ends.data(), costs.data());
    });
    if (answer.available) lemon.push_back(time);
  }
  const bool perfect = matching.status == MatchingStatus::perfect;
  const bool agree = !answer.available ||
                     (answer.perfect == perfect && (!perfect || answer.cost == matching.cost));
  const char* name = std::strrchr(path, '/');
  std::printf(
      "{\"instance\":\"%s\",\"nodes\":%d,\"edges\":%zu,\"perfect\":%s,\"cost\":%lld,"
      "\"blossoms\":%zu,\"own\":%.4f,\"check\":%.4f,",
      name ? name + 1 : path, instance.node_count, instance.edges.size(),
      perfect ? "true" : "false", static_cast<long long>(matching.cost), matching.duals.z.size(),
      median(own), median(check));
  if (!lemon.empty()) {
    std::printf("\"lemon\":%.4f,\"ratio\":%.2f,", median(lemon), median(lemon) / median(own));
  }
  std::printf("\"agree\":%s,\"certified\":%s,\"own_mb\":%.0f}\n", agree ? "true" : "false",
              fault.empty() ? "true" : "false", after - before);
  if (!fault.empty()) std::fprintf(stderr, "%s: %s\n", path, fault.c_str());
  std::fflush(stdout);
  return agree && fault.empty();
}

}  // namespace

int lpq_bench::matching(int argc, char** argv) {
  int repeat = 3, files = 0;
  bool with_lemon = true, good = true;
  for (int i = 0; i < argc; ++i) {
    if (std::strcmp(argv[i], "--no-lemon") == 0) {
      with_lemon = false;
    } else if (std::strcmp(argv[i], "--repeat") == 0 && i + 1 < argc) {
      repeat = std::max(1, std::atoi(argv[++i]));
    } else {
      Instance instance;
      const bool readable = read_instance(argv[i], instance);
      if (!readable) std::fprintf(stderr, "cannot read %s\n", argv[i]);
      good = readable && bench(argv[i], instance, repeat, with_lemon) && good;
      ++files;
    }
  }
  if (files > 0) return good ? 0 : 1;
  for (const Index side : {100, 316})
    good = bench("jittered grid", test::dual_of_grid(1, side, test::DualCosts::shape), repeat,
                 with_lemon) &&
           good;
  return good ? 0 : 1;
}
