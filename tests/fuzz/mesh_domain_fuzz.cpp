// Domains from bytes, through the whole chain: it answers with an error or with a mesh that passed
// the final check. Byte 0: options; byte 1: points per loop, and whether the size is given by a
// number of quads; then two bytes per point.
#include <cstdio>
#include <cstdlib>

#include "pipeline/finish.h"
#include "pipeline/mesh_domain.h"

namespace {

lpq::DomainInput decode(const std::uint8_t* data, std::size_t size) {
  lpq::DomainInput input;
  input.regions.emplace_back();
  const std::size_t per_loop = 3 + data[1] % 14;
  lpq::Loop loop;
  for (std::size_t i = 2; i + 1 < size && input.regions[0].loops.size() < 4; i += 2) {
    loop.push_back({static_cast<double>(data[i]), static_cast<double>(data[i + 1])});
    if (loop.size() < per_loop) continue;
    input.regions[0].loops.push_back(loop);
    loop.clear();
  }
  if (loop.size() >= 3) input.regions[0].loops.push_back(loop);
  return input;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 8) return 0;
  lpq::Options options;
  options.size = 20 + data[0] % 32;  // of 255: a hundred quads or so, many runs a second
  if ((data[1] & 128) != 0) {
    options.quads = 1 + 4 * (data[0] % 32);
    options.size = 0;
  }
  options.keep_boundary = (data[0] & 32) != 0;
  options.method = (data[0] & 64) != 0 ? lpq::Method::paper : lpq::Method::best;
  options.elements = (data[0] & 128) != 0 ? lpq::Elements::quad_dominant : lpq::Elements::quad;
  options.iterations = options.method == lpq::Method::paper ? 3 : -1;
  options.smoothing = 5;
  options.max_elements = 20'000;
  const auto outcome = lpq::mesh_domain(decode(data, size), options);
  if (!outcome) return 0;
  if (lpq::check_output(outcome->mesh).empty()) return 0;
  std::fprintf(stderr, "mesh domain: an invalid mesh was returned\n");
  std::abort();
}
