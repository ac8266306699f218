// Ragged arrays in two flat ones: row i is values[offsets[i] .. offsets[i+1]).
#pragma once

#include <algorithm>
#include <numeric>
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

/// Rows of entries that come in any order: each(emit) calls emit(row, value) for all of them, and
/// is called twice, first to count. Within a row they stay in the order of these calls. O(#entries)
/// and no memory but the arrays, whose capacity is used again.
template <class T, class Each>
void fill_csr(Csr<T>& csr, std::size_t rows, const Each& each) {
  std::vector<Index>& offsets = csr.offsets;
  offsets.assign(rows + 1, 0);
  each([&](Index row, const T&) { ++offsets[row]; });
  std::exclusive_scan(offsets.begin(), offsets.end(), offsets.begin(), Index{0});
  csr.values.resize(static_cast<std::size_t>(offsets.back()));
  // Each row's offset moves on to its end, where the next row starts.
  each([&](Index row, const T& value) { csr.values[offsets[row]++] = value; });
  std::copy_backward(offsets.begin(), offsets.end() - 1, offsets.end());
  offsets.front() = 0;
}

template <class T, class Each>
Csr<T> csr_from(std::size_t rows, const Each& each) {
  Csr<T> csr;
  fill_csr(csr, rows, each);
  return csr;
}

/// Row g: the i with row_of[i] = g, ascending.
inline Csr<Index> members_of(std::span<const Index> row_of, std::size_t rows) {
  return csr_from<Index>(rows, [&](auto&& emit) {
    for (Index i = 0; i < static_cast<Index>(row_of.size()); ++i) emit(row_of[i], i);
  });
}

}  // namespace lpq
