// The commands as a person uses them: files in, files out, exit codes, sentences.
#include <filesystem>

#include "catch.h"
#include "io/stages.h"
#include "support/cli_runner.h"
#include "support/contains.h"

using lpq_test::contains;
using lpq_test::file_text;
using lpq_test::run;
using lpq_test::ScratchFolder;

namespace {

const std::string domains = LPQ_DOMAINS;
const std::string bow_tie = R"({"loops": [[[0,0],[1,1],[1,0],[0,1]]], "h": 0.2})";

}  // namespace

TEST_CASE("a domain becomes every kind of file, and the mesh checks out") {
  const ScratchFolder folder("every_file");
  const std::string domain = domains + "/plate_with_hole.json";
  for (const char* ending : {"obj", "msh"}) {
    const std::string mesh = folder / (std::string("plate.") + ending);
    const auto made = run({"mesh", domain, "-o", mesh, "--svg", folder / "plate.svg", "--report",
                           folder / "report.json", "--stages", folder / "stages"});
    INFO(made.err);
    REQUIRE(made.code == 0);
    CHECK(contains(made.out, "triangles 0"));
    CHECK(made.err.empty());
    const auto checked = run({"check", mesh, "--domain", domain});
    INFO(checked.err);
    CHECK(checked.code == 0);
    CHECK(contains(checked.out, "valid         yes"));
  }
  CHECK(run({"mesh", domain, "-o", folder / "paper.obj", "--method", "paper", "--stages",
             folder / "paper"})
            .code == 0);
  for (const char* stages : {"stages", "paper"})
    for (const auto& file : std::filesystem::directory_iterator(folder / stages)) {
      INFO(file.path().string());
      CHECK(lpq::is_stage_name(file.path().filename().string()));
    }
  for (const char* name : {"paper/iterates.json", "paper/iterates.bin", "plate.svg", "report.json",
                           "stages/cells.json", "stages/energy.json", "stages/matching.json",
                           "stages/triangles.obj", "stages/crosses.json"}) {
    INFO(name);
    CHECK(file_text(folder / name).size() > 100);
  }
}

TEST_CASE("drawings are domains too, and what they leave out is reported") {
  const ScratchFolder folder("drawings");
  const std::string drawing = folder.write(
      "plate.svg",
      "<svg><rect width='4' height='3'/><circle cx='1' cy='1' r='.5'/><text>1</text></svg>");
  const std::string mesh = folder / "plate.msh";
  const auto made = run({"mesh", drawing, "-o", mesh, "--report", folder / "report.json"});
  INFO(made.err);
  REQUIRE(made.code == 0);
  CHECK(contains(made.out, "Left out: 1 text."));
  CHECK(contains(file_text(folder / "report.json"), "Left out: 1 text."));
  CHECK(run({"check", mesh, "--domain", drawing}).code == 0);
  // A mesh is a domain as well: its outline comes back.
  CHECK(run({"mesh", mesh, "-o", folder / "again.obj", "--keep-boundary"}).code == 0);
  const auto broken =
      run({"mesh", folder.write("x.svg", "<svg>\n<path d='M1'/></svg>"), "-o", mesh});
  CHECK(broken.code == 3);
  CHECK(contains(broken.err, "line 2"));
  CHECK(run({"mesh", folder.write("x.stl", "solid x"), "-o", mesh}).code == 3);
}

TEST_CASE("a kept boundary comes back bit for bit, zeros with their signs") {
  const ScratchFolder folder("signed_zeros");
  const std::string mesh = folder / "mesh.obj";
  const auto made = run({"mesh", domains + "/signed_zeros.json", "-o", mesh, "--keep-boundary"});
  INFO(made.err);
  REQUIRE(made.code == 0);
  std::string nodes;
  for (const char* node : {"-1 -1", "-0 -1", "1 -1", "1 -0", "1 1", "0 1", "-1 1", "-1 -0"})
    nodes += "v " + std::string(node) + " 0\n";
  CHECK(contains(file_text(mesh), nodes));
}

