// Surface files from bytes: the readers refuse, or give a soup whose indices and coordinates are
// good; repair then makes a surface of it, and features and curves are found on that. Byte 0
// chooses the format.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "io/surface/surface_format.h"
#include "surface/curves.h"
#include "surface/repair.h"

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "surface readers: %s\n", what);
  std::abort();
}

void check(const lpq::SurfaceSoup& soup) {
  require(!soup.triangles.empty(), "no triangle");
  require(soup.group.size() == soup.triangles.size(), "a group for every triangle");
  for (const lpq::Vec3 p : soup.points) require(lpq::is_finite(p), "not finite");
  for (const lpq::Tri& t : soup.triangles)
    for (const lpq::Index v : t)
      require(v >= 0 && v < static_cast<lpq::Index>(soup.points.size()), "no such point");
  for (const lpq::Index g : soup.group)
    require(g >= 0 && g < static_cast<lpq::Index>(soup.group_names.size()), "no such group");
}

void check(const lpq::SurfaceMesh& mesh) {
  require(mesh.twins.size() == 3 * mesh.triangles.size(), "a twin for every half-edge");
  for (lpq::Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    const lpq::Index twin = mesh.twins[e];
    require(mesh.origin(e) != mesh.target(e), "repeated corner");
    if (twin == lpq::none) continue;
    require(mesh.twins[twin] == e, "twins disagree");
    require(mesh.origin(twin) == mesh.target(e) && mesh.target(twin) == mesh.origin(e),
            "twins run the same way");
  }
}

void mesh_curves_of(const lpq::SurfaceMesh& mesh) {
  double longest = 0;
  for (lpq::Index e = 0; e < 3 * mesh.triangle_count(); ++e)
    longest =
        std::max(longest, lpq::distance(mesh.points[mesh.origin(e)], mesh.points[mesh.target(e)]));
  const std::vector<double> size(mesh.points.size(), 0.3 * longest);
  const auto features = lpq::find_features(mesh, size);
  const auto curves = lpq::trace_curves(mesh, features);
  const auto nodes = lpq::mesh_curves(mesh, features, curves, size);
  require(nodes.has_value(), "curves without a mesh");
  for (const lpq::Vec3 p : nodes->points) require(lpq::is_finite(p), "node not finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t enough = 1 << 14;
  if (size < 1 || size > enough) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  (void)lpq::surface_format_by_content(bytes);
  const auto format = lpq::surface_formats[data[0] % lpq::surface_formats.size()].format;
  const auto soup = lpq::read_surface(bytes, format);
  if (!soup) {
    require(!soup.error().message.empty(), "an error without a sentence");
    return 0;
  }
  check(*soup);
  const auto surface = lpq::repair_surface(*soup);
  if (!surface) {
    require(!surface.error().message.empty(), "an error without a sentence");
    return 0;
  }
  check(surface->mesh);
  mesh_curves_of(surface->mesh);
  return 0;
}
