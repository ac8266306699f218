// Independent pieces of work, shared out among threads where there are threads.
#pragma once

#include <algorithm>
#include <cstddef>

#if !defined(__EMSCRIPTEN__) || defined(__EMSCRIPTEN_PTHREADS__)
#define LPQ_HAS_THREADS 1
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>
#else
#define LPQ_HAS_THREADS 0
#endif

namespace lpq {

/// As many as the machine runs at once, at least 1; 1 where there are none.
inline int machine_threads() {
#if LPQ_HAS_THREADS
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
#else
  return 1;
#endif
}

/// Calls work(piece, thread) once for every piece 0 .. count-1, in this order but at the same time
/// on up to `threads` threads, 0 .. threads-1; thread 0 is the caller's. What a piece writes
/// must be its own, so that the results do not depend on the threads. When there is no piece left
/// for it the caller's thread calls idle() now and then until the others are ready.
template <class Work, class Idle>
void share_out(std::size_t count, int threads, Work&& work, Idle&& idle) {
#if LPQ_HAS_THREADS
  std::atomic<std::size_t> next{0}, ready{0};
  const auto take = [&](int thread) {
    for (std::size_t piece = next++; piece < count; piece = next++) work(piece, thread);
    ++ready;
  };
  std::vector<std::thread> others;
  const auto wanted = std::min(count, static_cast<std::size_t>(std::max(threads, 1)));
  for (std::size_t k = 1; k < wanted; ++k) others.emplace_back(take, static_cast<int>(k));
  take(0);
  for (; ready < wanted; idle()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  for (std::thread& other : others) other.join();
#else
  (void)threads;
  (void)idle;
  for (std::size_t piece = 0; piece < count; ++piece) work(piece, 0);
#endif
}

}  // namespace lpq
