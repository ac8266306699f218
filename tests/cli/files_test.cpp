#include "cli/files.h"

#include <filesystem>

#include "catch.h"
#include "support/cli_runner.h"

using namespace lpq;
using lpq_test::ScratchFolder;

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
