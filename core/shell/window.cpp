// See window.h.
#include "shell/window.h"

#include <algorithm>
#include <utility>

#include "base/sort_numbers.h"
#include "base/sort_unique.h"
#include "cleanup/quad_topology.h"
#include "geometry/box.h"
#include "shell/chart_fields.h"
#include "surface/charts/checks.h"
#include "surface/charts/map_part.h"

namespace lpq {
namespace {

/// Into a box of the order of one, by a power of two: planar thresholds are meant for that.
void normalise(Chart& chart) {
  const Box box = box_of(chart.plane.points);
  const double extent = longer_side(box);
  double factor = 1;
  while (factor * extent > 1) factor *= 0.5;
  while (factor * extent < 0.5) factor *= 2;
  for (Vec2& p : chart.plane.points) p = factor * (p - box.lo);
  for (double& scale : chart.scale) scale *= factor;
}

using Edge = std::array<Index, 2>;

std::vector<Edge> directed_edges(const ShellMesh& shell, const std::vector<Index>& faces) {
  std::vector<Edge> edges;
  for (const Index f : faces)
    for (int k = 0; k < corner_count(shell.faces[f]); ++k)
      edges.push_back({shell.faces[f][k], shell.faces[f][(k + 1) % corner_count(shell.faces[f])]});
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Origins of the edges that have no opposite, ascending; a vertex that the border passes twice is
/// there twice.
std::vector<Index> border_origins(const ShellMesh& shell, const std::vector<Index>& faces) {
  const std::vector<Edge> edges = directed_edges(shell, faces);
  std::vector<Index> origins;
  for (const auto& [a, b] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), Edge{b, a})) origins.push_back(a);
  return origins;
}

/// Drops faces until the border passes no vertex twice.
void drop_pinches(const ShellMesh& shell, std::vector<Index>& faces) {
  for (;;) {
    const std::vector<Index> origins = border_origins(shell, faces);
    std::vector<Index> pinched;
    for (std::size_t i = 1; i < origins.size(); ++i)
      if (origins[i] == origins[i - 1]) pinched.push_back(origins[i]);
    if (pinched.empty()) return;
    std::erase_if(faces, [&](Index f) {
      return std::any_of(shell.faces[f].begin(), shell.faces[f].end(), [&](Index v) {
        return std::binary_search(pinched.begin(), pinched.end(), v);
      });
    });
  }
}

}  // namespace

WindowMaker::WindowMaker(const SurfaceMesh& mesh, const SurfaceCrossField& cross,
                         std::span<const double> size)
    : mesh_(mesh),
      cross_(cross),
      size_(size),
      uncut_(mesh.twins.size(), 0),
      taker_(mesh),
      own_(mesh.triangles.size(), none) {}

bool WindowMaker::map(std::vector<Index> triangles, Chart& chart) {
  const Part part = taker_.take(std::move(triangles), uncut_);
  bool solved = false;
  PartMap map = map_part(mesh_, part, {}, MapMethod::lscm, solved);
  if (map.verdict != Verdict::accepted) return false;
  chart.triangles = part.triangles;
  chart.vertex = part.vertex;
  chart.plane.points = std::move(map.uv);
  chart.plane.triangles = part.corners;
  chart.plane.twins = part.twins;
  chart.plane.region.assign(part.triangles.size(), 0);
  chart.scale = scales_of(mesh_, part, chart.plane.points);
  normalise(chart);
  return true;
}

std::vector<Index> WindowMaker::faces_inside(const ShellMesh& shell, const ShellStars& stars,
                                             const Ball& ball, const Chart& chart) {
  for (std::size_t i = 0; i < chart.triangles.size(); ++i)
    own_[chart.triangles[i]] = static_cast<Index>(i);
  std::vector<Index> faces;
  for (std::size_t i = 0; i < chart.triangles.size(); ++i)
    if (ball.inside[i])
      stars.for_each_vertex_in(chart.triangles[i], [&](Index v) {
        stars.for_each_face_at(v, [&](Index f) { faces.push_back(f); });
      });
  sort_unique(faces);
  const auto is_inside = [&](Index v) {
    const Index t = own_[shell.places[v].triangle];
    return t != none && ball.inside[t];
  };
  std::erase_if(faces, [&](Index f) {
    const Face& face = shell.faces[f];
    return face[0] == none || face[3] == none || !std::all_of(face.begin(), face.end(), is_inside);
  });
  drop_bad_rim(shell, chart, faces);
  return faces;
}

