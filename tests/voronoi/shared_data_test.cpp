// The clipped diagram tiles every valid benchmark domain, bare and with points scattered inside.
#include "support/domain_data.h"
#include "support/voronoi_checks.h"

namespace lpq {
namespace {

using namespace lpq_test;

void check_tiles(const BoundaryMesh& boundary, const std::vector<Vec2>& interior) {
  const TriMesh mesh = triangulated(boundary, interior);
  ClippedVoronoi voronoi;
  clip_voronoi(mesh, voronoi);
  ClippedDual dual;
  clip_dual(mesh, dual);
  const double area = mesh_area(mesh);
  const AreaReport report = fan_areas(mesh, voronoi);
  CAPTURE(interior.size(), report.least / area, dual.clamped_crossings, dual.replaced_centres);
  CHECK(std::abs(report.sum - area) <= 1e-12 * area);
  CHECK(report.negative >= -1e-12 * area);
  CHECK(dual.clamped_crossings == 0);
  CHECK(dual.replaced_centres == 0);
  CHECK(equidistance_error(mesh, voronoi) < 1e-13);
}

}  // namespace

TEST_CASE("the clipped cells tile every benchmark polygon") {
  for (const auto& path : shared_domains("polygons")) {
    CAPTURE(path.filename().string());
    const auto domain = make_domain(read_domain(path));
    if (!domain) {
      WARN("SKIPPED: " << path.filename() << " because " << domain.error().message);
      continue;
    }
    const BoundaryMesh boundary = raw_boundary(*domain);
    check_tiles(boundary, {});
    for (const int count : {10, 300})
      for (const int hug : {1, 6}) check_tiles(boundary, scattered(boundary, count, 5, hug));
  }
}

}  // namespace lpq
