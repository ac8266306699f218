// Independent pieces of work, shared out among threads where there are threads.
#pragma once

#include <cstddef>

#include "base/function_ref.h"

namespace lpq {

/// As many as the machine runs at once, at least 1; 1 where there are none.
int machine_threads();

/// Calls work(piece, thread) once for every piece 0 .. count-1, in this order but at the same time
/// on up to `threads` threads (fewer where the system starts no more), 0 .. threads-1; thread 0 is
/// the caller's. What a piece writes must be its own, so that the results do not depend on the
/// threads. When there is no piece left for it the caller's thread calls idle() now and then until
/// the others are ready. What work throws for want of memory, on whichever thread, is thrown here
/// once all have stopped; pieces that no thread had begun are left out.
void share_out(std::size_t count, int threads, FunctionRef<void(std::size_t, int)> work,
               FunctionRef<void()> idle);

}  // namespace lpq
