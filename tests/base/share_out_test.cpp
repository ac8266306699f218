// Work shared out among threads: every piece once, and no failure lost.
#include "base/share_out.h"

#include <atomic>
#include <new>
#include <vector>

#include "catch.h"

using namespace lpq;

TEST_CASE("every piece is done once, on as many threads as there are or fewer") {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<std::atomic<int>> done(100);
    std::atomic<int> wrong{0};
    share_out(
        done.size(), threads,
        [&](std::size_t piece, int thread) {
          ++done[piece];
          wrong += thread < 0 || thread >= std::max(threads, 1);
        },
        [] {});
    for (const auto& count : done) CHECK(count == 1);
    CHECK(wrong == 0);
  }
  share_out(
      0, 4, [](std::size_t, int) { FAIL("there is no piece"); }, [] {});
}

TEST_CASE("want of memory on any thread reaches the caller, once all have stopped") {
  for (const int threads : {1, 3}) {
    std::atomic<int> running{0};
    const auto work = [&](std::size_t piece, int) {
      ++running;
      if (piece % 10 == 9) {
        --running;
        throw std::bad_alloc();
      }
      --running;
    };
    CHECK_THROWS_AS(share_out(1000, threads, work, [] {}), std::bad_alloc);
    CHECK(running == 0);
  }
}
