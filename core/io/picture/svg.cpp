// See svg.h.
#include "io/picture/svg.h"

#include <algorithm>
#include <array>

#include "io/number.h"
#include "io/picture/svg_canvas.h"
#include "mesh/quality.h"

namespace lpq {
namespace {

constexpr std::size_t colour_bins = 24;
constexpr std::array<Colour, 5> eta_colours{
    {{178, 24, 43}, {239, 138, 98}, {253, 219, 160}, {214, 234, 214}, {223, 238, 250}}};
constexpr std::array<Colour, 5> energy_colours{
    {{247, 251, 240}, {186, 228, 188}, {123, 204, 196}, {43, 140, 190}, {8, 64, 129}}};
constexpr const char* blue = "#1f5fd0";
constexpr const char* red = "#d0312d";
constexpr const char* violet = "#8a2fb0";

/// One path per colour bin.
class FilledCells {
 public:
  explicit FilledCells(std::span<const Colour> stops) : stops_(stops), paths_(colour_bins) {}
  std::string& path(double t) {
    const double at = t > 0 ? std::min(t, 1.0) * static_cast<double>(colour_bins) : 0;
    return paths_[std::min(static_cast<std::size_t>(at), colour_bins - 1)];
  }
  void paint(SvgCanvas& canvas) const {
    for (std::size_t k = 0; k < paths_.size(); ++k) {
      const double t = (static_cast<double>(k) + 0.5) / static_cast<double>(colour_bins);
      canvas.paint(paths_[k], "fill=\"" + colour_text(blend(stops_, t)) + "\"");
    }
  }

