// Cavities that were refused, so that they are not tried again for nothing: those around the
// corners of a face overlap, and the faces of a needle are tried again and again (of the patterns
// smoothed in a surface of many needles four in five were).
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "cleanup/quad_topology.h"

namespace lpq {

/// The answer to a cavity depends on its faces, in their order, and on all faces at their corners:
/// as long as these are what they were it stays the same.
class Refusals {
 public:
  /// What was noted with the cavity, if it was and nothing has changed around it since; or nullptr.
  const std::vector<Vec2>* find(const QuadTopology& mesh, std::span<const Index> faces) const;
  /// `asked`: where the fields were asked before it was refused.
  void note(std::span<const Index> faces, std::vector<Vec2> asked);
  /// After an edit: `vertices` have moved or have other faces; new faces have none but these.
  void forget_around(const QuadTopology& mesh, std::span<const Index> vertices);

 private:
  struct Refusal {
    std::int64_t edits = 0;  // before it
    std::vector<Vec2> asked;
  };

  std::map<std::vector<Index>, Refusal> noted_;  // by faces
  std::vector<std::int64_t> changed_;            // #V or fewer: the last edit near the vertex
  std::int64_t edits_ = 0;
};

}  // namespace lpq
