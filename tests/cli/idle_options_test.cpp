// What is given in vain is told: options without effect, files of formats that nobody reads.
#include "catch.h"
#include "support/cli_runner.h"
#include "support/contains.h"

using lpq_test::CliResult;
using lpq_test::contains;
using lpq_test::file_text;
using lpq_test::run;
using lpq_test::ScratchFolder;

namespace {

const std::string square = R"({"loops": [[[0, 0], [1, 0], [1, 1], [0, 1]]]})";
const std::string tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

/// Runs `lpquad mesh`, with a report, in a folder of its own.
struct Meshing {
  explicit Meshing(std::string name) : folder("idle_" + name) {}

  CliResult operator()(std::vector<std::string> args, bool surface = false) const {
    const std::string input =
        surface ? folder.write("x.obj", tetrahedron) : folder.write("x.json", square);
    args.insert(args.begin(), {"mesh", input, "-o", folder / "mesh.msh", "--report",
                               folder / "report.json", "--size", "0.4"});
    return run(args);
  }
  ScratchFolder folder;
};

}  // namespace

TEST_CASE("options without effect are told, in the summary and in the report") {
  const Meshing mesh("planar");
  const std::vector<std::vector<std::string>> idle{{"--norm", "8"},
                                                   {"--restarts", "3"},
                                                   {"--simplify", "0.1", "--keep-boundary"},
                                                   {"--allow-added-point"},
                                                   {"--elements", "one-triangle"},
                                                   {"--effort", "high", "--method", "paper"},
                                                   {"--inp-element", "S4"},
                                                   {"--threads", "2"}};
  for (const std::vector<std::string>& args : idle) {
    const auto done = mesh(args);
    INFO(args[0] << ": " << done.err);
    REQUIRE(done.code == 0);
    const std::string told = "IGNORED: " + args[0] + " has no effect here: ";
    CHECK(contains(done.out, told));
    CHECK(contains(file_text(mesh.folder / "report.json"), args[0] + " has no effect here: "));
  }
}

TEST_CASE("options with an effect are not") {
  const Meshing mesh("fine");
  const std::vector<std::vector<std::string>> fine{
      {},
      {"--norm", "8", "--iterations", "2", "--restarts", "1"},
      {"--norm", "8", "--seeds", "isotropic"},
      {"--norm", "8", "--method", "paper"},
      {"--simplify", "0.01"},
      {"--keep-boundary", "--allow-added-point"},
      {"--keep-boundary", "--elements", "one-triangle"},
      {"--msh-version", "2.2"}};
  for (const std::vector<std::string>& args : fine) {
    const auto done = mesh(args);
    INFO(done.err);
    REQUIRE(done.code == 0);
    CHECK_FALSE(contains(done.out, "IGNORED"));
  }
}

TEST_CASE("options without effect on surfaces are told, too") {
  const Meshing mesh("surface");
  const auto idle = mesh({"--norm", "8"}, true);
  INFO(idle.err);
  REQUIRE(idle.code == 0);
  CHECK(contains(idle.out, "IGNORED: --norm has no effect here"));
  CHECK(contains(file_text(mesh.folder / "report.json"), "--norm has no effect here"));
  CHECK_FALSE(contains(mesh({"--norm", "8", "--iterations", "2"}, true).out, "IGNORED"));
}

TEST_CASE("files that nobody reads are told before their options are judged") {
  const ScratchFolder folder("unknown_files");
  const std::string scene = folder.write("part.3mf", "PK\x03\x04");
  for (const std::vector<std::string>& args :
       {std::vector<std::string>{"mesh", scene, "-o", folder / "x.obj", "--feature-angle", "30"},
        {"convert", scene, "-o", folder / "x.obj"}}) {
    const auto refused = run(args);
    CHECK(refused.code == 3);
    CHECK(contains(refused.err, "error PARSE_ERROR: This is a 3MF file"));
    CHECK(contains(refused.err, ".stl"));
  }
  const auto checked = run({"check", scene});
  CHECK(checked.code == 3);
  CHECK(contains(checked.err, "Only meshes in .obj and .msh files can be checked."));
}

TEST_CASE("scales that doubles cannot square, and sizes beyond all counts, get true words") {
  const ScratchFolder folder("scales");
  const auto refusal = [&](const std::string& scale, const std::string& size) {
    const std::string text = "{\"loops\": [[[0, 0], [" + scale + ", 0], [0, " + scale + "]]]}";
    const auto refused =
        run({"mesh", folder.write("x.json", text), "-o", folder / "x.obj", "--size", size});
    CHECK(refused.code == 3);
    return refused.err;
  };
  for (const char* scale : {"1e300", "1e-300"})
    CHECK(contains(refusal(scale, "0"), "error LOST_PRECISION: The domain is 1.41421e"));
  CHECK(contains(refusal("1", "1e-300"), "error TOO_MANY_ELEMENTS: About 1e+300 elements"));
  CHECK(contains(refusal("1", "1e-200"), "raise --max-elements"));
}
