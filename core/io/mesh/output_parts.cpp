// See output_parts.h.
#include "io/mesh/output_parts.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "io/number.h"
#include "mesh/quality.h"
#include "shell/quality.h"

namespace lpq {

void drop_unused_points(OutputMesh& mesh) {
  std::vector<Index> number(mesh.points.size(), none);
  for (const Face& face : mesh.faces)
    for (int k = 0; k < corner_count(face); ++k) number[face[k]] = 0;
  std::vector<Vec2> points;
  std::vector<double> z;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == none) continue;
    number[v] = static_cast<Index>(points.size());
    points.push_back(mesh.points[v]);
    if (mesh.in_space()) z.push_back(mesh.z[v]);
  }
  mesh.points = std::move(points);
  mesh.z = std::move(z);
  for (Face& face : mesh.faces)
    for (int k = 0, n = corner_count(face); k < n; ++k) face[k] = number[face[k]];
  std::vector<OutputEdge> edges;
  for (OutputEdge edge : mesh.edges) {
    edge.a = number[edge.a];
    edge.b = number[edge.b];
    if (edge.a != none && edge.b != none) edges.push_back(edge);
  }
  mesh.edges = std::move(edges);
  std::vector<OutputPoint> tagged;
  for (OutputPoint point : mesh.tagged_points) {
    point.point = number[point.point];
    if (point.point != none) tagged.push_back(point);
  }
  mesh.tagged_points = std::move(tagged);
}

void drop_flat_heights(OutputMesh& mesh) {
  if (std::all_of(mesh.z.begin(), mesh.z.end(), [](double z) { return z == 0; })) mesh.z = {};
}

std::string region_label(const OutputMesh& mesh, Index region) {
  const auto r = static_cast<std::size_t>(region);
  if (r < mesh.regions.size() && !mesh.regions[r].empty()) return mesh.regions[r];
  if (mesh.regions.size() <= 1) return "domain";
  std::string label = "region ";
  append_integer(label, std::int64_t{region} + 1);
  return label;
}

double output_eta(const OutputMesh& mesh, const Face& face) {
  if (!mesh.in_space()) return face_eta(mesh.points, face);
  if (corner_count(face) == 3) return 0;
  return quad_eta(mesh.point(face[0]), mesh.point(face[1]), mesh.point(face[2]),
                  mesh.point(face[3]));
}

}  // namespace lpq
