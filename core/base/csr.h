// Ragged arrays in two flat ones: row i is values[offsets[i] .. offsets[i+1]).
#pragma once

#include <span>
#include <vector>

#include "base/index.h"

namespace lpq {

template <class T>
struct Csr {
  std::vector<Index> offsets{0};  // #rows + 1
  std::vector<T> values;

  Index rows() const { return static_cast<Index>(offsets.size()) - 1; }
  std::span<const T> row(Index i) const {
    return {values.data() + offsets[i], static_cast<std::size_t>(offsets[i + 1] - offsets[i])};
  }
  std::span<T> row(Index i) {
    return {values.data() + offsets[i], static_cast<std::size_t>(offsets[i + 1] - offsets[i])};
  }
  void end_row() { offsets.push_back(static_cast<Index>(values.size())); }
};

}  // namespace lpq
