// One guarded edit of the connectivity: take out a few faces that form a disk (the cavity), fill
// the hole with another pattern (disk_patterns.h), smooth the neighbourhood, and keep the result
// only if it is better. Every classical local operation is a case of it:
//
//   rotation                diamond collapse          vertex split            boundary repair
//   +---+---+   +---+---+   +---+---+    +-------+    +---+---+   +---+---+   +---+    +---+
//   |   |   |   | \     |   |   | \ |    |       |    |       |   |   | \ |   |   |    | \ |
//   |   |   | > |   \   |   +---+  .+ >  +       +    +   +   + > +---+  .+   |   | >  |  .+
//   |   |   |   |     \ |   |   | / |    |       |    |       |   |   | / |   |   |    | / |
//   +---+---+   +---+---+   +---+---+    +-------+    +---+---+   +---+---+   ~~~~~    ~~~~~
//   2 faces: 2 faces        fewer faces               more faces              (wall below)
//
// Better means: fewer invalid (then: flat) faces, or no more of them and less irregularity, where
// the mean shape may pay for the regularity at a fixed rate and the worst eta of the neighbourhood
// does not fall below min(its old value, a floor). Cost: constant per cavity.
#pragma once

#include "cleanup/disk_patterns.h"
#include "cleanup/ideal_valence.h"
#include "cleanup/quad_topology.h"
#include "cleanup/refusals.h"
#include "cleanup/untangle.h"
#include "field/field.h"

namespace lpq {

struct RefillOptions {
  double credit = 0.6;     // of one unit of irregularity, in units of the sum of 1 - eta
  double worst_eta = 0.3;  // a neighbourhood better than this may fall to it
  Index tries = 3;         // patterns smoothed and compared per cavity
  bool repair = false;     // accept more irregularity where it makes faces valid
  double flat_eta = 0;     // with repair: or where it lifts faces above this
  Untangling untangling = Untangling::quick;  // spent on untangling each try
};

struct RefillResult {
  bool accepted = false;
  Index faces_before = 0, faces_after = 0;
  bool boundary = false;        // a fixed vertex changed its number of quads
  std::vector<Index> vertices;  // around which something changed
};

/// From its first refill on nothing else may edit the mesh.
class Refiller {
 public:
  Refiller(QuadTopology& mesh, const IdealValence& ideal, const Fields& fields,
           DiskPatterns& patterns, const RefillOptions& options);

  /// The faces must be distinct and alive. Not accepted: anything but a disk of quads without
  /// fixed vertices or walls inside.
  RefillResult refill(std::span<const Index> faces);

 private:
  struct Trial;
  struct Plan {
    const DiskPattern* pattern = nullptr;
    double weight = 0;
  };

  double size_at(Vec2 p) const;
  RefillResult try_plans(std::span<const Index> faces);
  bool outline(std::span<const Index> faces);
  void weigh_loop(std::span<const Index> faces);
  void choose_plans(std::vector<Plan>& plans);
  void collect_ring(std::span<const Index> faces);
  void take_vertices(Trial& trial) const;
  void fill_hole(const DiskPattern& pattern, Trial& trial) const;
  Trial build(const Plan& plan) const;
  void relax(Trial& trial) const;
  bool better(const Trial& trial, const Plan& plan) const;
  RefillResult commit(std::span<const Index> faces, const Plan& plan, const Trial& trial);

  QuadTopology& mesh_;
  const IdealValence& ideal_;
  const Fields& fields_;
  DiskPatterns& patterns_;
  RefillOptions options_;
  mutable Index hint_ = none;
  Refusals refusals_;

  // Of the cavity at hand.
  mutable std::vector<Vec2> asked_;                       // where the fields were
  std::vector<Index> loop_;                               // counter-clockwise
  std::vector<std::array<double, largest_loop>> weight_;  // of loop vertex i with c quads inside
  std::vector<Index> ring_;                               // faces outside that may change shape
  double old_weight_ = 0;
  Index old_invalid_ = 0, old_flat_ = 0;
  double old_loss_ = 0, old_worst_ = 1;  // sum of 1 - eta, least eta: cavity and ring
};

}  // namespace lpq
