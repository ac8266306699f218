// The command line as a function: arguments in, exit code out. Streams are the caller's, so that a
// test can read what a person would.
#pragma once

#include <functional>
#include <span>
#include <string_view>

namespace lpq {

struct CliStreams {
  std::function<void(std::string_view)> out, err;
  bool err_is_terminal = false;  // progress is drawn only for eyes
};

enum ExitCode : int {
  exit_done = 0,
  exit_invalid = 1,    // `check`: the mesh is readable, but not valid
  exit_usage = 2,      // the command line is wrong
  exit_bad_input = 3,  // a file or domain is wrong
  exit_could_not = 4,  // no valid mesh found, out of memory, cannot write (a file or the output)
};

/// `args` without the program's name.
int run_cli(std::span<const std::string_view> args, const CliStreams& streams);

}  // namespace lpq
