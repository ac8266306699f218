// See progress.h.
#include "cli/progress.h"

#include "io/number.h"

namespace lpq {

namespace {
constexpr auto redraw_interval = std::chrono::milliseconds(80);
constexpr std::string_view clear_line = "\r\x1b[K";
}  // namespace

ProgressLine::ProgressLine(const CliStreams& streams, bool shown)
    : streams_(streams), shown_(shown && streams.err_is_terminal) {}

ProgressLine::~ProgressLine() {
  if (drawn_) streams_.err(clear_line);
}

Monitor ProgressLine::monitor() { return {&ProgressLine::update, this}; }

bool ProgressLine::update(const Progress& progress, void* self) {
  static_cast<ProgressLine*>(self)->show(progress);
  return true;
}

void ProgressLine::show(const Progress& progress) {
  if (!shown_) return;
  const auto now = std::chrono::steady_clock::now();
  if (stage_ == progress.stage && now - last_ < redraw_interval) return;
  last_ = now;
  stage_ = progress.stage;
  std::string line(clear_line);
  line += stage_;
  if (progress.max_iterations > 0) {
    line += ' ';
    append_integer(line, progress.iteration);
    line += '/';
    append_integer(line, progress.max_iterations);
  }
  if (progress.energy > 0) {
    line += "  energy ";
    append_number(line, progress.energy);
  }
  streams_.err(line);
  drawn_ = true;
}

}  // namespace lpq
