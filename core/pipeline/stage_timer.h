// CPU time of the stages of a run.
#pragma once

#include <ctime>
#include <vector>

#include "pipeline/report.h"

namespace lpq {

/// Adds the CPU time of a scope to the list, under one name per stage.
class StageTimer {
 public:
  StageTimer(std::vector<StageTime>& times, const char* stage)
      : times_(times), stage_(stage), start_(std::clock()) {}
  ~StageTimer() {
    const double seconds = static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
    for (StageTime& time : times_)
      if (time.stage == stage_) {
        time.cpu_seconds += seconds;
        return;
      }
    times_.push_back({stage_, seconds});
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  std::vector<StageTime>& times_;
  const char* stage_;
  std::clock_t start_;
};

}  // namespace lpq
