#include "patches/block.h"

#include <algorithm>

#include "base/check.h"

namespace lpq {
namespace {

int edge_count(const VertexRow& side) { return static_cast<int>(side.size()) - 1; }

Index add_point(Filling& filling, Vec2 p) {
  filling.points.push_back(p);
  return static_cast<Index>(filling.points.size()) - 1;
}

// A grid between four sides, opposite ones of equal count.
void fill_grid(const VertexRow& south, const VertexRow& east, const VertexRow& north,
               const VertexRow& west, Filling& filling) {
  const int a = edge_count(south), b = edge_count(east);
  if (a == 0 || b == 0) return;  // beside a spoke of no edges
  LPQ_ASSERT(edge_count(north) == a && edge_count(west) == b);
  const auto p = [&](Index v) { return filling.points[v]; };
  const Vec2 c00 = p(south[0]), c10 = p(east[0]), c11 = p(north[0]), c01 = p(west[0]);
  VertexRow below = south;
  for (int j = 1; j <= b; ++j) {
    VertexRow row{west[b - j]};
    const double v = static_cast<double>(j) / b;
    for (int i = 1; i < a; ++i) {
      if (j == b) {
        row.push_back(north[a - i]);
        continue;
      }
      const double u = static_cast<double>(i) / a;
      const Vec2 between =
          (1 - v) * p(south[i]) + v * p(north[a - i]) + (1 - u) * p(west[b - j]) + u * p(east[j]);
      const Vec2 corners = (1 - v) * ((1 - u) * c00 + u * c10) + v * ((1 - u) * c01 + u * c11);
      row.push_back(add_point(filling, between - corners));
    }
    row.push_back(east[j]);
    for (int i = 0; i < a; ++i)
      filling.faces.push_back({below[i], below[i + 1], row[i + 1], row[i]});
    below = std::move(row);
  }
}

// VertexRow i is cut at `split[i]` edges from its first corner; spokes lead from there to the
// centre. When the centre lies on the last side, two of them run along it.
void fill_star(std::span<const VertexRow> sides, const Spokes& spokes, Filling& filling) {
  const int n = static_cast<int>(sides.size());
  std::vector<int> split(n);
  Vec2 middle;
  for (int i = 0; i < n; ++i) {
    split[i] = spokes.edges[(i + n - 1) % n];
    middle += (1.0 / n) * filling.points[sides[i][split[i]]];
  }
  const VertexRow& end = sides[n - 1];
  const bool on_cut = spokes.edges[n - 1] == 0;
  const Index centre = on_cut ? end[split[n - 1]] : add_point(filling, middle);
  std::vector<VertexRow> inward(n);
  for (int i = 0; i < n; ++i) {
    if (on_cut && i == 0)
      inward[i] = VertexRow(end.rbegin(), end.rend() - split[n - 1]);
    else if (on_cut && i == n - 2)
      inward[i] = VertexRow(end.begin(), end.begin() + split[n - 1] + 1);
    else
      inward[i] = straight_side(sides[i][split[i]], centre, spokes.edges[i], filling);
  }
  for (int i = 0; i < n; ++i) {
    const int h = (i + n - 1) % n;
    const VertexRow south(sides[i].begin(), sides[i].begin() + split[i] + 1);
    const VertexRow west(sides[h].begin() + split[h], sides[h].end());
    fill_grid(south, inward[i], VertexRow(inward[h].rbegin(), inward[h].rend()), west, filling);
  }
}

}  // namespace

Spokes find_spokes(std::span<const int> s, LastSide last) {
  const int n = static_cast<int>(s.size());
  Spokes result;
  if (n == 4) {
    result.fits = s[0] == s[2] && s[1] == s[3] && s[0] > 0 && s[1] > 0;
    result.least = std::min(s[0], s[1]);
    return result;
  }
  if (n != 3 && n != 5) return result;
  int sum = 0;
  for (const int edges : s) sum += edges;
  if (sum % 2 != 0) return result;
  result.least = sum;
  for (int j = 0; j < n; ++j) {
    const int edges = n == 3 ? sum / 2 - s[j] : sum / 2 - s[(j + 2) % 5] - s[(j + 3) % 5];
    result.edges[j] = edges;
    if (j + 1 == n && last == LastSide::cut)
      result.fits = edges >= 0;
    else
      result.least = std::min(result.least, edges);
  }
  result.fits = (last == LastSide::outline || result.fits) && result.least >= 1;
  return result;
}

VertexRow straight_side(Index a, Index b, int edges, Filling& filling) {
  const Vec2 start = filling.points[a], way = filling.points[b] - start;
  if (edges == 0) return {b};
  VertexRow side{a};
  for (int i = 1; i < edges; ++i)
    side.push_back(add_point(filling, start + (static_cast<double>(i) / edges) * way));
  side.push_back(b);
  return side;
}

void fill_block(std::span<const VertexRow> sides, Filling& filling) {
  if (sides.size() == 4) {
    fill_grid(sides[0], sides[1], sides[2], sides[3], filling);
    return;
  }
  std::vector<int> lengths;
  for (const VertexRow& side : sides) lengths.push_back(edge_count(side));
  const Spokes spokes = find_spokes(lengths, LastSide::cut);
  LPQ_ASSERT(spokes.fits);
  fill_star(sides, spokes, filling);
}

}  // namespace lpq
