// Quality measures of the paper: eta of a quad (section 5), tau of a triangulation (Eq. 2).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/quad_mesh.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// eta = max(1 - 2/pi max_k |pi/2 - alpha_k|, 0) with signed interior angles in (0, 2 pi).
double quad_eta(Vec2 a, Vec2 b, Vec2 c, Vec2 d);
/// The same for three corners that should have 60 degrees: 1 - max_k |pi/3 - alpha_k| over what the
/// angle can deviate to that side (2 pi/3 above, pi/3 below).
double triangle_eta(Vec2 a, Vec2 b, Vec2 c);
double face_eta(const std::vector<Vec2>& points, const Face& face);  // of either

/// tau = mean over triangles of max_j |sin theta_j|; 1 for right-angled triangles.
double tau(const TriMesh& mesh);

struct QuadQuality {
  Index quads = 0, triangles = 0;
  double eta_mean = 0, eta_min = 0, eta_p5 = 0;
  Index interior_vertices = 0, regular_vertices = 0;  // regular = 4-valent
  double four_valent_percent = 100;
  Index inverted = 0, nonconvex = 0;
  std::array<Index, 10> valence_histogram{};  // interior vertices by valence, last = 9 and more
  std::array<Index, 20> eta_histogram{};
};
QuadQuality quad_quality(const QuadMesh& mesh);

/// Takes in the vertices that are used and not on a border. `valence`, `border`: #V.
void count_valences(std::span<const Index> valence, std::span<const char> border,
                    QuadQuality& quality);

/// Linear interpolation between order statistics; 0 of no values.
double percentile(std::span<const double> sorted, double share);

}  // namespace lpq