Vec2 WindowMaker::in_plane(const ShellMesh& shell, const Chart& chart, Index v) const {
  const SurfacePlace& place = shell.places[v];
  const Tri& corners = chart.plane.triangles[own_[place.triangle]];
  Vec2 p{};
  for (int k = 0; k < 3; ++k) p += place.weight[k] * chart.plane.points[corners[k]];
  return p;
}

/// What is not convex in this plane and touches the rim, which is fixed, might never be mended.
void WindowMaker::drop_bad_rim(const ShellMesh& shell, const Chart& chart,
                               std::vector<Index>& faces) const {
  for (std::size_t before = faces.size() + 1; before != faces.size();) {
    before = faces.size();
    drop_pinches(shell, faces);
    const std::vector<Index> rim = border_origins(shell, faces);
    std::erase_if(faces, [&](Index f) {
      const Face& face = shell.faces[f];
      std::array<Vec2, 4> p;
      bool fixed = false;
      for (int k = 0; k < 4; ++k) {
        p[k] = in_plane(shell, chart, face[k]);
        fixed =
            fixed || !shell.is_free(face[k]) || std::binary_search(rim.begin(), rim.end(), face[k]);
      }
      return fixed && !is_strictly_convex(p, {0, 1, 2, 3});
    });
  }
}

/// Faces around free vertices of the rim.
void WindowMaker::count_outside(const ShellMesh& shell, const ShellStars& stars,
                                Window& window) const {
  QuadMesh& quads = window.quads;
  quads.outside.assign(quads.fixed, 0);
  for (Index v = 0; v < quads.fixed; ++v)
    stars.for_each_face_at(window.vertex[v],
                           [&](Index f) { quads.outside[v] += shell.faces[f][0] != none; });
  for (const Face& face : quads.faces)
    for (const Index v : face)
      if (v < quads.fixed) --quads.outside[v];
  for (Index v = 0; v < quads.fixed; ++v)
    if (!shell.is_free(window.vertex[v])) quads.outside[v] = none;
}

void WindowMaker::lay_out(const ShellMesh& shell, Window& window) {
  std::vector<Index> all;
  for (const Index f : window.faces)
    all.insert(all.end(), shell.faces[f].begin(), shell.faces[f].end());
  sort_unique(all);
  const std::vector<Index> border = border_origins(shell, window.faces);
  std::vector<Index> order, movable;
  for (const Index v : all) {
    const bool fixed = !shell.is_free(v) || std::binary_search(border.begin(), border.end(), v);
    (fixed ? order : movable).push_back(v);
  }
  QuadMesh& quads = window.quads;
  quads.fixed = static_cast<Index>(order.size());
  order.insert(order.end(), movable.begin(), movable.end());
  std::vector<Index> number(all.size());  // in the window, of those in `all`
  for (const Index v : order) {
    number[index_of(v, all)] = static_cast<Index>(quads.points.size());
    quads.points.push_back(in_plane(shell, window.chart, v));
  }
  const auto of = [&](Index v) { return number[index_of(v, all)]; };
  for (const Index f : window.faces) {
    Face face;
    for (int k = 0; k < 4; ++k) face[k] = of(shell.faces[f][k]);
    quads.faces.push_back(face);
    for (int k = 0; k < 4; ++k) {
      const Index a = shell.faces[f][k], b = shell.faces[f][(k + 1) % 4];
      if (a < b && std::binary_search(shell.edges.begin(), shell.edges.end(), Edge{a, b}))
        quads.walls.push_back({std::min(of(a), of(b)), std::max(of(a), of(b))});
    }
  }
  quads.region.assign(quads.faces.size(), 0);
  sort_unique(quads.walls);
  window.vertex = std::move(order);
}

std::optional<Window> WindowMaker::open(const ShellMesh& shell, const ShellStars& stars,
                                        const Ball& ball) {
  Window window;
  if (!map(ball.triangles, window.chart)) return std::nullopt;
  window.faces = faces_inside(shell, stars, ball, window.chart);
  if (!window.faces.empty()) {
    lay_out(shell, window);
    count_outside(shell, stars, window);
  }
  for (const Index t : window.chart.triangles) own_[t] = none;
  if (window.faces.empty()) return std::nullopt;
  window.fields = chart_fields(mesh_, cross_, size_, window.chart);
  return window;
}

}  // namespace lpq
