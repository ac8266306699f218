// Patch remeshing: convex patches of the quad mesh that hold irregular vertices are refilled with
// fewer of them, or with better shapes. Non-local clean-up in the sense of [Bunin 2006]; patterns
// as in [Takayama et al. 2014], cut in two where one pattern does not fit.
//
// One figure judges every change: E + credit W, with E the shape energy of all faces (1 - eta under
// a floor, and edge lengths against the size field; shape_energy.h) and W the irregularity. It
// falls with every accepted refill, so the process ends.
//
// A remesher is a copyable value that advances seed by seed. Fixed vertices never move, walls are
// never crossed.
#pragma once

#include <cstdint>

#include "base/rng.h"
#include "cleanup/ideal_valence.h"
#include "cleanup/shape_energy.h"
#include "field/field.h"

namespace lpq {

class Refitter;
class Search;

/// A pass tries patches at every irregular vertex, smallest first, and keeps what is better. With a
/// temperature it tries random patches at random irregular vertices instead and also keeps some
/// that are worse (simulated annealing).
struct PatchPass {
  Index largest = 200;     // faces of a patch
  double temperature = 0;  // at the start, in units of the figure of merit; it falls to a part
  double trials = 0;       // per irregular vertex
};

struct PatchOptions {
  double credit = 6;        // of one unit of irregularity, in units of the energy
  EtaEnergyOptions energy;  // what the final smoothing minimises
  double worst_eta = 0.3;   // a neighbourhood better than this may fall to it
  int plans = 6;            // fillings tried per patch
  int rings = 1;            // of vertices around a patch that give way to it
  std::vector<PatchPass> passes{{20}, {60}, {200}};
  int smoothing = 40;            // iterations after each pass
  bool takes_triangles = false;  // patches with an even number of them are refilled, too
  std::uint64_t seed = 1;
};

struct PatchStats {
  Index tried = 0, refilled = 0;
};

class PatchRemesher {
 public:
  /// `fields` must outlive the remesher.
  PatchRemesher(QuadMesh mesh, const Fields& fields, const PatchOptions& options = {});

  /// Looks at up to `seeds` irregular vertices; at the end of a pass, smooths. False when all
  /// passes are done.
  bool step(int seeds);
  bool done() const { return pass_ == options_.passes.size(); }
  /// The search ended early, because patches hardly ever helped.
  bool gave_up() const { return gave_up_; }
  const PatchStats& stats() const { return stats_; }
  /// The mesh as it is.
  QuadMesh mesh() const;

 private:
  void begin_pass();
  void end_pass();
  void refit_in_order(Refitter& refitter, Search& search, int seeds);
  void refit_at_random(Refitter& refitter, Search& search, int trials);
  void note_changes(const Refitter& refitter);

  QuadTopology mesh_;
  IdealValence ideal_;
  const Fields* fields_;
  PatchOptions options_;
  std::vector<Index> queue_;
  std::vector<char> queued_;  // #V
  std::size_t next_ = 0, pass_ = 0;
  bool gave_up_ = false;
  Index tried_ = 0, refilled_ = 0;     // in this pass
  Index trials_ = 0, all_trials_ = 0;  // of a random pass: left, and at its start
  Rng rng_;
  PatchStats stats_;
};

}  // namespace lpq
