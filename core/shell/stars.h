// Which vertices of a shell mesh lie in each triangle of the surface, and which faces meet at each
// vertex, while windows are replaced: lists that grow at their heads.
#pragma once

#include <vector>

#include "shell/shell_mesh.h"

namespace lpq {

class ShellStars {
 public:
  ShellStars(const ShellMesh& shell, Index triangle_count);

  /// Takes in vertices and faces that were appended since the last call. Cost O(#new).
  void update(const ShellMesh& shell);

  /// Latest first. Vertices that died are still visited.
  template <class Visit>
  void for_each_vertex_in(Index triangle, Visit&& visit) const {
    for (Index v = last_in_[triangle]; v != none; v = vertex_before_[v]) visit(v);
  }
  /// Latest first. A face that died is still visited, also at a vertex that it had.
  template <class Visit>
  void for_each_face_at(Index vertex, Visit&& visit) const {
    for (Index c = last_at_[vertex]; c != none; c = corner_before_[c]) visit(c / 4);
  }

 private:
  std::vector<Index> last_in_, last_at_;  // #T vertex, #V corner 4 f + k: heads of the lists
  std::vector<Index> vertex_before_;      // #V  in the same triangle
  std::vector<Index> corner_before_;      // 4 #F  at the same vertex
};

}  // namespace lpq
