// See output.h.
#include "shell/output.h"

#include <algorithm>

#include "base/csr.h"

namespace lpq {
namespace {

/// Mesh edges of curves with the faces of the surface beside them.
struct CurveEdge {
  std::array<Index, 2> ends{none, none};   // the smaller first
  std::array<Index, 2> sides{none, none};  // left and right of the way from the first to the second
};

std::vector<CurveEdge> curve_edges(const ShellMesh& mesh) {
  std::vector<CurveEdge> edges;
  for (const auto& ends : mesh.edges) edges.push_back({ends, {none, none}});
  const auto before = [](const CurveEdge& edge, const std::array<Index, 2>& ends) {
    return edge.ends < ends;
  };
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Face& face = mesh.faces[f];
    for (int k = 0, n = corner_count(face); k < n; ++k) {
      const Index a = face[k], b = face[(k + 1) % n];
      if (mesh.is_free(a) || mesh.is_free(b)) continue;
      const std::array<Index, 2> ends{std::min(a, b), std::max(a, b)};
      const auto at = std::lower_bound(edges.begin(), edges.end(), ends, before);
      if (at == edges.end() || at->ends != ends) continue;
      // Where sheets meet there may be more than two faces, and two on one side.
      const int side = a < b ? 0 : 1;
      Index& slot = at->sides[at->sides[side] == none ? side : 1 - side];
      if (slot == none) slot = mesh.face[f];
    }
  }
  return edges;
}

/// Walks along the curves, from corner to corner and then around the closed ones.
class CurveWalk {
 public:
  CurveWalk(const ShellMesh& mesh, OutputMesh& out)
      : mesh_(mesh), out_(out), edges_(curve_edges(mesh)), walked_(edges_.size(), 0) {
    std::vector<std::vector<Index>> at(mesh.points.size());
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (const Index v : edges_[e].ends) at[v].push_back(static_cast<Index>(e));
    for (const auto& row : at) {
      edges_at_.values.insert(edges_at_.values.end(), row.begin(), row.end());
      edges_at_.end_row();
    }
  }

  void run() {
    for (const bool closed : {false, true})
      for (std::size_t e = 0; e < edges_.size(); ++e)
        for (const Index v : edges_[e].ends)
          if (!walked_[e] && (closed || is_end(v))) walk(static_cast<Index>(e), v);
  }

 private:
  bool is_end(Index v) const {
    return mesh_.pins[v] == Pin::corner || edges_at_.row(v).size() != 2;
  }

  void walk(Index e, Index from) {
    const std::size_t first = out_.edges.size();
    const auto tag = static_cast<Index>(out_.tags.size());
    out_.tags.push_back("curve " + std::to_string(tag + 1));
    for (;;) {
      walked_[e] = 1;
      const CurveEdge& edge = edges_[e];
      const int start = edge.ends[0] == from ? 0 : 1;
      const Index to = edge.ends[1 - start];
      out_.edges.push_back({.a = from,
                            .b = to,
                            .left = edge.sides[start],
                            .right = edge.sides[1 - start],
                            .tag = tag});
      if (is_end(to)) break;
      const auto row = edges_at_.row(to);
      e = row[0] == e ? row[1] : row[0];
      if (walked_[e]) break;
      from = to;
    }
    if (out_.edges[first].left == none) turn(first);
  }

  /// The faces of a border lie on its left.
  void turn(std::size_t first) {
    std::reverse(out_.edges.begin() + static_cast<std::ptrdiff_t>(first), out_.edges.end());
    for (std::size_t e = first; e < out_.edges.size(); ++e) {
      std::swap(out_.edges[e].a, out_.edges[e].b);
      std::swap(out_.edges[e].left, out_.edges[e].right);
    }
  }

  const ShellMesh& mesh_;
  OutputMesh& out_;
  std::vector<CurveEdge> edges_;
  std::vector<char> walked_;  // #edges
  Csr<Index> edges_at_;       // #V
};

}  // namespace

std::vector<std::string> face_names(const ShellOutcome& outcome) {
  std::vector<Index> faces_of_group(outcome.group_names.size(), 0);
  for (const Index group : outcome.face_group)
    if (group != none) ++faces_of_group[group];
  std::vector<std::string> names;
  for (const Index group : outcome.face_group) {
    std::string name = "face " + std::to_string(names.size() + 1);
    if (group != none && !outcome.group_names[group].empty())
      name = outcome.group_names[group] + (faces_of_group[group] > 1 ? " " + name : "");
    names.push_back(std::move(name));
  }
  return names;
}

OutputMesh shell_output(const ShellOutcome& outcome) {
  const ShellMesh& mesh = outcome.mesh;
  OutputMesh out;
  for (const Vec3 p : mesh.points) {
    out.points.push_back({p.x, p.y});
    out.z.push_back(p.z);
  }
  out.faces = mesh.faces;
  out.region = mesh.face;
  out.regions = face_names(outcome);
  CurveWalk(mesh, out).run();
  return out;
}

}  // namespace lpq
