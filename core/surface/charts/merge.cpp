// Splitting by distance knows nothing of shape and makes more parts than needed: pairs with long
// common cuts are mapped again as one.
#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "base/sort_numbers.h"
#include "surface/charts/chart_maker.h"

namespace lpq {
namespace {

// Triangles mapped in trials, as a multiple of the surface's: bounds what merging may cost.
constexpr double most_work = 3;
constexpr int passes = 4;

double border_length(const SurfaceMesh& mesh, const Chart& chart) {
  double sum = 0;
  for (const Index e : chart.borders.values)
    sum += distance(mesh.points[mesh.origin(e)], mesh.points[mesh.target(e)]);
  return sum;
}

}  // namespace

// Pairs of charts of one face that share a cut, those with the largest share of the smaller one's
// border first.
std::vector<ChartMaker::Neighbours> ChartMaker::neighbours() const {
  std::vector<Neighbours> pieces;
  for (Index e = 0; e < static_cast<Index>(mesh_.twins.size()); ++e) {
    const Index twin = mesh_.twins[e];
    if (twin == none || face_[triangle_of(e)] != face_[triangle_of(twin)]) continue;
    const Index a = chart_of_[triangle_of(e)], b = chart_of_[triangle_of(twin)];
    if (a < b)
      pieces.push_back(
          {a, b, distance(mesh_.points[mesh_.origin(e)], mesh_.points[mesh_.target(e)])});
  }
  sort_values(pieces, [](const Neighbours& p, const Neighbours& q) {
    return std::tie(p.a, p.b, p.shared) < std::tie(q.a, q.b, q.shared);
  });
  std::vector<Neighbours> pairs;
  for (const Neighbours& piece : pieces) {
    if (pairs.empty() || pairs.back().a != piece.a || pairs.back().b != piece.b)
      pairs.push_back({piece.a, piece.b, 0});
    pairs.back().shared += piece.shared;
  }
  for (Neighbours& pair : pairs)
    pair.shared /= std::min(border_length(mesh_, atlas_.charts[pair.a]),
                            border_length(mesh_, atlas_.charts[pair.b]));
  sort_values(pairs, [](const Neighbours& p, const Neighbours& q) {
    return std::tie(q.shared, p.a, p.b) < std::tie(p.shared, q.a, q.b);
  });
  return pairs;
}

std::vector<Index> ChartMaker::shared_cuts(Index a, Index b) const {
  std::vector<Index> cuts;
  for (const Index e : atlas_.charts[a].borders.values)
    if (mesh_.twins[e] != none && chart_of_[triangle_of(mesh_.twins[e])] == b) cuts.push_back(e);
  return cuts;
}

bool ChartMaker::try_merge(Index a, Index b) {
  const std::vector<Index> cuts = shared_cuts(a, b);
  std::vector<Index> triangles = atlas_.charts[a].triangles;
  triangles.insert(triangles.end(), atlas_.charts[b].triangles.begin(),
                   atlas_.charts[b].triangles.end());
  mark(cuts, 0);
  const Part part = taker_.take(std::move(triangles), atlas_.cut);
  PartMap result;
  if (!known_hopeless(part)) result = map(part, MapMethod::bff);
  if (result.verdict != Verdict::accepted) {
    mark(cuts, 1);
    remember_hopeless(part);
    return false;
  }
  ++atlas_.counts.merged;
  keep(part, std::move(result));
  return true;
}

void ChartMaker::merge() {
  double work = 0;
  const double most = most_work * mesh_.triangle_count();
  for (int pass = 0; pass < passes && work < most; ++pass) {
    std::vector<char> gone(atlas_.charts.size(), 0);
    for (const auto& [a, b, shared] : neighbours()) {
      if (gone[a] || gone[b] || work >= most) continue;
      const std::size_t size =
          atlas_.charts[a].triangles.size() + atlas_.charts[b].triangles.size();
      work += static_cast<double>(size);
      if (try_merge(a, b)) gone[a] = gone[b] = 1;
    }
    if (std::count(gone.begin(), gone.end(), 1) == 0) break;
    std::vector<Chart> left;
    for (std::size_t i = 0; i < atlas_.charts.size(); ++i)
      if (i >= gone.size() || !gone[i]) left.push_back(std::move(atlas_.charts[i]));
    atlas_.charts = std::move(left);
    for (std::size_t i = 0; i < atlas_.charts.size(); ++i)
      for (const Index t : atlas_.charts[i].triangles) chart_of_[t] = static_cast<Index>(i);
  }
}

}  // namespace lpq
