// See files.h.
#include "cli/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

namespace lpq {
namespace {

constexpr std::size_t largest_file = std::size_t{1} << 30;

Error file_error(const std::string& what, const std::string& name, int code) {
  std::string message = what + " '" + name + "'";
  if (code != 0) message += ": " + std::generic_category().message(code);
  return {ErrorCode::io_error, message + ".", {}};
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

Result<std::string> read_stream(std::FILE* file, const std::string& name) {
  std::string text;
  char block[1 << 16];
  std::size_t count = 0;
  while ((count = std::fread(block, 1, sizeof block, file)) > 0) {
    text.append(block, count);
    if (text.size() > largest_file) {
      return Error{ErrorCode::too_large, "'" + name + "' is larger than 1 GiB.", {}};
    }
  }
  if (std::ferror(file)) return file_error("Cannot read", name, errno);
  return text;
}

}  // namespace

Result<std::string> read_file(const std::string& name) {
  if (name == "-") return read_stream(stdin, "standard input");
  std::error_code ignored;
  if (std::filesystem::is_directory(name, ignored)) return file_error("Cannot read", name, EISDIR);
  errno = 0;
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(name.c_str(), "rb"));
  if (!file) return file_error("Cannot read", name, errno);
  return read_stream(file.get(), name);
}

Problem write_file(const std::string& name, const std::string& content) {
  namespace fs = std::filesystem;
  std::error_code code;
  const fs::path target(name);
  if (target.has_parent_path()) {
    fs::create_directories(target.parent_path(), code);
    if (code) return file_error("Cannot create the folder of", name, code.value());
  }
  const std::string temporary = name + ".part";
  errno = 0;
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  if (file == nullptr) return file_error("Cannot write", name, errno);
  const bool written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  const bool closed = std::fclose(file) == 0;
  const int failure = errno;
  if (written && closed) fs::rename(temporary, target, code);
  if (!written || !closed || code) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    return file_error("Cannot write", name, code ? code.value() : failure);
  }
  return {};
}

std::string file_stem(const std::string& name) {
  return name == "-" ? "stdin" : std::filesystem::path(name).stem().string();
}

}  // namespace lpq