 private:
  std::span<const Colour> stops_;
  std::vector<std::string> paths_;
};

struct MeshEdge {
  Index a = none, b = none;  // a < b
  int faces = 0;
};

/// Each edge once, with its number of faces; sorted.
std::vector<MeshEdge> unique_edges(std::span<const Face> faces) {
  std::vector<std::array<Index, 2>> sides;
  for (const Face& face : faces) {
    const int n = corner_count(face);
    for (int k = 0; k < n; ++k) {
      const Index a = face[k], b = face[(k + 1) % n];
      sides.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<MeshEdge> edges;
  for (const auto& side : sides) {
    if (edges.empty() || edges.back().a != side[0] || edges.back().b != side[1]) {
      edges.push_back({side[0], side[1], 0});
    }
    ++edges.back().faces;
  }
  return edges;
}

std::string stroke(const char* colour, double width) {
  std::string attributes = "fill=\"none\" stroke-linecap=\"round\" stroke=\"";
  attributes += colour;
  attributes += "\" stroke-width=\"";
  append_fixed(attributes, width, 2);
  attributes += '"';
  return attributes;
}

/// Line width and dot radius that suit the mesh: shares of its mean edge in pixels.
struct PenSizes {
  double thin = 1, thick = 2, dot = 3;
};
PenSizes pen_sizes(const SvgCanvas& canvas, std::span<const Vec2> points,
                   std::span<const MeshEdge> edges) {
  double sum = 0;
  for (const MeshEdge& e : edges)
    sum += distance(points[static_cast<std::size_t>(e.a)], points[static_cast<std::size_t>(e.b)]);
  const double pixels =
      edges.empty() ? 20 : sum / static_cast<double>(edges.size()) * canvas.scale();
  return {std::clamp(0.045 * pixels, 0.1, 1.0), std::clamp(0.13 * pixels, 0.8, 2.6),
          std::clamp(0.2 * pixels, 0.8, 6.0)};
}

const char* valence_colour(int valence) {
  return valence == 3 ? blue : valence == 5 ? red : violet;
}

std::string draw_faces(std::span<const Vec2> points, std::span<const Face> faces,
                       std::span<const std::array<Index, 2>> walls) {
  SvgCanvas canvas(points, "quad mesh");
  const auto at = [&](Index v) { return points[static_cast<std::size_t>(v)]; };
  FilledCells cells(eta_colours);
  std::string triangles;
  std::vector<int> valence(points.size(), 0);  // incident faces = incident edges at inner vertices
  for (const Face& face : faces) {
    const int n = corner_count(face);
    std::array<Vec2, 4> corners;
    for (int k = 0; k < n; ++k) {
      corners[static_cast<std::size_t>(k)] = at(face[k]);
      ++valence[static_cast<std::size_t>(face[k])];
    }
    const double eta = n == 4 ? quad_eta(corners[0], corners[1], corners[2], corners[3]) : 0;
    canvas.add_polygon(n == 4 ? cells.path(eta) : triangles,
                       std::span<const Vec2>(corners.data(), static_cast<std::size_t>(n)));
  }
  cells.paint(canvas);
  canvas.paint(triangles, "fill=\"#bdbdbd\"");

  const std::vector<MeshEdge> edges = unique_edges(faces);
  const PenSizes pen = pen_sizes(canvas, points, edges);
  std::string thin, thick;
  std::vector<char> inner(points.size(), 1);
  for (const MeshEdge& e : edges) {
    canvas.add_segment(e.faces == 1 ? thick : thin, at(e.a), at(e.b));
    if (e.faces == 1)
      inner[static_cast<std::size_t>(e.a)] = inner[static_cast<std::size_t>(e.b)] = 0;
  }
  for (const auto& wall : walls) canvas.add_segment(thick, at(wall[0]), at(wall[1]));
  canvas.paint(thin, stroke("#4a5a6a", pen.thin));
  canvas.paint(thick, stroke("#101820", pen.thick));
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (inner[v] && valence[v] != 4 && valence[v] != 0)
      canvas.dot(points[v], pen.dot, valence_colour(valence[v]));
  }
  canvas.legend(eta_colours, "\u03b7 = 0", "1; dots: valence 3 blue, 5 red, others violet");
  return canvas.finish();
}

}  // namespace

std::string draw_quads(const OutputMesh& mesh) {
  std::vector<std::array<Index, 2>> walls;
  for (const OutputEdge& edge : mesh.edges)
    if (edge.left != none && edge.right != none) walls.push_back({edge.a, edge.b});
  return draw_faces(mesh.points, mesh.faces, walls);
}

std::string draw_quads(const QuadMesh& mesh) {
  return draw_faces(mesh.points, mesh.faces, mesh.walls);
}

std::string draw_triangles(const TriMesh& mesh) {
  SvgCanvas canvas(mesh.points, "triangulation");
  std::string thin, thick;
  std::vector<MeshEdge> edges;
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    const Index twin = mesh.twins[static_cast<std::size_t>(e)];
    if (twin != none && twin < e) continue;
    const Index a = mesh.origin(e), b = mesh.target(e);
    edges.push_back({a, b, 1});
    canvas.add_segment(twin == none ? thick : thin, mesh.points[static_cast<std::size_t>(a)],
                       mesh.points[static_cast<std::size_t>(b)]);
  }
  const PenSizes pen = pen_sizes(canvas, mesh.points, edges);
  canvas.paint(thin, stroke("#4a5a6a", pen.thin));
  canvas.paint(thick, stroke("#101820", pen.thick));
  return canvas.finish();
}

std::string draw_cells(const TriMesh& mesh, const ClippedVoronoi& cells,
                       std::span<const double> cell_energy, std::span<const double> cell_area) {
  SvgCanvas canvas(mesh.points, "Voronoi cells by energy per area");
  const auto density = [&](std::size_t v) {
    return cell_area[v] > 0 ? cell_energy[v] / cell_area[v] : 0;
  };
  // The scale runs between percentiles: a square cell has an energy, too, and a few bad ones must
  // not make all others look alike.
  std::vector<double> sorted;
  for (std::size_t v = 0; v < cell_energy.size(); ++v) sorted.push_back(density(v));
  std::sort(sorted.begin(), sorted.end());
  const double low = sorted.empty() ? 0 : sorted[(sorted.size() - 1) * 2 / 100];
  const double range = sorted.empty() ? 0 : sorted[(sorted.size() - 1) * 98 / 100] - low;
  FilledCells filled(energy_colours);
  std::string outline;
  const auto polygons = cell_polygons(mesh, cells);
  for (std::size_t v = 0; v < polygons.size(); ++v) {
    std::string& path =
        filled.path(range > 0 && v < cell_energy.size() ? (density(v) - low) / range : 0);
    for (const std::vector<Vec2>& polygon : polygons[v]) {
      canvas.add_polygon(path, polygon);
      canvas.add_polygon(outline, polygon);
    }
  }
  filled.paint(canvas);
  canvas.paint(outline, stroke("#4a5a6a", 0.4));
  canvas.legend(energy_colours, "F/A, 2nd", "98th percentile");
  return canvas.finish();
}

std::string draw_crosses(const Fields& fields) {
  const TriMesh& mesh = fields.background;
  SvgCanvas canvas(mesh.points, "cross field");
  constexpr std::size_t most = 4000;  // crosses that still can be told apart
  const std::size_t stride = std::max<std::size_t>(1, mesh.points.size() / most);
  std::string crosses, walls;
  for (std::size_t v = 0; v < mesh.points.size(); v += stride) {
    const Vec2 arm = (0.8 * fields.h[v]) * axis_of(fields.z[v]);
    canvas.add_segment(crosses, mesh.points[v] - arm, mesh.points[v] + arm);
    canvas.add_segment(crosses, mesh.points[v] - perpendicular(arm),
                       mesh.points[v] + perpendicular(arm));
  }
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    if (mesh.twins[static_cast<std::size_t>(e)] != none) continue;
    canvas.add_segment(walls, mesh.points[static_cast<std::size_t>(mesh.origin(e))],
                       mesh.points[static_cast<std::size_t>(mesh.target(e))]);
  }
  canvas.paint(crosses, stroke("#2b7a78", 0.8));
  canvas.paint(walls, stroke("#101820", 1.6));
  for (const Singularity& s : fields.singularities)
    canvas.dot(s.position, 5, s.index > 0 ? blue : red);
  return canvas.finish();
}

}  // namespace lpq
