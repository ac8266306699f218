// Small graphs from bytes: every answer must carry its certificate and, up to ten nodes, be what
// enumeration finds. Byte 0: nodes; byte 1: scale of the costs; then three bytes per edge.
#include <cstdio>
#include <cstdlib>

#include "matching/blossom.h"
#include "matching/certificate.h"
#include "support/matching_graphs.h"

namespace {

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "matching: %s\n", what);
  std::abort();
}

lpq::test::MatchingInstance decode(const std::uint8_t* data, std::size_t size) {
  const lpq::Index nodes = data[0] % 25;
  const int shift = data[1] % 33;
  lpq::test::MatchingInstance instance{nodes, {}};
  for (std::size_t i = 2; nodes > 1 && i + 2 < size; i += 3) {
    const lpq::Index u = data[i] % nodes;
    const lpq::Index v = (u + 1 + data[i + 1] % (nodes - 1)) % nodes;
    const auto cost = (std::int64_t{data[i + 2]} - 128) * (std::int64_t{1} << shift);
    instance.edges.push_back({u, v, cost});
  }
  return instance;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const lpq::test::MatchingInstance instance = decode(data, size);
  const lpq::Matching matching =
      lpq::min_cost_perfect_matching(instance.node_count, instance.edges);
  const std::string fault = lpq::check_certificate(instance.node_count, instance.edges, matching);
  if (!fault.empty()) fail(fault.c_str());
  if (instance.node_count > 10) return 0;
  const lpq::test::EnumeratedMatching truth = lpq::test::enumerate_matchings(instance);
  if (matching.deficiency != truth.deficiency) fail("wrong deficiency");
  if (truth.deficiency == 0 && matching.cost != truth.cost) fail("not the least cost");
  return 0;
}
