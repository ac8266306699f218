// One line on the terminal that says where the work is.
#pragma once

#include <chrono>
#include <string>

#include "base/monitor.h"
#include "cli/cli.h"

namespace lpq {

class ProgressLine {
 public:
  ProgressLine(const CliStreams& streams, bool shown);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// To hand to mesh_domain; valid as long as this object.
  Monitor monitor();

 private:
  static bool update(const Progress& progress, void* self);
  void show(const Progress& progress);

  const CliStreams& streams_;
  bool shown_;
  bool drawn_ = false;
  std::string stage_;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace lpq
