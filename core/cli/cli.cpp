// See cli.h.
#include "cli/cli.h"

#include <algorithm>
#include <array>
#include <new>

#include "base/nearest_name.h"
#include "cli/args.h"
#include "cli/commands.h"
#include "cli/help.h"
#include "io/error_text.h"
#include "io/plain_text.h"

namespace lpq {
namespace {

bool is_part_of_name(char c) { return is_letter(c) || is_digit(c) || c == '-'; }

/// Is this place between quotes, as what a caller typed is? Apostrophes inside words are none.
bool is_quoted(std::string_view text, std::size_t at) {
  bool quoted = false;
  for (std::size_t i = 0; i < at; ++i)
    if (text[i] == '\'' && !(i > 0 && is_letter(text[i - 1]) && is_letter(text[i + 1])))
      quoted = !quoted;
  return quoted;
}

bool stands_alone(std::string_view text, std::size_t at, std::size_t size) {
  const std::size_t end = at + size;
  return !(at > 0 && is_part_of_name(text[at - 1])) &&
         !(end < text.size() && is_part_of_name(text[end])) && !is_quoted(text, at);
}

/// Messages name options as libraries know them: "raise maxElements" -> "raise --max-elements".
template <class Table>
void name_flags(const Table& table, std::string& text) {
  each_field(table, [&](const char* name, const auto&, const OptionInfo&) {
    const std::string_view word = name;
    if (std::none_of(word.begin(), word.end(), [](char c) { return 'A' <= c && c <= 'Z'; })) return;
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size())
      if (stands_alone(text, at, word.size())) text.replace(at, word.size(), option_flag(word));
  });
}

}  // namespace

void print_error(const CliStreams& streams, std::string_view file, const Error& error) {
  std::string text = "error " + error_text(error);
  name_flags(Options{}, text);
  name_flags(SurfaceOptions{}, text);
  if (!file.empty()) text = std::string(file) + ": " + text;
  streams.err(text + "\n");
}

int exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::bad_option: return exit_usage;
    case ErrorCode::no_valid_mesh:
    case ErrorCode::out_of_memory:
    case ErrorCode::cancelled:
    case ErrorCode::io_error: return exit_could_not;
    default: return exit_bad_input;
  }
}

namespace {

int dispatch(std::span<const std::string_view> args, const CliStreams& streams) {
  const std::string_view command = args.empty() ? "" : args[0];
  if (command == "mesh") return mesh_command(args.subspan(1), streams);
  if (command == "convert") return convert_command(args.subspan(1), streams);
  if (command == "check") return check_command(args.subspan(1), streams);
  if (command == "--version") {
    streams.out(version_text());
    return exit_done;
  }
  if (command == "--help" || command == "-h" || command == "help") {
    streams.out(general_help());
    return exit_done;
  }
  if (command.empty()) {
    streams.err(general_help());
    return exit_usage;
  }
  std::string message = "There is no command '" + std::string(command) + "'.";
  const std::array<std::string, 5> commands{"mesh", "check", "convert", "--help", "--version"};
  const std::string nearest = nearest_name(command, commands);
  message += nearest.empty() ? " See lpquad --help." : " Did you mean '" + nearest + "'?";
  print_error(streams, {}, {ErrorCode::bad_option, message, {}});
  return exit_usage;
}

}  // namespace

int run_cli(std::span<const std::string_view> args, const CliStreams& streams) {
  try {
    return dispatch(args, streams);
  } catch (const std::bad_alloc&) {
    print_error(streams, {}, {ErrorCode::out_of_memory, "There is not enough memory.", {}});
    return exit_could_not;
  }
}

}  // namespace lpq
