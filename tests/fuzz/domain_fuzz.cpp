// Any bytes: read as a domain, judge it, sample its boundary in both modes.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "domain/boundary.h"
#include "io/domain/json_domain.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t enough = 1 << 16;
  if (size > enough) return 0;
  const auto file = lpq::read_json_domain({reinterpret_cast<const char*>(data), size});
  if (!file) return 0;
  const auto domain = lpq::make_domain(file->domain);
  if (!domain) return 0;
  (void)lpq::sample_boundary(*domain, {.allow_added_point = true});
  (void)lpq::sample_boundary(*domain, {.keep = false, .size = 0.1, .max_nodes = 20000});
  (void)lpq::sample_boundary(
      *domain, {.keep = false, .size = 0.3, .simplify_tolerance = 0.05, .max_nodes = 20000});
  return 0;
}
