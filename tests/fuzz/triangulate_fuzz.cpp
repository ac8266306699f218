// Any bytes are a small set of integer points and segments: full of duplicates, ties, collinear and
// crossing input. The triangulation must be certified or refused with a reason.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "delaunay/locate.h"
#include "mesh/validate.h"
#include "support/delaunay_checks.h"

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "triangulate_fuzz: %s\n", what);
  std::abort();
}

void check(const lpq::Result<lpq::TriMesh>& mesh, bool plain) {
  if (!mesh.has_value()) {
    require(!mesh.error().message.empty(), "an error without a message");
    return;
  }
  require(lpq::validate(*mesh).empty(), "the mesh is not valid");
  require(lpq_test::occupied_edges(*mesh) == 0, "an edge is not Delaunay");
  if (plain) require(lpq_test::occupied_circles(*mesh) == 0, "a circle is not empty");
  lpq::Index hint = lpq::none;
  const lpq::Locator locator(*mesh);
  for (std::size_t v = 0; v < mesh->points.size(); ++v) {
    const lpq::Vec2 p = mesh->points[v];
    const lpq::Index t = locator.find(p, hint);
    require(t != lpq::none && lpq::contains(*mesh, t, p), "a vertex is not located");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 8 || size > 400) return 0;
  const std::size_t interior_count = data[0] % 32;
  const std::size_t segment_count = data[1] % 32;
  const int coarseness = 1 << (data[2] % 8);
  std::vector<lpq::Vec2> points;
  std::size_t at = 3 + 2 * segment_count;
  for (; at + 1 < size; at += 2) {
    points.push_back({double(data[at] / coarseness), double(data[at + 1] / coarseness)});
  }
  check(lpq::triangulate(points), true);

  // The same points in a box, the first ones interior, segments between the others.
  const std::vector<lpq::Vec2> inside(points.begin(),
                                      points.begin() + std::min(interior_count, points.size()));
  lpq::BoundaryMesh boundary = lpq_test::boundary_of({lpq_test::rectangle({-8, -8}, {264, 264})});
  boundary.points.insert(boundary.points.end(), points.begin() + inside.size(), points.end());
  const std::size_t nodes = boundary.points.size();
  for (std::size_t k = 0; k < segment_count && 4 + 2 * k < size; ++k) {
    lpq_test::add_segment(boundary, static_cast<lpq::Index>(data[3 + 2 * k] % nodes),
                          static_cast<lpq::Index>(data[4 + 2 * k] % nodes), 0, 0);
  }
  check(lpq::triangulate(boundary, inside), false);
  return 0;
}
