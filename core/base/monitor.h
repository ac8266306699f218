// Progress and cancellation for batch runs: facts, not percentages.
#pragma once

namespace lpq {

struct Progress {
  const char* stage = "";
  int iteration = 0;
  int max_iterations = 0;
  double energy = 0;
};

/// Asked once per iteration or per block of work; returning false asks the work to stop.
struct Monitor {
  bool (*keep_going)(const Progress&, void* user) = nullptr;
  void* user = nullptr;

  bool operator()(const Progress& progress) const {
    return keep_going == nullptr || keep_going(progress, user);
  }
};

}  // namespace lpq
