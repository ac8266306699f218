// See share_out.h. Compiled with exceptions everywhere: one that left a thread would end the
// program.
#include "base/share_out.h"

#include <algorithm>

#if !defined(__EMSCRIPTEN__) || defined(__EMSCRIPTEN_PTHREADS__)
#define LPQ_HAS_THREADS 1
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#endif

namespace lpq {

#if LPQ_HAS_THREADS

namespace {

class Sharing {
 public:
  Sharing(std::size_t count, FunctionRef<void(std::size_t, int)> work)
      : count_(count), work_(work) {}

  void run(int threads, FunctionRef<void()> idle) {
    std::vector<std::thread> others;
    try {
      for (int k = 1; k < threads; ++k) others.emplace_back([this, k] { take(k); });
    } catch (const std::exception&) {  // the system starts no more
    }
    take(0);
    for (; ready_ <= others.size(); idle())
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    for (std::thread& other : others) other.join();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void take(int thread) {
    try {
      for (std::size_t piece = next_++; piece < count_; piece = next_++) work_(piece, thread);
    } catch (...) {
      next_ = count_;
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
    ++ready_;
  }

  std::size_t count_;
  FunctionRef<void(std::size_t, int)> work_;
  std::atomic<std::size_t> next_{0}, ready_{0};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

int machine_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

void share_out(std::size_t count, int threads, FunctionRef<void(std::size_t, int)> work,
               FunctionRef<void()> idle) {
  const auto most = static_cast<std::size_t>(std::max(threads, 1));
  Sharing(count, work).run(static_cast<int>(std::clamp<std::size_t>(count, 1, most)), idle);
}

#else

int machine_threads() { return 1; }

void share_out(std::size_t count, int, FunctionRef<void(std::size_t, int)> work,
               FunctionRef<void()>) {
  for (std::size_t piece = 0; piece < count; ++piece) work(piece, 0);
}

#endif

}  // namespace lpq
