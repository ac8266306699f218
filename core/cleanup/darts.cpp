#include "cleanup/darts.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "mesh/quality.h"

namespace lpq {
namespace {

// How far P lies beyond the middle, in shares of the two sides at C. The six quads are strictly
// convex up to .06; the best corners are had with the first.
constexpr std::array<double, 4> offsets{0.04, 0.02, 0.005, 0.001};

// The triangle C (0, 0), D (1, 0), B (0, 1) with P at (1/2, 1/2): places of the vertices inside
// where the least sine of a corner is largest, by a search.
constexpr std::array<Vec2, 5> inside{
    {{0.188, 0.303}, {0.084, 0.232}, {0.228, 0.530}, {0.098, 0.703}, {0.252, 0.321}}};
// In numbers 0 C, 1 D, 2 P, 3 B, 4 .. 8 inside.
constexpr std::array<Face, 6> quads{
    {{2, 3, 7, 6}, {3, 0, 5, 7}, {5, 4, 6, 7}, {0, 1, 2, 8}, {2, 6, 4, 8}, {4, 5, 0, 8}}};

/// Points 0 .. 3 are the corners of the dart from its reflex corner on: D A B C.
struct Cut {
  std::vector<Vec2> points;
  std::vector<Face> faces;
  double worst = 0;  // eta
};

std::optional<Cut> cut_at(const std::array<Vec2, 4>& dart, double offset, bool mirrored) {
  // Mirrored, A and C change places and all turns change their side.
  const Index d = 0, a = mirrored ? 3 : 1, b = 2, c = mirrored ? 1 : 3;
  Cut cut{{dart.begin(), dart.end()}, {}, 1};
  const Vec2 to_d = dart[d] - dart[c], to_b = dart[b] - dart[c];
  const auto place = [&](Vec2 p) { cut.points.push_back(dart[c] + p.x * to_d + p.y * to_b); };
  place({0.5 - offset, 0.5 - offset});
  for (const Vec2 p : inside) place(p);
  const std::array<Index, 9> number{c, d, 4, b, 5, 6, 7, 8, 9};
  cut.faces.push_back({a, b, 4, d});
  for (const Face& quad : quads)
    cut.faces.push_back({number[quad[0]], number[quad[1]], number[quad[2]], number[quad[3]]});
  for (Face& face : cut.faces) {
    if (mirrored) std::swap(face[1], face[3]);
    if (!is_strictly_convex(cut.points, face)) return std::nullopt;
    cut.worst = std::min(cut.worst, face_eta(cut.points, face));
  }
  return cut;
}

std::optional<Cut> best_cut(const std::array<Vec2, 4>& dart) {
  std::optional<Cut> best;
  for (const double offset : offsets)
    for (const bool mirrored : {false, true})
      if (auto cut = cut_at(dart, offset, mirrored); cut && (!best || cut->worst > best->worst))
        best = std::move(cut);
  return best;
}

bool cut_dart(QuadTopology& mesh, Index f) {
  const Face face = mesh.face(f);
  for (Index k = 0; k < 4; ++k) {
    std::array<Vec2, 4> dart;
    for (Index i = 0; i < 4; ++i) dart[i] = mesh.point(face[(k + i) & 3]);
    const auto cut = best_cut(dart);
    if (!cut) continue;
    const Index region = mesh.region(f);
    mesh.remove_face(f);
    std::vector<Index> number;
    for (Index i = 0; i < 4; ++i) number.push_back(face[(k + i) & 3]);
    for (std::size_t i = 4; i < cut->points.size(); ++i)
      number.push_back(mesh.add_vertex(cut->points[i]));
    for (const Face& quad : cut->faces)
      mesh.add_face({number[quad[0]], number[quad[1]], number[quad[2]], number[quad[3]]}, region);
    return true;
  }
  return false;
}

}  // namespace

Index cut_darts(QuadTopology& mesh) {
  Index count = 0;
  const Index slots = mesh.face_slots();
  for (Index f = 0; f < slots; ++f)
    if (mesh.is_alive(f) && mesh.face(f)[3] != none &&
        !is_strictly_convex(mesh.points(), mesh.face(f)))
      count += cut_dart(mesh, f);
  return count;
}

}  // namespace lpq
