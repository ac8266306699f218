// Warnings of one kind, when there may be as many of them as the input has points.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace lpq {

/// Keeps the first 20; one more then says how many there are besides.
class FewWarnings {
 public:
  void add(Warning warning) {
    if (++count_ <= most) kept_.push_back(std::move(warning));
  }

  /// Those kept so far, for good: the next ones count anew.
  std::vector<Warning> take();

 private:
  static constexpr std::size_t most = 20;
  std::vector<Warning> kept_;
  std::size_t count_ = 0;
};

}  // namespace lpq