TEST_CASE("points to start from may come in the domain's file") {
  const ScratchFolder folder("seed_points");
  std::string points;
  for (int i = 1; i < 10; ++i)
    for (int j = 1; j < 10; ++j)
      points +=
          (points.empty() ? "[0." : ",[0.") + std::to_string(i) + ",0." + std::to_string(j) + "]";
  const std::string domain = folder.write(
      "grid.json", R"({"loops": [[[0,0],[1,0],[1,1],[0,1]]], "seedPoints": [)" + points + "]}");
  const auto made = run({"mesh", domain, "-o", folder / "grid.obj", "--size", "0.1", "--method",
                         "paper", "--report", folder / "report.json"});
  INFO(made.err);
  REQUIRE(made.code == 0);
  const std::string report = file_text(folder / "report.json");
  CHECK(contains(report, "\"seeds\":81"));
  CHECK(contains(report, "\"chain\":\"given + L_p"));
  CHECK(contains(report, "\"quads\":100"));
}

TEST_CASE("the same run writes the same bytes") {
  const ScratchFolder folder("same_bytes");
  const std::string domain = domains + "/gear.json";
  for (const char* ending : {"obj", "vtu"}) {
    for (const char* name : {"1.", "2."}) {
      const auto made =
          run({"mesh", domain, "-o", folder / (std::string(name) + ending), "--quiet"});
      REQUIRE(made.code == 0);
      CHECK((made.out + made.err).empty());
    }
    CHECK(file_text(folder / (std::string("1.") + ending)) ==
          file_text(folder / (std::string("2.") + ending)));
  }
}

TEST_CASE("several inputs go into a folder; one bad input does not stop the others") {
  const ScratchFolder folder("several");
  const std::string bad = folder.write("bad.json", bow_tie);
  const auto made = run({"mesh", domains + "/square.json", bad, domains + "/l_shape.json", "-o",
                         folder / "out/", "--report", folder / "out/{}.report.json"});
  CHECK(made.code == 3);
  CHECK(contains(made.err, "bad.json: error SELF_INTERSECTION: "));
  CHECK(file_text(folder / "out/square.obj").size() > 100);
  CHECK(file_text(folder / "out/l_shape.obj").size() > 100);
  CHECK_FALSE(std::filesystem::exists(folder / "out/bad.obj"));
  const std::string report = file_text(folder / "out/bad.report.json");
  CHECK(contains(report, "{\"error\":{\"code\":\"SELF_INTERSECTION\",\"message\":"));
  CHECK(contains(report, "\"loop\":0"));
}

TEST_CASE("exit codes and sentences") {
  const ScratchFolder folder("exit_codes");
  const std::string square = domains + "/square.json";
  CHECK(run({"--help"}).code == 0);
  CHECK(contains(run({"mesh", "--help"}).out, "--keep-boundary"));
  CHECK(contains(run({"check", "-h"}).out, "--domain"));
  CHECK(contains(run({"--version"}).out, "lpquad "));
  CHECK(run({}).code == 2);
  CHECK(contains(run({"mehs"}).err, "Did you mean 'mesh'?"));
  CHECK(run({"mesh"}).code == 2);
  CHECK(run({"mesh", square}).code == 2);
  CHECK(run({"mesh", square, "-o", folder / "x.stl"}).code == 2);
  CHECK(contains(run({"mesh", square, "--nrom", "6"}).err, "error BAD_OPTION: "));
  CHECK(run({"mesh", folder / "missing.json", "-o", folder / "x.obj"}).code == 3);
  const auto broken =
      run({"mesh", folder.write("broken.json", "{\"loops\": ["), "-o", folder / "x.obj"});
  CHECK(broken.code == 3);
  CHECK(contains(broken.err, "error PARSE_ERROR: "));
  CHECK(contains(broken.err, "the text ends within loops[0]. (line 1 byte 10)\n"));
  const auto nothing = run({"mesh", folder.write("empty.json", ""), "-o", folder / "x.obj"});
  CHECK(contains(nothing.err, "error EMPTY: The file is empty."));
  const auto too_many = run({"mesh", square, "-o", folder / "x.obj", "--size", "1e-6"});
  CHECK(contains(too_many.err, "raise --max-elements."));
  // But what was typed is repeated as it was.
  CHECK(contains(run({"mesh", folder / "keepBoundary.json", "-o", folder / "x.obj"}).err,
                 "/keepBoundary.json'"));
  CHECK(contains(run({"mesh", square, "--maxElements", "5"}).err, "option --maxElements."));
  CHECK(run({"mesh", square, "-o", folder / "missing.json/../x.obj/"}).code != 1);
  CHECK(run({"check"}).code == 2);
  CHECK(run({"check", folder / "missing.obj"}).code == 3);
  CHECK(run({"check", square}).code == 3);
}

