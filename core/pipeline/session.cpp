// See session.h.
#include "pipeline/session.h"

namespace lpq {
namespace {

// A state of 10k vertices takes about 10 MB: a dozen of them keep replays short and memory small.
constexpr std::size_t max_checkpoints = 12;

}  // namespace

Session::Session(Mesher mesher, Memory memory) : mesher_(std::move(mesher)) {
  if (memory == Memory::nothing) return;
  mesher_.keep_trace();
  checkpoints_.emplace_back(0, mesher_);
}

Result<Session> Session::start(const DomainInput& input, const Options& options,
                               const UserFields& user, Memory memory) {
  auto mesher = Mesher::start(input, options, user);
  if (!mesher) return mesher.error();
  return Session(std::move(*mesher), memory);
}

Result<Stage> Session::step(int n) {
  for (int k = 0; k < n && mesher_.stage() != Stage::done; ++k) {
    if (failure_) return *failure_;
    if (const auto stage = mesher_.step(); !stage) {
      failure_ = stage.error();
      return *failure_;
    }
    ++ticks_;
    remember();
  }
  return mesher_.stage();
}

Result<Stage> Session::restore(int k) {
  if (k < 0)
    return Error{ErrorCode::bad_option, "There is no tick before 0, the start of the run.", {}};
  if (k < ticks_ || failure_) {
    if (checkpoints_.empty())
      return Error{ErrorCode::bad_option, "This session keeps no memory to go back in.", {}};
    failure_.reset();
    std::size_t nearest = checkpoints_.size() - 1;
    while (checkpoints_[nearest].first > k) --nearest;
    ticks_ = checkpoints_[nearest].first;
    mesher_ = checkpoints_[nearest].second;
  }
  return step(k - ticks_);
}

/// Keeps every stride-th state; when there are too many, every other one goes.
void Session::remember() {
  if (checkpoints_.empty() || ticks_ % stride_ != 0 || ticks_ <= checkpoints_.back().first) return;
  checkpoints_.emplace_back(ticks_, mesher_);
  if (checkpoints_.size() <= max_checkpoints) return;
  stride_ *= 2;
  std::erase_if(checkpoints_, [&](const auto& entry) { return entry.first % stride_ != 0; });
}

}  // namespace lpq
