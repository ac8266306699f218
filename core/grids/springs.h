// Springs at rest: a harmonic map with weights of one.
#pragma once

#include <vector>

#include "geometry/vec.h"
#include "numerics/sparse.h"

namespace lpq {

/// Vertices are fixed or move with a body, which only shifts them. Springs pull without a length of
/// their own.
class Springs {
 public:
  /// `body`: of each vertex, none if it is fixed. #V. `place`: of the fixed ones; of the others,
  /// counted from where their body is. #V
  Springs(std::vector<Index> body, std::vector<Vec2> place, Index bodies);

  /// `jump`: to be added to places of w where v is.
  void add(Index v, Index w, Vec2 jump = {});
  /// Where the bodies are at rest; empty if some hang on nothing that is fixed. Cost that of a
  /// sparse factorisation.
  std::vector<Vec2> rest() const;

 private:
  void pull(Index v, Index w, Vec2 jump);

  std::vector<Index> body_;
  std::vector<Vec2> place_;
  std::vector<Triplet> entries_;
  std::vector<double> load_;  // 2 #bodies, all x first
};

}  // namespace lpq
