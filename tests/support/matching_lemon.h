// LEMON's maximum weighted perfect matching as an independent oracle. LEMON 1.3 does not compile as
// C++20, hence a translation unit of its own and an interface of plain arrays.
#pragma once

#include <cstdint>

namespace lpq {
namespace test {

struct LemonAnswer {
  bool available;  // false: built without LEMON
  bool perfect;
  std::int64_t cost;
};

/// Edge i joins ends[2 i] and ends[2 i + 1].
LemonAnswer lemon_matching(int node_count, int edge_count, const int* ends,
                           const std::int64_t* costs);

}  // namespace test
}  // namespace lpq
