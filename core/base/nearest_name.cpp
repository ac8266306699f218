// See nearest_name.h.
#include "base/nearest_name.h"

#include <algorithm>
#include <vector>

namespace lpq {
namespace {

/// Optimal string alignment distance; words here are a dozen letters.
int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t columns = b.size() + 1;
  std::vector<int> cost((a.size() + 1) * columns);
  const auto at = [&](std::size_t i, std::size_t j) -> int& { return cost[i * columns + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        at(i, j) = static_cast<int>(i + j);
        continue;
      }
      const int change = a[i - 1] == b[j - 1] ? 0 : 1;
      at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
      }
    }
  }
  return at(a.size(), b.size());
}

}  // namespace

std::string nearest_name(std::string_view word, std::span<const std::string> candidates) {
  constexpr std::size_t longest = 60;  // nobody means an option by a longer word
  if (word.size() > longest) return {};
  int best = 1 + static_cast<int>(word.size()) / 3;
  std::string nearest;
  for (const std::string& candidate : candidates) {
    int edits = edit_distance(word, candidate);
    // A beginning is meant as well: --keep for --keep-boundary.
    if (word.size() > 3 && candidate.substr(0, word.size()) == word) edits = std::min(edits, 1);
    if (edits > best || (edits == best && !nearest.empty())) continue;
    best = edits;
    nearest = candidate;
  }
  return nearest;
}

}  // namespace lpq
