// Kept mode needs only the parity of the counts: a part of the domain meshed with Q quads has
// 4 Q = 2 E_interior + B, so B must be even.
#include "domain/boundary.h"

#include <algorithm>

#include "domain/division.h"
#include "domain/outline.h"
#include "domain/parts.h"
#include "domain/refine.h"

namespace lpq {
namespace {

/// About the odd part beside a segment that could be divided to help.
Error odd_part(const Domain& domain, const Parts& parts, std::span<const Index> counts,
               Index segment) {
  const Segment& s = parts.segments[segment];
  const Index part = s.left != none && counts[s.left] % 2 != 0 ? s.left : s.right;
  Where where;
  where.region = parts.region[part];
  const std::string& label = domain.regions[where.region];
  std::string name = "the domain";
  if (domain.regions.size() > 1 || !label.empty())
    name = "region " + std::to_string(where.region) + (label.empty() ? "" : " (" + label + ")");
  if (std::count(parts.region.begin(), parts.region.end(), where.region) > 1) {
    where = at_point(where, midpoint(domain.points[s.a], domain.points[s.b]));
    name = "A part of " + name + ", cut off by polylines,";
  } else {
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
  }
  return {ErrorCode::odd_boundary,
          name + " has " + std::to_string(counts[part]) +
              " boundary edges, an odd number, but a mesh of quads alone needs an even one. Add or "
              "remove one boundary point, or allow one to be added (allowAddedPoint), or allow one "
              "triangle (elements: one-triangle).",
          where};
}

/// As the caller's coordinates can hold it.
Vec2 middle_of(const Domain& domain, const Segment& s) {
  return domain.frame.snap(midpoint(domain.points[s.a], domain.points[s.b]));
}

/// In the middle of a segment; the only thing about a kept boundary that is not as given.
Warning added_point(const Domain& domain, const Segment& s) {
  Where where;
  if (s.region != none) {
    where.region = s.region;
    where.loop = s.loop;
    where.edge = s.edge;
  }
  const Vec2 p = domain.frame.to_world(middle_of(domain, s));
  return {ErrorCode::odd_boundary,
          "The number of boundary edges was odd: a point was added at " + point_text(p) +
              ", in the middle of one, as allowed.",
          at_point(where, p)};
}

/// The middles of the chosen segments.
Division halve(const Domain& domain, const std::vector<Index>& chosen) {
  std::vector<char> is_chosen(domain.segments.size(), 0);
  for (const Index i : chosen) is_chosen[i] = 1;
  Division division;
  for (std::size_t i = 0; i < domain.segments.size(); ++i) {
    if (is_chosen[i]) division.values.push_back(middle_of(domain, domain.segments[i]));
    division.end_row();
  }
  return division;
}

Result<BoundaryMesh> keep_given(const Domain& domain, const BoundaryOptions& options) {
  const std::vector<Index> pieces(domain.segments.size(), 1);
  std::vector<Index> cure;
  if (options.require_even) {
    const Parts parts = find_parts(domain.points, domain.segments);
    std::vector<double> lengths;
    for (const Segment& s : domain.segments)
      lengths.push_back(distance(domain.points[s.a], domain.points[s.b]));
    cure = segments_to_even(parts.segments, parts.count(), pieces, lengths);
    if (!cure.empty() && !options.allow_added_point)
      return odd_part(domain, parts, boundary_counts(parts.segments, parts.count(), pieces),
                      cure[0]);
  }
  const std::vector<char> used(domain.points.size(), 1);
  BoundaryMesh mesh = assemble(domain, domain.segments, used, halve(domain, cure));
  for (const Index i : cure) mesh.warnings.push_back(added_point(domain, domain.segments[i]));
  return mesh;
}

}  // namespace

Result<BoundaryMesh> sample_boundary(const Domain& domain, const BoundaryOptions& options) {
  return options.keep ? keep_given(domain, options) : refine_boundary(domain, options);
}

}  // namespace lpq
