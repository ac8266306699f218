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

namespace fs = std::filesystem;

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

/// A file that was not there yet, beside `target`; nullptr with errno if there can be none.
std::FILE* open_beside(const fs::path& target, std::string& name) {
  std::FILE* file = nullptr;
  for (int i = 0; i < 1000; ++i) {
    name = target.string() + ".part" + (i == 0 ? "" : std::to_string(i));
    errno = 0;
    file = std::fopen(name.c_str(), "wbx");
    if (file != nullptr || errno != EEXIST) break;
  }
  return file;
}

}  // namespace

Result<std::string> read_file(const std::string& name) {
  if (name == "-") return read_stream(stdin, "standard input");
  std::error_code ignored;
  if (fs::is_directory(name, ignored)) return file_error("Cannot read", name, EISDIR);
  errno = 0;
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(name.c_str(), "rb"));
  if (!file) return file_error("Cannot read", name, errno);
  return read_stream(file.get(), name);
}

std::string real_path(const std::string& name) {
  constexpr int most_links = 40;
  std::error_code code;
  fs::path path = fs::absolute(name, code);
  // weakly_canonical() takes a link that leads to no file for the file itself.
  for (int i = 0; i < most_links; ++i) {
    const fs::path next = fs::read_symlink(path, code);
    if (code) break;
    path = path.parent_path() / next;
  }
  const fs::path canonical = fs::weakly_canonical(path, code);
  return (code ? path.lexically_normal() : canonical).string();
}

Problem write_file(const std::string& name, const std::string& content) {
  std::error_code code, ignored;
  const fs::file_status old = fs::status(name, ignored);
  const bool in_place = fs::exists(old) && !fs::is_regular_file(old);
  const fs::path target(in_place ? name : real_path(name));
  if (!in_place) fs::create_directories(target.parent_path(), code);
  if (code) return file_error("Cannot create the folder of", name, code.value());
  std::string written_to = name;
  errno = 0;
  std::FILE* file = in_place ? std::fopen(name.c_str(), "wb") : open_beside(target, written_to);
  if (file == nullptr) return file_error("Cannot write", name, errno);
  if (!in_place && fs::exists(old)) fs::permissions(written_to, old.permissions(), ignored);
  const bool written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  const bool closed = std::fclose(file) == 0;
  const int failure = errno;
  if (written && closed && !in_place) fs::rename(written_to, target, code);
  if (written && closed && !code) return {};
  if (!in_place) fs::remove(written_to, ignored);
  return file_error("Cannot write", name, code ? code.value() : failure);
}

std::string file_stem(const std::string& name) {
  return name == "-" ? "stdin" : fs::path(name).stem().string();
}

}  // namespace lpq
