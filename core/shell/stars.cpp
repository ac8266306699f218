#include "shell/stars.h"

#include <utility>

namespace lpq {

ShellStars::ShellStars(const ShellMesh& shell, Index triangle_count)
    : last_in_(triangle_count, none) {
  update(shell);
}

void ShellStars::update(const ShellMesh& shell) {
  const auto vertices = static_cast<Index>(shell.points.size());
  for (auto v = static_cast<Index>(vertex_before_.size()); v < vertices; ++v) {
    const Index t = shell.places[v].triangle;
    vertex_before_.push_back(t == none ? none : std::exchange(last_in_[t], v));
    last_at_.push_back(none);
  }
  const auto corners = static_cast<Index>(4 * shell.faces.size());
  for (auto c = static_cast<Index>(corner_before_.size()); c < corners; ++c) {
    const Index v = shell.faces[c / 4][c % 4];
    corner_before_.push_back(v == none ? none : std::exchange(last_at_[v], c));
  }
}

}  // namespace lpq
