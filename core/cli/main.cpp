#include <algorithm>
#include <cstdio>
#include <string_view>
#include <vector>

#include "cli/cli.h"
#include "cli/commands.h"

#ifdef __EMSCRIPTEN__
#include <emscripten.h>
// Emscripten's own isatty says yes to every standard stream.
EM_JS(bool, lpq_is_terminal, (int descriptor), { return require("tty").isatty(descriptor); });
static bool is_terminal(std::FILE* file) { return lpq_is_terminal(fileno(file)); }
#elif defined(_WIN32)
#include <io.h>
static bool is_terminal(std::FILE* file) { return _isatty(_fileno(file)) != 0; }
#else
#include <unistd.h>
static bool is_terminal(std::FILE* file) { return isatty(fileno(file)) != 0; }
#endif

int main(int argc, char** argv) {
  const std::vector<std::string_view> args(argv + (argc > 0 ? 1 : 0), argv + argc);
  bool lost = false;  // something that standard output was to get
  const auto write = [](std::string_view text, std::FILE* file) {
    return std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
  };
  const lpq::CliStreams streams{[&](std::string_view text) { lost = !write(text, stdout) || lost; },
                                [&](std::string_view text) { write(text, stderr); },
                                is_terminal(stderr)};
  const int code = lpq::run_cli(args, streams);
  if (!lost) return code;
  // What `check` found has not reached anyone: that is no success.
  lpq::print_error(streams, {}, {lpq::ErrorCode::io_error, "Cannot write to standard output.", {}});
  return std::max<int>(code, lpq::exit_could_not);
}
