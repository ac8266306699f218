#include "patches/likeness.h"

#include <algorithm>

#include "base/sort_numbers.h"

namespace lpq {
namespace {

struct HalfEdge {
  Index from = none, to = none, face = none;
};

bool operator<(const HalfEdge& a, const HalfEdge& b) {
  return a.from != b.from ? a.from < b.from : a.to < b.to;
}

std::vector<HalfEdge> half_edges(std::span<const Face> faces) {
  std::vector<HalfEdge> edges;
  edges.reserve(4 * faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 4; ++k)
      edges.push_back({faces[f][k], faces[f][(k + 1) & 3], static_cast<Index>(f)});
  sort_values(edges);
  return edges;
}

// Walks from the rim inwards over the faces of both and gives every vertex of the filling the one
// of the mesh that stands in its place, until one gets two.
class Comparison {
 public:
  Comparison(const Filling& filling, const PatchOutline& outline, const QuadTopology& mesh)
      : filling_(filling),
        mesh_(mesh),
        edges_(half_edges(filling.faces)),
        place_(filling.points.size(), none),
        seen_(filling.faces.size(), 0) {
    std::copy(outline.loop.begin(), outline.loop.end(), place_.begin());
  }

  bool run() {
    enter(0, 1);
    while (!waiting_.empty() && alike_) {
      const HalfEdge edge = waiting_.back();
      waiting_.pop_back();
      compare(edge);
      const Face& face = filling_.faces[edge.face];
      for (int k = 0; k < 4 && alike_; ++k) enter(face[(k + 1) & 3], face[k]);
    }
    return alike_;
  }

 private:
  // The face beyond from -> to, if it is new.
  void enter(Index from, Index to) {
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), HalfEdge{from, to, none});
    if (found == edges_.end() || found->from != from || found->to != to || seen_[found->face])
      return;
    seen_[found->face] = 1;
    waiting_.push_back(*found);
  }

  void compare(const HalfEdge& edge) {
    const Face& face = filling_.faces[edge.face];
    const Index from = place_[edge.from], other = mesh_.face_with_edge(from, place_[edge.to]);
    alike_ = other != none;
    for (Index step = 0; step < 4 && alike_; ++step) {
      const Index v = face[(corner_of(face, edge.from) + step) & 3];
      const Index w = mesh_.face(other)[(corner_of(mesh_.face(other), from) + step) & 3];
      if (place_[v] == none) place_[v] = w;
      alike_ = place_[v] == w;
    }
  }

  const Filling& filling_;
  const QuadTopology& mesh_;
  std::vector<HalfEdge> edges_;
  std::vector<Index> place_;  // #V of the filling
  std::vector<char> seen_;    // #F of the filling
  std::vector<HalfEdge> waiting_;
  bool alike_ = true;
};

}  // namespace

bool is_like_patch(const Filling& filling, const PatchOutline& outline, const QuadTopology& mesh) {
  return Comparison(filling, outline, mesh).run();
}

}  // namespace lpq
