// LPQ_ASSERT states what the code itself guarantees; a failure is a bug of ours, never a bad input.
// On in Debug, tests and fuzzing (LPQ_CHECKS); otherwise it costs nothing.
#pragma once

#ifdef LPQ_CHECKS
#include <cstdio>
#include <cstdlib>
#define LPQ_ASSERT(condition)                                                           \
  do {                                                                                  \
    if (!(condition)) {                                                                 \
      std::fprintf(stderr, "%s:%d: lpquad bug: %s does not hold\n", __FILE__, __LINE__, \
                   #condition);                                                         \
      std::abort();                                                                     \
    }                                                                                   \
  } while (false)
#else
#define LPQ_ASSERT(condition) ((void)0)
#endif
