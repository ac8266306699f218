#include "cleanup/untangle.h"

#include <algorithm>

#include "base/csr.h"
#include "cleanup/descent.h"
#include "cleanup/mesh_part.h"
#include "cleanup/quad_topology.h"
#include "cleanup/star_centre.h"

namespace lpq {
namespace {

constexpr int centre_sweeps = 12, quick_sweeps = 4;
constexpr int continuation_rounds = 8, descent_steps = 25;
// Rings of faces around the invalid ones that may move; wider when the narrower try did not do.
constexpr int rings[] = {2, 4, 7};

Index count_invalid(const QuadMesh& mesh) {
  return static_cast<Index>(std::count_if(mesh.faces.begin(), mesh.faces.end(), [&](const Face& f) {
    return !is_strictly_convex(mesh.points, f);
  }));
}

// Marks the corners of invalid faces, and with `neighbours` those of the faces around them; false
// if there are none.
bool mark_tangled(const QuadMesh& mesh, const Csr<Index>& stars, bool neighbours,
                  std::vector<char>& wanted) {
  std::fill(wanted.begin(), wanted.end(), 0);
  bool tangled = false;
  for (const Face& face : mesh.faces) {
    if (is_strictly_convex(mesh.points, face)) continue;
    tangled = true;
    for (int k = 0; k < corner_count(face); ++k) {
      wanted[face[k]] = 1;
      if (!neighbours) continue;
      for (const Index f : stars.row(face[k]))
        for (int i = 0; i < corner_count(mesh.faces[f]); ++i) wanted[mesh.faces[f][i]] = 1;
    }
  }
  return tangled;
}

// Moves vertices around invalid faces to the centres of their stars, one after the other.
void centre_vertices(QuadMesh& mesh, const Csr<Index>& stars, int sweeps, bool neighbours) {
  const std::vector<double> sizes = vertex_sizes(mesh);
  std::vector<char> wanted(mesh.points.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    if (!mark_tangled(mesh, stars, neighbours, wanted)) return;
    for (std::size_t v = mesh.fixed; v < mesh.points.size(); ++v) {
      const double size = sizes[v - mesh.fixed];
      const Index id = static_cast<Index>(v);
      if (!wanted[v] || size == 0) continue;
      const StarCentre best = star_centre(mesh.points, mesh.faces, stars.row(id), id, size);
      if (best.after > best.before) mesh.points[v] = best.position;
    }
  }
}

// Mean ratio with epsilon from the worst corner down to zero (method of continuation): the worst
// corners pull hardest, and once all are positive the barrier keeps them so.
void descend_mean_ratio(QuadMesh& mesh) {
  const std::vector<double> unit = own_inverse_squares(mesh.faces, mesh.points);
  const std::vector<double> sizes = vertex_sizes(mesh);
  double shrink = 1;
  for (int round = 0; round < continuation_rounds; ++round, shrink *= epsilon_shrink) {
    const double worst = smallest_corner(mesh.faces, mesh.points, unit);
    const bool valid = worst > untangled_corner;
    MeanRatioOptions options;
    if (!valid) options.epsilon = shrink * std::min(untangling_epsilon(worst), most_epsilon);
    descend(mesh, sizes, descent_steps,
            [&](std::span<const Vec2> points, std::span<Vec2> gradient) {
              return mean_ratio_energy(mesh.faces, points, unit, options, gradient);
            });
    if (valid) return;
  }
}

}  // namespace

std::vector<Index> invalid_faces(const QuadMesh& mesh) {
  std::vector<Index> result;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (!is_strictly_convex(mesh.points, mesh.faces[f])) result.push_back(static_cast<Index>(f));
  return result;
}

void untangle_patch(QuadMesh& patch, Untangling untangling) {
  const Csr<Index> stars = faces_at_vertices(patch);
  const int sweeps = untangling == Untangling::thorough ? centre_sweeps : quick_sweeps;
  centre_vertices(patch, stars, sweeps, untangling != Untangling::quick);
  if (untangling != Untangling::thorough || count_invalid(patch) == 0) return;
  descend_mean_ratio(patch);
  centre_vertices(patch, stars, centre_sweeps, true);
}

Index untangle(QuadMesh& mesh) {
  const Csr<Index> stars = faces_at_vertices(mesh);
  std::vector<Index> invalid = invalid_faces(mesh);
  const std::size_t at_start = invalid.size();
  for (const int width : rings) {
    if (invalid.empty()) break;
    for (const std::vector<Index>& cluster : face_clusters(mesh, stars, invalid, width)) {
      MeshPart part = extract_part(mesh, stars, cluster);
      const Index before = count_invalid(part.mesh);
      untangle_patch(part.mesh, Untangling::thorough);
      if (count_invalid(part.mesh) < before) put_back(part, mesh);
    }
    invalid = invalid_faces(mesh);
  }
  return static_cast<Index>(at_start - invalid.size());
}

}  // namespace lpq
