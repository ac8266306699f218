// A run that somebody looks at: it advances in ticks, can go back to any of them, and can be
// copied. Going back is replaying from a checkpoint, which is exact because every stage is
// deterministic.
#pragma once

#include <utility>
#include <vector>

#include "pipeline/mesher.h"

namespace lpq {

class Session {
 public:
  enum class Memory {
    everything,  // checkpoints to go back to, and the trace
    nothing,     // forwards only: no more memory than a batch run
  };

  /// Errors: those of Mesher::start.
  static Result<Session> start(const DomainInput& input, const Options& options = {},
                               const UserFields& user = {}, Memory memory = Memory::everything);

  /// Up to n ticks, each one Mesher::step(): an iteration of L_p, a few patches, some iterations of
  /// smoothing, a whole stage, or a whole mesh to compare with. Stops at the end.
  /// Errors: those of Mesher::step; the run is over then, but restore() still leads back.
  Result<Stage> step(int n = 1);
  /// Goes to the state after k ticks, forwards or backwards; the same values as the first time.
  /// Cost: backwards a copy and at most a sixth of the ticks made so far, forwards the ticks
  /// between. Errors: bad_option when k < 0 or there is no memory of it, those of step.
  Result<Stage> restore(int k);

  int ticks() const { return ticks_; }
  const Mesher& mesher() const { return mesher_; }

 private:
  Session(Mesher mesher, Memory memory);
  void remember();

  Mesher mesher_;
  int ticks_ = 0;
  Problem failure_;
  // States after some tick, ascending; at most max_checkpoints: every `stride_` ticks. Empty: none
  // are kept.
  std::vector<std::pair<int, Mesher>> checkpoints_;
  int stride_ = 1;
};

}  // namespace lpq
