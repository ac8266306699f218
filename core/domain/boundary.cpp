// Kept mode needs no geometry, only the parity of the counts: a region meshed with Q quads has
// 4 Q = 2 E_interior + B, so B must be even.
#include "domain/boundary.h"

#include "domain/division.h"
#include "domain/outline.h"
#include "domain/refine.h"

namespace lpq {
namespace {

Error odd_region(const Domain& domain, Index region, Index count) {
  std::string name = domain.regions.size() > 1 || !domain.regions[region].empty()
                         ? "Region " + std::to_string(region)
                         : std::string("The domain");
  if (!domain.regions[region].empty()) name += " (" + domain.regions[region] + ")";
  Where where;
  where.region = region;
  return {ErrorCode::odd_boundary,
          name + " has " + std::to_string(count) +
              " boundary edges, an odd number, but a mesh of quads alone needs an even one. Add or "
              "remove one boundary point, or allow one to be added (allowAddedPoint), or allow one "
              "triangle (elements: one-triangle).",
          where};
}

Result<BoundaryMesh> keep_given(const Domain& domain, const BoundaryOptions& options) {
  const Index region_count = static_cast<Index>(domain.regions.size());
  const std::vector<Index> pieces(domain.segments.size(), 1);
  std::vector<char> divide(domain.segments.size(), 0);
  Index added = 0;
  if (options.require_even) {
    const std::vector<Index> counts = boundary_counts(domain.segments, region_count, pieces);
    for (Index r = 0; r < region_count; ++r)
      if (counts[r] % 2 != 0 && !options.allow_added_point) return odd_region(domain, r, counts[r]);
    std::vector<double> lengths;
    for (const Segment& s : domain.segments)
      lengths.push_back(distance(domain.points[s.a], domain.points[s.b]));
    for (const Index s : segments_to_even(domain.segments, region_count, pieces, lengths)) {
      divide[s] = 1;
      ++added;
    }
  }
  Division division;
  for (std::size_t s = 0; s < domain.segments.size(); ++s) {
    const Segment& segment = domain.segments[s];
    if (divide[s])
      division.values.push_back(
          domain.frame.snap(midpoint(domain.points[segment.a], domain.points[segment.b])));
    division.end_row();
  }
  const std::vector<char> used(domain.points.size(), 1);
  BoundaryMesh mesh = assemble(domain, domain.segments, used, division);
  mesh.added_points = added;
  return mesh;
}

}  // namespace

Result<BoundaryMesh> sample_boundary(const Domain& domain, const BoundaryOptions& options) {
  return options.keep ? keep_given(domain, options) : refine_boundary(domain, options);
}

}  // namespace lpq
