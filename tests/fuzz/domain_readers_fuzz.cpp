// Domain files from bytes: the readers refuse, or give finite coordinates and tags that fit; the
// door then judges what they give. Byte 0 chooses the format.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "io/domain/domain_format.h"

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "domain readers: %s\n", what);
  std::abort();
}

void check(const lpq::DomainInput& input) {
  for (const auto& region : input.regions) {
    require(region.tags.size() <= region.loops.size(), "tags without loops");
    for (std::size_t l = 0; l < region.loops.size(); ++l) {
      if (l < region.tags.size())
        require(region.tags[l].size() <= region.loops[l].size(), "more tags than edges");
      for (const lpq::Vec2 p : region.loops[l]) require(lpq::is_finite(p), "not finite");
    }
  }
  for (const auto& line : input.polylines)
    for (const lpq::Vec2 p : line.points) require(lpq::is_finite(p), "not finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t enough = 1 << 16;
  if (size < 1 || size > enough) return 0;
  constexpr lpq::DomainFormat formats[] = {lpq::DomainFormat::json, lpq::DomainFormat::geojson,
                                           lpq::DomainFormat::svg,  lpq::DomainFormat::poly,
                                           lpq::DomainFormat::msh,  lpq::DomainFormat::dxf};
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  (void)lpq::domain_format_by_content(text);
  const auto file = lpq::read_domain(text, formats[data[0] % 6]);
  if (!file) {
    require(!file.error().message.empty(), "an error without a sentence");
    return 0;
  }
  check(file->domain);
  (void)lpq::make_domain(file->domain);
  return 0;
}
