#include "recombine/pair_cost.h"

#include <cmath>

#include "mesh/quality.h"
#include "recombine/costs.h"

namespace lpq {

double misalignment(const Vec2 (&quad)[4], Vec2 z) {
  double sum = 0;
  for (Index k = 0; k < 4; ++k) {
    const Vec2 side = quad[next_in_quad(k)] - quad[k];
    // cos 4 (angle - theta) is the real part of e^{4 i angle} conj(z): no trigonometry needed.
    if (squared_length(side) > 0) sum += 0.5 * (1 - dot(cross_of(side), z));
  }
  return 0.25 * sum;
}

std::int64_t pair_cost(const TriMesh& mesh, Index e, const Fields& fields, double alignment_weight,
                       Index& hint) {
  Vec2 quad[4] = {mesh.points[mesh.apex(e)], mesh.points[mesh.origin(e)],
                  mesh.points[mesh.apex(mesh.twins[e])], mesh.points[mesh.target(e)]};
  const Vec2 center = 0.25 * (quad[0] + quad[1] + quad[2] + quad[3]);
  if (!fields.stretch.empty()) {
    const Vec2 mu = fields.stretch_at(center, hint);
    for (Vec2& corner : quad) corner = stretched(corner - center, mu);
  }
  const double eta = quad_eta(quad[0], quad[1], quad[2], quad[3]);
  double cost = 1 - eta;
  if (alignment_weight > 0 && !fields.background.triangles.empty())
    cost += alignment_weight * misalignment(quad, cross_of(fields.sample(center, hint).axis));
  return static_cast<std::int64_t>(std::floor(cost * unit_cost + 0.5)) +
         (eta > 0 ? 0 : flat_quad_cost);
}

}  // namespace lpq
