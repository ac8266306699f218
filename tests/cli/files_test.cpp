#include "cli/files.h"

#include <filesystem>
#include <iterator>
#ifndef _WIN32
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

#include "catch.h"
#include "support/cli_runner.h"

using namespace lpq;
using lpq_test::ScratchFolder;
namespace fs = std::filesystem;

TEST_CASE("files are written whole, with their folders, and read back") {
  const ScratchFolder folder("files");
  const std::string name = folder / "deep/er/x.obj";
  const std::string content("a\0b\r\n\xFF", 6);
  REQUIRE_FALSE(write_file(name, content));
  REQUIRE_FALSE(write_file(name, content + content));  // over the old one
  CHECK(read_file(name).value() == content + content);
  CHECK_FALSE(std::filesystem::exists(name + ".part"));
}

TEST_CASE("a failed write leaves the old file and no rest") {
  const ScratchFolder folder("files_failed");
  const std::string file = folder.write("plain", "old");
  const Problem unwritten = write_file(file + "/x.obj", "new");
  REQUIRE(unwritten);
  CHECK(unwritten->code == ErrorCode::io_error);
  std::filesystem::create_directory(folder / "taken");
  REQUIRE(write_file(folder / "taken", "new"));
  CHECK_FALSE(std::filesystem::exists(folder / "taken.part"));
  CHECK(lpq_test::file_text(file) == "old");
}

TEST_CASE("links, permissions and what is not a file stay what they are") {
  const ScratchFolder folder("files_kept");
  const std::string file = folder.write("target", "old"), link = folder / "link";
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("target", link);
  const std::string mine = folder.write("target.part", "mine");
  REQUIRE_FALSE(write_file(link, "new"));
  CHECK(fs::is_symlink(link));
  CHECK(lpq_test::file_text(file) == "new");
  CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(lpq_test::file_text(mine) == "mine");
  fs::create_symlink("missing", folder / "dangling");
  REQUIRE_FALSE(write_file(folder / "dangling", "new"));
  CHECK(fs::is_symlink(folder / "dangling"));
  CHECK(lpq_test::file_text(folder / "missing") == "new");
  CHECK(std::distance(fs::directory_iterator(fs::path(file).parent_path()), {}) == 5);
}

#ifndef _WIN32
TEST_CASE("a pipe is written into") {
  const ScratchFolder folder("files_pipe");
  const std::string pipe = folder / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  const fs::path before = fs::current_path();
  fs::current_path(fs::path(pipe).parent_path());
  CHECK_FALSE(write_file("pipe", "new"));
  fs::current_path(before);
  char text[8] = {};
  CHECK(read(reader, text, sizeof text) == 3);
  CHECK(std::string(text) == "new");
  close(reader);
  CHECK(fs::is_fifo(pipe));
}
#endif

TEST_CASE("names of one file are known as such") {
  const ScratchFolder folder("files_named");
  const std::string file = folder.write("a", "a");
  fs::create_symlink("a", folder / "link");
  fs::create_symlink("nothing", folder / "dangling");
  fs::create_directory_symlink(".", folder / "here");
  for (const char* name : {"link", "./a", "here/a", "./here/./link"}) {
    INFO(name);
    CHECK(real_path(folder / name) == real_path(file));
  }
  CHECK(real_path(folder / "dangling") == real_path(folder / "here/nothing"));
  CHECK(real_path("none/../x.obj") == real_path(fs::absolute("x.obj").string()));
  CHECK(real_path(folder / "b") != real_path(file));
}

TEST_CASE("what cannot be read says why") {
  const ScratchFolder folder("files_unreadable");
  for (const std::string& name : {folder / "missing.json", folder / ""}) {
    const auto text = read_file(name);
    REQUIRE_FALSE(text.has_value());
    CHECK(text.error().code == ErrorCode::io_error);
    CHECK(text.error().message.find("Cannot read") == 0);
  }
  CHECK(file_stem("a/b.c/d.json") == "d");
  CHECK(file_stem("-") == "stdin");
}
