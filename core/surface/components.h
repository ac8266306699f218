// Triangles that hang together: the faces of a surface between its features, the parts of a face.
#pragma once

#include <span>
#include <vector>

#include "base/index.h"

namespace lpq {

struct Components {
  std::vector<Index> of_triangle;  // #T  numbered by their first triangle
  Index count = 0;
};

/// Connected without crossing a barrier: a half-edge without a twin, or one marked in `barrier`
/// (either side; empty for none).
Components components_of(std::span<const Index> twins, std::span<const char> barrier = {});

}  // namespace lpq
