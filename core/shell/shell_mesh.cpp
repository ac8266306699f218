#include "shell/shell_mesh.h"

namespace lpq {

std::vector<Index> sweep(ShellMesh& mesh, const std::vector<char>& kept) {
  std::vector<Index> number(mesh.points.size(), none);
  Index count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (!kept[v]) continue;
    mesh.points[count] = mesh.points[v];
    mesh.places[count] = mesh.places[v];
    mesh.pins[count] = mesh.pins[v];
    number[v] = count++;
  }
  mesh.points.resize(count);
  mesh.places.resize(count);
  mesh.pins.resize(count);
  std::size_t faces = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.faces[f][0] == none) continue;
    mesh.faces[faces] = mesh.faces[f];
    for (Index& v : mesh.faces[faces])
      if (v != none) v = number[v];
    mesh.face[faces++] = mesh.face[f];
  }
  mesh.faces.resize(faces);
  mesh.face.resize(faces);
  for (auto& edge : mesh.edges)
    for (Index& v : edge) v = number[v];
  return number;
}

}  // namespace lpq
