// See patch.h.
#include "shell/shape/patch.h"

#include <algorithm>
#include <numeric>

#include "base/sort_numbers.h"
#include "base/sort_unique.h"

namespace lpq {
namespace {

/// Edges on features and borders, in the patch's numbers.
void add_walls(const ShellMesh& mesh, ShapePatch& patch) {
  for (const Face& face : patch.mesh.faces)
    for (int k = 0; k < corner_count(face); ++k) {
      const Index a = face[k], b = face[(k + 1) % corner_count(face)];
      const std::array<Index, 2> ends{std::min(a, b), std::max(a, b)};
      const std::array<Index, 2> whole{patch.vertex[ends[0]], patch.vertex[ends[1]]};
      if (std::binary_search(mesh.edges.begin(), mesh.edges.end(), whole))
        patch.mesh.edges.push_back(ends);
    }
  sort_unique(patch.mesh.edges);
}

}  // namespace

Csr<Index> faces_at_vertices(const ShellMesh& mesh) {
  return csr_from<Index>(mesh.points.size(), [&](auto&& emit) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      for (const Index v : mesh.faces[f])
        if (v != none) emit(v, static_cast<Index>(f));
  });
}

FaceStars::FaceStars(const ShellMesh& mesh)
    : rows_(faces_at_vertices(mesh)),
      no_faces_(rows_.rows()),
      row_(mesh.points.size()),
      face_count_(mesh.faces.size()) {
  rows_.end_row();
  std::iota(row_.begin(), row_.end(), 0);
}

void FaceStars::update(const ShellMesh& mesh, const ShapePatch& patch) {
  row_.resize(mesh.points.size(), no_faces_);
  std::vector<std::array<Index, 2>> at;  // vertex, face
  for (const Index v : patch.vertex) {
    if (v == none) continue;
    for (const Index f : row(v))
      if (mesh.faces[f][0] != none) at.push_back({v, f});
    row_[v] = no_faces_;
  }
  for (; face_count_ < mesh.faces.size(); ++face_count_)
    for (const Index v : mesh.faces[face_count_])
      if (v != none) at.push_back({v, static_cast<Index>(face_count_)});
  sort_unique(at);
  for (std::size_t i = 0; i < at.size(); ++i) {
    rows_.values.push_back(at[i][1]);
    if (i + 1 < at.size() && at[i + 1][0] == at[i][0]) continue;
    row_[at[i][0]] = rows_.rows();
    rows_.end_row();
  }
}

std::vector<Index> faces_around(const ShellMesh& mesh, const FaceStars& stars, Index f, int rings) {
  std::vector<Index> all{f};
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t size = all.size();
    for (std::size_t i = 0; i < size; ++i)
      for (const Index v : mesh.faces[all[i]])
        if (v != none) all.insert(all.end(), stars.row(v).begin(), stars.row(v).end());
    sort_unique(all);
  }
  return all;
}

ShapePatch take_patch(const ShellMesh& mesh, const std::vector<VertexRole>& roles,
                      const FaceStars& stars, std::vector<Index> faces) {
  ShapePatch patch;
  patch.faces = std::move(faces);
  for (const Index f : patch.faces)
    for (int k = 0; k < corner_count(mesh.faces[f]); ++k) patch.vertex.push_back(mesh.faces[f][k]);
  sort_unique(patch.vertex);
  for (const Index v : patch.vertex) {
    patch.mesh.points.push_back(mesh.points[v]);
    patch.mesh.places.push_back(mesh.places[v]);
    patch.mesh.pins.push_back(mesh.pins[v]);
    patch.roles.push_back(roles[v]);
    const auto star = stars.row(v);
    const bool inside = std::all_of(star.begin(), star.end(), [&](Index f) {
      return std::binary_search(patch.faces.begin(), patch.faces.end(), f);
    });
    patch.rim.push_back(!inside);
    if (!inside) patch.roles.back().kind = VertexRole::Kind::fixed;
  }
  for (const Index f : patch.faces) {
    Face face{none, none, none, none};
    for (int k = 0; k < corner_count(mesh.faces[f]); ++k)
      face[k] = index_of(mesh.faces[f][k], patch.vertex);
    patch.mesh.faces.push_back(face);
    patch.mesh.face.push_back(mesh.face[f]);
  }
  add_walls(mesh, patch);
  return patch;
}

namespace {

void put_positions(const ShapePatch& patch, ShellMesh& mesh, std::vector<VertexRole>& roles) {
  for (std::size_t i = 0; i < patch.vertex.size(); ++i) {
    if (patch.rim[i]) continue;
    const Index v = patch.vertex[i];
    mesh.points[v] = patch.mesh.points[i];
    mesh.places[v] = patch.mesh.places[i];
    roles[v].on_track.s = patch.roles[i].on_track.s;
  }
}

}  // namespace

void put_back(const ShapePatch& patch, ShellMesh& mesh, std::vector<VertexRole>& roles) {
  ShapePatch whole = patch;
  for (std::size_t i = 0; i < whole.vertex.size(); ++i) {
    if (whole.vertex[i] != none) continue;
    whole.vertex[i] = static_cast<Index>(mesh.points.size());
    mesh.points.push_back({});
    mesh.places.push_back({});
    mesh.pins.push_back(Pin::free);
    roles.push_back({});
  }
  put_positions(whole, mesh, roles);
  if (!patch.changed) return;
  for (const Index f : whole.faces) mesh.faces[f] = {none, none, none, none};
  for (std::size_t i = 0; i < whole.mesh.faces.size(); ++i) {
    Face face = whole.mesh.faces[i];
    for (Index& v : face)
      if (v != none) v = whole.vertex[v];
    mesh.faces.push_back(face);
    mesh.face.push_back(whole.mesh.face[i]);
  }
}

void sweep_unused(ShellMesh& mesh, std::vector<VertexRole>& roles) {
  std::vector<char> used(mesh.points.size(), 0);
  for (const Face& face : mesh.faces)
    for (const Index v : face)
      if (v != none) used[v] = 1;
  const std::vector<Index> number = sweep(mesh, used);
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != none) roles[number[v]] = roles[v];
  roles.resize(mesh.points.size());
}

}  // namespace lpq
