#include "base/sort_numbers.h"

#include <algorithm>
#include <numeric>

namespace lpq {

void sort_numbers(std::span<Index> numbers, ComesBefore before) {
  std::sort(numbers.begin(), numbers.end(),
            [&](Index i, Index j) { return before(i, j) || (i < j && !before(j, i)); });
}

std::vector<Index> sorted_numbers(std::size_t count, ComesBefore before) {
  std::vector<Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  sort_numbers(numbers, before);
  return numbers;
}

Index index_of(Index i, std::span<const Index> ascending) {
  const auto at = std::lower_bound(ascending.begin(), ascending.end(), i);
  return static_cast<Index>(at - ascending.begin());
}

}  // namespace lpq
