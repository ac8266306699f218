// See mesh_json.h.
#include "io/mesh/mesh_json.h"

#include "io/json_write.h"

namespace lpq {
namespace {

void append_faces(JsonWriter& json, const OutputMesh& mesh, int corners, const char* name,
                  const char* region_name) {
  json.begin_array(name);
  for (const Face& f : mesh.faces) {
    if (corner_count(f) != corners) continue;
    if (corners == 4) {
      json.tuple(f[0], f[1], f[2], f[3]);
    } else {
      json.tuple(f[0], f[1], f[2]);
    }
  }
  json.end_array();
  json.new_line();
  json.begin_array(region_name);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (corner_count(mesh.faces[f]) == corners) json.value(mesh.region[f]);
  json.end_array();
  json.new_line();
}

void append_edges(JsonWriter& json, const OutputMesh& mesh) {
  json.begin_array("edges");
  for (const OutputEdge& edge : mesh.edges) json.tuple(edge.a, edge.b);
  json.end_array();
  json.new_line();
  json.begin_array("edgeTag");
  for (const OutputEdge& edge : mesh.edges) json.value(edge.tag);
  json.end_array();
  json.new_line();
  json.begin_array("edgeRegions");
  for (const OutputEdge& edge : mesh.edges) json.tuple(edge.left, edge.right);
  json.end_array();
  json.new_line();
}

}  // namespace

std::string write_mesh_json(const OutputMesh& mesh) {
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  json.begin_array("points");
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Vec3 p = mesh.point(static_cast<Index>(v));
    if (mesh.in_space()) {
      json.tuple(p.x, p.y, p.z);
    } else {
      json.tuple(p.x, p.y);
    }
  }
  json.end_array();
  json.new_line();
  append_faces(json, mesh, 4, "quads", "quadRegion");
  append_faces(json, mesh, 3, "triangles", "triangleRegion");
  append_edges(json, mesh);
  json.begin_array("taggedPoints");
  for (const OutputPoint& point : mesh.tagged_points) json.tuple(point.point, point.tag);
  json.end_array();
  json.array("regions", mesh.regions);
  json.array("tags", mesh.tags);
  json.end_object();
  out += '\n';
  return out;
}

}  // namespace lpq
