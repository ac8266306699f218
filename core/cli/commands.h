// The commands behind run_cli.
#pragma once

#include <span>
#include <string_view>

#include "base/result.h"
#include "cli/cli.h"

namespace lpq {

int mesh_command(std::span<const std::string_view> args, const CliStreams& streams);
int convert_command(std::span<const std::string_view> args, const CliStreams& streams);
int check_command(std::span<const std::string_view> args, const CliStreams& streams);

/// Prints "error CODE: sentence (place)", with a file's name in front where there is one.
void print_error(const CliStreams& streams, std::string_view file, const Error& error);

/// 2 for a wrong option, 4 for what was not the input's fault, else 3.
int exit_code(ErrorCode code);

}  // namespace lpq
