// Indices in the order of what they stand for. One sort for every such order, called through a
// reference: each kind of comparison compiled into a sort of its own is 1.6 KB of WebAssembly.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "base/function_ref.h"
#include "base/index.h"

namespace lpq {

/// Of two equals the smaller number comes first, whatever the library's sort would make of them.
using ComesBefore = FunctionRef<bool(Index, Index)>;

/// O(n log n) calls. Where sorting takes time that shows, std::sort inlines them.
void sort_numbers(std::span<Index> numbers, ComesBefore before);

/// 0 .. count - 1.
std::vector<Index> sorted_numbers(std::size_t count, ComesBefore before);

/// Where i is in `ascending`, which holds it: numbers of a whole to those of a part.
Index index_of(Index i, std::span<const Index> ascending);

/// Values by the order of their numbers, where what a sort of their own would gain does not show;
/// equals stay in their order.
template <class T, class Before = std::less<>>
void sort_values(std::vector<T>& values, const Before& before = {}) {
  std::vector<T> sorted;
  sorted.reserve(values.size());
  const auto by_value = [&](Index i, Index j) { return before(values[i], values[j]); };
  for (const Index k : sorted_numbers(values.size(), by_value))
    sorted.push_back(std::move(values[k]));
  values = std::move(sorted);
}

}  // namespace lpq
