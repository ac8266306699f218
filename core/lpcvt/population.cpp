// See population.h.
#include "lpcvt/population.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/sort_numbers.h"
#include "geometry/grid.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

// Energies, in units of the square cell's, beyond which a cell may be called a gap or a crowd. They
// say only what is worth trying; whether it was is seen afterwards. Steady between 1.2 and 1.4.
constexpr double least_of_gap = 1.3;
constexpr double most_of_crowd = 0.999;
// Changes nearer to each other than this, in units of h, would be judged by each other's effect.
constexpr double apart = 3;

struct Candidate {
  double rank = 0;  // the least first
  Index site = none;
  Vec2 place;
};

// The corner of each site's cell that is farthest in units of h, and how far. Corners on walls do
// not count: what lies beyond them is no gap.
struct Reach {
  double distance = 0;
  Vec2 corner;
};

std::vector<Reach> reaches(const TriMesh& mesh, const EnergyWorkspace& work) {
  std::vector<Reach> result(mesh.points.size());
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    if (work.dual.sheet[t] != none) continue;
    const Vec2 corner = work.dual.vertices[t];
    for (const Index v : mesh.triangles[t]) {
      const Vec2 d = corner - mesh.points[v];
      const FieldSample& metric = work.metric[v];
      const double along = std::abs(dot(metric.axis, d)), across = std::abs(cross(metric.axis, d));
      const double distance = std::max(along, across) / metric.h;
      if (distance > result[v].distance) result[v] = {distance, corner};
    }
  }
  return result;
}

void sort(std::vector<Candidate>& candidates) {
  sort_values(candidates, [](const Candidate& a, const Candidate& b) {
    return a.rank != b.rank ? a.rank < b.rank : a.site < b.site;
  });
}

std::vector<Candidate> gaps(const TriMesh& mesh, const EnergyWorkspace& work, double p) {
  const double square = square_cell_energy(p);
  const std::vector<Reach> reach = reaches(mesh, work);
  std::vector<Candidate> result;
  for (Index v = 0; v < static_cast<Index>(mesh.points.size()); ++v) {
    const double energy = work.cell_energy[v] / square;
    if (energy > least_of_gap && reach[v].distance > 0)
      result.push_back({-energy, v, reach[v].corner});
  }
  sort(result);
  return result;
}

std::vector<Candidate> crowds(const TriMesh& mesh, const EnergyWorkspace& work, double p) {
  const double square = square_cell_energy(p);
  std::vector<Candidate> result;
  for (Index v = mesh.fixed; v < static_cast<Index>(mesh.points.size()); ++v) {
    const double energy = work.cell_energy[v] / square;
    if (energy < most_of_crowd) result.push_back({energy, v, mesh.points[v]});
  }
  sort(result);
  return result;
}

// The first of the candidates, as many as wanted, that are far from all changes so far.
template <class Take>
Index choose(const std::vector<Candidate>& candidates, const EnergyWorkspace& work, Index wanted,
             PointGrid& changes, Take take) {
  Index count = 0;
  for (const Candidate& c : candidates) {
    if (count >= wanted) break;
    const double h = work.metric[c.site].h, least = apart * h;
    const bool near = changes.any_near(c.place, h, least, [&](Index, Vec2 q) {
      return squared_length(q - c.place) < least * least;
    });
    if (near) continue;
    changes.insert(c.place, h, c.site);
    take(c);
    ++count;
  }
  return count;
}

}  // namespace

double square_cell_energy(double p) {
  // 2 int_{-1/2}^{1/2} |x|^p dx
  constexpr double log_2 = 0.693147180559945309;
  return 2 * exponential(-p * log_2) / (p + 1);
}

double priced_energy(double energy, Index free_points, double p) {
  return energy / square_cell_energy(p) + 0.5 * p * free_points;
}

Exchange propose_exchange(const TriMesh& mesh, const EnergyWorkspace& workspace, double p,
                          Index most, Index missing) {
  LPQ_ASSERT(workspace.cell_energy.size() == mesh.points.size());
  Exchange exchange;
  PointGrid changes;
  const Index lacking = std::clamp<Index>(missing, 0, most);
  const Index surplus = std::clamp<Index>(-missing, 0, most);
  const auto insert = [&](const Candidate& c) { exchange.inserted.push_back(c.place); };
  const auto remove = [&](const Candidate& c) { exchange.removed.push_back(c.site); };
  const Index inserted =
      choose(gaps(mesh, workspace, p), workspace, most - surplus, changes, insert);
  // As many leave as come, but for what the count lacks or has too many of.
  const Index leaving = std::max<Index>(0, inserted - lacking) + surplus;
  const Index removed = choose(crowds(mesh, workspace, p), workspace, leaving, changes, remove);
  exchange.inserted.resize(std::min(inserted, removed + lacking));
  return exchange;
}

std::vector<Vec2> points_after(const TriMesh& mesh, const Exchange& exchange) {
  std::vector<char> leaves(mesh.points.size(), 0);
  for (const Index v : exchange.removed) leaves[v] = 1;
  std::vector<Vec2> points;
  for (Index v = mesh.fixed; v < static_cast<Index>(mesh.points.size()); ++v)
    if (!leaves[v]) points.push_back(mesh.points[v]);
  points.insert(points.end(), exchange.inserted.begin(), exchange.inserted.end());
  return points;
}

}  // namespace lpq
