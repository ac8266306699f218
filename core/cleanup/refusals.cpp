// See refusals.h.
#include "cleanup/refusals.h"

#include <algorithm>
#include <utility>

namespace lpq {
namespace {

// Repeats come soon; a large mesh need not remember them all.
constexpr std::size_t most_noted = 1 << 14;

}  // namespace

const std::vector<Vec2>* Refusals::find(const QuadTopology& mesh,
                                        std::span<const Index> faces) const {
  const auto at = noted_.find({faces.begin(), faces.end()});
  if (at == noted_.end()) return nullptr;
  const auto unchanged = [&](Index v) {
    return v == none || v >= static_cast<Index>(changed_.size()) || changed_[v] <= at->second.edits;
  };
  const bool holds = std::all_of(faces.begin(), faces.end(), [&](Index f) {
    return std::all_of(mesh.face(f).begin(), mesh.face(f).end(), unchanged);
  });
  return holds ? &at->second.asked : nullptr;
}

void Refusals::note(std::span<const Index> faces, std::vector<Vec2> asked) {
  if (noted_.size() >= most_noted) noted_.clear();
  noted_[{faces.begin(), faces.end()}] = {edits_, std::move(asked)};
}

// Of faces that are gone all corners are among the vertices, or gone too.
void Refusals::forget_around(const QuadTopology& mesh, std::span<const Index> vertices) {
  ++edits_;
  changed_.resize(mesh.vertex_count(), 0);
  for (const Index v : vertices) {
    changed_[v] = edits_;
    for (const Index f : mesh.faces_of(v))
      for (const Index w : mesh.face(f))
        if (w != none) changed_[w] = edits_;
  }
}

}  // namespace lpq
