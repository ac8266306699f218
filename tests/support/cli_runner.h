// Calls the command line in-process, in a folder of its own.
#pragma once

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>
#include <vector>

#include "cli/cli.h"

namespace lpq_test {

struct CliResult {
  int code = 0;
  std::string out, err;
};

inline CliResult run(const std::vector<std::string>& args, bool terminal = false) {
  CliResult result;
  const lpq::CliStreams streams{[&](std::string_view text) { result.out += text; },
                                [&](std::string_view text) { result.err += text; }, terminal};
  const std::vector<std::string_view> views(args.begin(), args.end());
  result.code = lpq::run_cli(views, streams);
  return result;
}

/// A fresh folder that goes away with the object.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / ("lpquad_test_" + name)) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return *this / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::string file_text(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace lpq_test
