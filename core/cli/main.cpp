#include <cstdio>
#include <string_view>
#include <vector>

#include "cli/cli.h"

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
  const auto writer = [](std::FILE* file) {
    return [file](std::string_view text) {
      std::fwrite(text.data(), 1, text.size(), file);
      std::fflush(file);
    };
  };
  const lpq::CliStreams streams{writer(stdout), writer(stderr), is_terminal(stderr)};
  return lpq::run_cli(args, streams);
}
