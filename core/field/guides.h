// Strokes of the caller's that the crosses follow. A drawn stroke shakes: what counts is the
// direction of chords as long as the mesh size there, which is all that a mesh could follow anyway.
#pragma once

#include <span>
#include <vector>

#include "domain/box_tree.h"
#include "domain/domain.h"
#include "field/background.h"
#include "geometry/vec.h"
#include "mesh/tri_mesh.h"

namespace lpq {

struct Chord {
  Vec2 from, to;  // different
};

/// The guides (unit frame, finite) cut into chords of about the size at their starts, which is read
/// off a mesh of the domain with sizes at its vertices. What lies outside the domain is left out.
/// Cost O(points + chords).
std::vector<Chord> chords_of(std::span<const DomainInput::Guide> guides, const TriMesh& mesh,
                             std::span<const double> h);

/// Numbers of the guides that have no chord: no part of the domain follows them. Cost as above.
std::vector<Index> guides_outside(std::span<const DomainInput::Guide> guides, const TriMesh& mesh,
                                  std::span<const double> h);

/// Places along the chords where the background must be as fine as they are.
std::vector<Source> sources_along(std::span<const Chord> chords);

/// Chords that meet given segments, added up: the sum of their crosses z = e^{4 i theta}, and how
/// many they are.
class ChordTree {
 public:
  explicit ChordTree(std::span<const Chord> chords);
  struct Sum {
    Vec2 z;
    Index count = 0;
  };
  Sum meeting(Vec2 a, Vec2 b) const;

 private:
  std::span<const Chord> chords_;
  BoxTree tree_;
};

}  // namespace lpq