TEST_CASE("check finds what is wrong with a mesh") {
  const ScratchFolder folder("check");
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n";
  const auto judge = [&](const std::string& text) {
    return run({"check", folder.write("m.obj", text)});
  };
  CHECK(judge(points + "f 1 2 3 4\nf 2 5 6 3\n").code == 0);
  const auto inverted = judge(points + "f 1 2 3 4\nf 3 6 5 2\n");
  CHECK(inverted.code == 1);
  CHECK(contains(inverted.err, "is not a valid mesh"));
  CHECK(judge(points + "f 1 2 3 4\nf 1 2 3 4\nf 2 5 6 3\n").code == 1);
  CHECK(judge(points + "f 1 2 4 3\nf 2 5 6 3\n").code == 1);
}

TEST_CASE("check compares the boundary with the domain") {
  const ScratchFolder folder("check_domain");
  const std::string domain = folder.write("d.json", R"({"loops": [[[0,0],[2,0],[2,1],[0,1]]]})");
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n";
  const auto judge = [&](const std::string& text) {
    return run({"check", folder.write("m.obj", text), "--domain", domain});
  };
  const auto whole = judge(points + "f 1 2 3 4\nf 2 5 6 3\n");
  CHECK(whole.code == 0);
  CHECK(contains(whole.out, "kept 2, divided 2"));
  CHECK(judge(points + "f 1 2 3 4\n").code == 1);  // half of it is missing
  std::string moved = points + "f 1 2 3 4\nf 2 5 6 3\n";
  moved.replace(moved.find("v 1 0 0"), 7, "v 1 1e-9 0");
  CHECK(judge(moved).code == 1);
  const auto with_point = [&](const std::string& point) {
    const std::string asked = folder.write(
        "p.json", R"({"loops": [[[0,0],[2,0],[2,2],[0,2]]], "points": [)" + point + "]}");
    const std::string four =
        points + "v 0 2 0\nv 1 2 0\nv 2 2 0\nf 1 2 3 4\nf 2 5 6 3\nf 4 3 8 7\nf 3 6 9 8\n";
    return run({"check", folder.write("m.obj", four), "--domain", asked});
  };
  CHECK(with_point("[1,1]").code == 0);
  const auto absent = with_point("[0.5,1.25]");
  CHECK(absent.code == 1);
  CHECK(contains(absent.err, "is not a vertex of the mesh"));
  CHECK(contains(absent.err, "at 0.5 1.25"));
}

TEST_CASE("check tells the two walls of a sharp corner apart") {
  const ScratchFolder folder("check_sharp");
  // The nodes beside the corner lie within rounding of both walls.
  const std::string domain =
      folder.write("d.json", R"({"loops": [[[4,4],[5,3.99609375],[5,4]]], "h": 1})");
  const std::string mesh = folder.write("m.obj",
                                        "v 4 4 0\nv 5 4 0\nv 5 3.99609375 0\n"
                                        "v 4.00000000000045474735088646411895751953125 4 0\n"
                                        "v 4.00000000000045474735088646411895751953125 "
                                        "3.999999999999998223643160599749535322189331054688 0\n"
                                        "f 1 5 4\nf 5 3 2 4\n");
  const auto checked = run({"check", mesh, "--domain", domain});
  INFO(checked.err);
  CHECK(checked.code == 0);
}

TEST_CASE("progress is drawn for eyes only, and wiped") {
  const ScratchFolder folder("progress");
  const std::vector<std::string> args{"mesh", domains + "/l_shape.json", "-o", folder / "x.obj"};
  CHECK(run(args).err.empty());
  const auto drawn = run(args, true);
  CHECK_FALSE(drawn.err.empty());
  CHECK(drawn.err.substr(drawn.err.size() - 4) == "\r\x1b[K");
  std::vector<std::string> quiet = args;
  quiet.push_back("--quiet");
  CHECK(run(quiet, true).err.empty());
}
