// See outlines.h.
#include "io/domain/outlines.h"

#include <algorithm>
#include <cmath>

namespace lpq {
namespace {

struct Ends {
  Index lo, hi, edge;
  auto operator<=>(const Ends&) const = default;
};

Ends ends_of(const LineWork::Edge& edge, Index number) {
  return {std::min(edge.a, edge.b), std::max(edge.a, edge.b), number};
}

/// The edge that each copy joins the points of.
std::vector<Index> originals(const LineWork& lines) {
  std::vector<Index> original;
  if (lines.copies.empty()) return original;
  std::vector<Ends> ends;
  for (const LineWork::Edge& edge : lines.edges)
    ends.push_back(ends_of(edge, static_cast<Index>(ends.size())));
  std::sort(ends.begin(), ends.end());
  for (const LineWork::Edge& copy : lines.copies)
    original.push_back(std::lower_bound(ends.begin(), ends.end(), ends_of(copy, none))->edge);
  return original;
}

bool contains(const std::vector<Index>& values, Index value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

/// Without those that are not among what drew this edge.
void keep_common(std::vector<Index>& shared, std::span<const DrawnEdge> drawn) {
  std::erase_if(shared, [&](Index source) {
    return std::none_of(drawn.begin(), drawn.end(),
                        [&](const DrawnEdge& d) { return d.source == source; });
  });
}

}  // namespace

std::vector<double> outline_areas(const LineWork& lines) {
  std::vector<double> twice_area;
  const auto add = [&](const LineWork::Edge& edge) {
    if (edge.outline == none) return;
    const auto size = static_cast<std::size_t>(edge.outline) + 1;
    if (twice_area.size() < size) twice_area.resize(size, 0);
    const Vec2 origin = lines.points.front();
    twice_area[edge.outline] += cross(lines.points[edge.a] - origin, lines.points[edge.b] - origin);
  };
  for (const LineWork::Edge& edge : lines.edges) add(edge);
  for (const LineWork::Edge& copy : lines.copies) add(copy);
  return twice_area;
}

DrawnEdges drawn_edges_of(const LineWork& lines, const std::vector<Index>& first_of_name) {
  DrawnEdges drawn;
  const std::vector<Index> original = originals(lines);
  const auto drawn_as = [&](const LineWork::Edge& edge, bool along) {
    return DrawnEdge{first_of_name[edge.source], edge.outline, along};
  };
  drawn.of_edge = csr_from<DrawnEdge>(lines.edges.size(), [&](auto&& emit) {
    for (Index e = 0; e < static_cast<Index>(lines.edges.size()); ++e)
      emit(e, drawn_as(lines.edges[e], true));
    for (std::size_t c = 0; c < original.size(); ++c)
      emit(original[c], drawn_as(lines.copies[c], lines.copies[c].a == lines.edges[original[c]].a));
  });
  drawn.twice_area = outline_areas(lines);
  return drawn;
}

std::vector<Index> Enclosure::all() const {
  std::vector<Index> sources = outlines;
  for (const Index source : shared)
    if (!contains(sources, source)) sources.push_back(source);
  return sources;
}

Enclosure enclosure_of(const DrawnEdges& drawn, const LineWork& lines, const Walk& face) {
  struct Around {
    double twice_area;
    Index outline, source;
    auto operator<=>(const Around&) const = default;
  };
  std::vector<Around> around;
  Enclosure enclosure;
  for (const DrawnEdge& d : drawn.of_edge.row(face.edges.front()))
    if (!contains(enclosure.shared, d.source)) enclosure.shared.push_back(d.source);
  for (std::size_t i = 0; i < face.edges.size(); ++i) {
    keep_common(enclosure.shared, drawn.of_edge.row(face.edges[i]));
    const bool forward = lines.edges[face.edges[i]].a == face.points[i];
    for (const DrawnEdge& d : drawn.of_edge.row(face.edges[i])) {
      if (d.outline == none) continue;
      // The face is to the left of its walk, what an outline encloses to the left of it or right.
      const double area = drawn.twice_area[d.outline];
      if (area != 0 && (forward == d.along) == (area > 0))
        around.push_back({std::abs(area), d.outline, d.source});
    }
  }
  std::sort(around.begin(), around.end());
  for (const Around& a : around)
    if (!contains(enclosure.outlines, a.source)) enclosure.outlines.push_back(a.source);
  return enclosure;
}

}  // namespace lpq
