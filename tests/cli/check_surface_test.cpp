// Meshes in space judged on the command line, and surfaces converted.
#include <filesystem>

#include "catch.h"
#include "support/cli_runner.h"
#include "support/contains.h"

using lpq_test::contains;
using lpq_test::file_text;
using lpq_test::run;
using lpq_test::ScratchFolder;

namespace {

/// A cube of side 2 with outward quads, sides in two groups, and a copy of some lines left out.
std::string cube_obj(bool turned = false, bool open = false) {
  std::string text;
  for (const char* p : {"0 0 0", "2 0 0", "2 2 0", "0 2 0", "0 0 2", "2 0 2", "2 2 2", "0 2 2"})
    text += std::string("v ") + p + "\n";
  text += "g ends\nf 1 4 3 2\n";
  if (!open) text += turned ? "f 8 7 6 5\n" : "f 5 6 7 8\n";
  return text + "g walls\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

}  // namespace

TEST_CASE("the mesh of a surface checks out, alone and against the surface") {
  const ScratchFolder folder("check_surface");
  const std::string cube = folder.write("cube.obj", cube_obj());
  for (const char* name : {"mesh.obj", "mesh.msh"}) {
    const std::string mesh = folder / name;
    REQUIRE(run({"mesh", cube, "-o", mesh, "--size", "0.5", "--quiet"}).code == 0);
    const auto alone = run({"check", mesh});
    INFO(alone.err);
    CHECK(alone.code == 0);
    CHECK(contains(alone.out, "quads 96, triangles 0"));
    CHECK(contains(alone.out, "mesh          parts 1, borders 0, Euler number 2\n"));
    CHECK(contains(alone.out, "valid         yes"));
    const auto against = run({"check", mesh, "--surface", cube});
    INFO(against.err);
    CHECK(against.code == 0);
    CHECK(contains(against.out, "surface       parts 1, borders 0, Euler number 2\n"));
    CHECK(contains(against.out, "distance      to the surface "));
  }
}

TEST_CASE("what is wrong with a mesh in space is said") {
  const ScratchFolder folder("check_surface_wrong");
  const std::string cube = folder.write("cube.obj", cube_obj());
  const auto turned = run({"check", folder.write("turned.obj", cube_obj(true))});
  CHECK(turned.code == 1);
  CHECK(contains(turned.err, "Faces beside 4 edges look to opposite sides."));
  const std::string open = folder.write("open.obj", cube_obj(false, true));
  CHECK(run({"check", open}).code == 0);
  const auto hole = run({"check", open, "--surface", cube});
  CHECK(hole.code == 1);
  CHECK(contains(hole.err, "The mesh has borders 1, the surface 0."));
  CHECK(contains(hole.err, "The mesh has Euler number 1, the surface 2."));
  const auto crack = run({"check", folder.write("crack.obj",
                                                "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                                                "v 1 0 1\nv 2 0 0\nv 2 1 0\n"
                                                "f 1 2 3 4\nf 5 6 7 3\n")});
  CHECK(crack.code == 1);
  CHECK(contains(crack.err, "Two vertices lie in the same place. (at 1 0 1)"));
  const std::string far =
      folder.write("far.obj", "v 0 0 9\nv 1 0 9\nv 1 1 9\nv 0 1 9\nf 1 2 3 4\n");
  const auto away = run({"check", far, "--surface", cube});
  CHECK(away.code == 1);
  CHECK(contains(away.err, "The mesh goes farther from the surface"));
  CHECK(contains(away.err, "The surface goes farther from the mesh"));
}

TEST_CASE("a surface is welded for check as it is for mesh") {
  const ScratchFolder folder("check_weld");
  // A cube of side 2 whose lid does not quite meet its walls.
  std::string loose = cube_obj();
  loose.insert(loose.find("g ends"), "v 0 0 2.001\nv 2 0 2.001\nv 2 2 2.001\nv 0 2 2.001\n");
  loose.replace(loose.find("f 5 6 7 8"), 9, "f 9 10 11 12");
  const std::string surface = folder.write("loose.obj", loose), mesh = folder / "mesh.obj";
  REQUIRE(run({"mesh", surface, "-o", mesh, "--size", "0.5", "--weld", "0.001", "--quiet"}).code ==
          0);
  CHECK(run({"check", mesh, "--surface", surface, "--weld", "0.001"}).code == 0);
  CHECK(run({"check", mesh, "--surface", surface}).code == 1);
  CHECK(run({"check", mesh, "--surface", surface, "--weld", "1"}).code == 2);
}

TEST_CASE("references that do not fit are refused in words") {
  const ScratchFolder folder("check_surface_refused");
  const std::string cube = folder.write("cube.obj", cube_obj());
  const std::string square = std::string(LPQ_DOMAINS) + "/square.json";
  const auto both = run({"check", cube, "--domain", square, "--surface", cube});
  CHECK(both.code == 2);
  CHECK(contains(both.err, "not both"));
  const auto in_space = run({"check", cube, "--domain", square});
  CHECK(in_space.code == 3);
  CHECK(contains(in_space.err, "compare it with --surface"));
  CHECK(run({"check", cube, "--surface", folder / "nothing.stl"}).code == 3);
  CHECK(run({"check", folder.write("x.msh", "$MeshFormat\n"), "--surface", cube}).code == 3);
}

TEST_CASE("bodies that touch are meshed apart, and check out against their surface") {
  const ScratchFolder folder("bodies");
  std::string text;
  for (const double shift : {0.0, 1.0})
    for (int i = 0; i < 8; ++i)
      text += "v " + std::to_string((i & 1) + shift) + ' ' + std::to_string(i >> 1 & 1) + ' ' +
              std::to_string(i >> 2) + '\n';
  for (const int first : {1, 9}) {
    text += first == 1 ? "o left\n" : "o right\n";
    for (const auto& side : {"0 2 3 1", "4 5 7 6", "0 1 5 4", "2 6 7 3", "0 4 6 2", "1 3 7 5"}) {
      text += 'f';
      for (int k = 0; k < 4; ++k) text += ' ' + std::to_string(first + side[2 * k] - '0');
      text += '\n';
    }
  }
  const std::string boxes = folder.write("boxes.obj", text), mesh = folder / "mesh.obj";
  const auto made =
      run({"mesh", boxes, "-o", mesh, "--size", "0.25", "--report", folder / "r.json"});
  INFO(made.err);
  REQUIRE(made.code == 0);
  CHECK(contains(made.out, "bodies 2"));
  CHECK(contains(
      file_text(folder / "r.json"),
      "\"bodies\":[{\"name\":\"left\",\"vertices\":98,\"quads\":96,\"triangles\":0,\"parts\":1,"
      "\"borderEdges\":0},"));
  const auto checked = run({"check", mesh, "--surface", boxes});
  INFO(checked.out);
  CHECK(checked.code == 0);
  CHECK(contains(checked.out, "parts 2, borders 0, Euler number 4"));
  // Without the surface nothing tells that the boxes are two.
  const auto alone = run({"check", mesh});
  CHECK(alone.code != 0);
  CHECK(contains(alone.err, "Two vertices lie in the same place."));
}

TEST_CASE("surfaces are converted with their groups, repaired") {
  const ScratchFolder folder("convert");
  const std::string cube = folder.write("cube.obj", cube_obj(true));
  const std::string out = folder / "triangles.obj";
  const auto made = run({"convert", cube, "-o", out});
  INFO(made.err);
  REQUIRE(made.code == 0);
  CHECK(contains(made.out, "triangles 12, vertices 8, groups 2, parts 1, border edges 0"));
  CHECK(contains(made.out, "2 triangles were turned over"));
  const std::string text = file_text(out);
  CHECK(contains(text, "\ng ends\nf "));
  CHECK(contains(text, "\ng walls\nf "));
  const auto again = run({"convert", out, "-o", folder / "again.obj"});
  CHECK_FALSE(contains(again.out, "warning"));
  CHECK(file_text(folder / "again.obj") == text);
  CHECK(run({"convert", out, "-o", folder / "quiet.obj", "--quiet"}).out.empty());
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"convert"},
                                                {"convert", cube},
                                                {"convert", cube, "-o", cube},
                                                {"convert", cube, "-o", folder / "./cube.obj"},
                                                {"convert", cube, "-o", folder / "x.stl"},
                                                {"convert", cube, cube, "-o", out},
                                                {"convert", cube, "-o", out, "--sise", "1"}})
    CHECK(run(wrong).code == 2);
  CHECK(run({"convert", folder / "nothing.obj", "-o", folder / "x.obj"}).code == 3);
  CHECK(contains(run({"convert", "--help"}).out, "--weld"));
}

TEST_CASE("CAD files are refused with what to do") {
  const ScratchFolder folder("cad");
  for (const char* name : {"part.step", "part.STP", "part.iges", "part.igs", "part.brep"}) {
    const std::string part = folder.write(name, "ISO-10303-21;");
    for (const std::vector<std::string>& args :
         {std::vector<std::string>{"mesh", part, "-o", folder / "x.msh", "--size", "2"},
          {"convert", part, "-o", folder / "x.obj"}}) {
      const auto refused = run(args);
      CHECK(refused.code == 3);
      CHECK(contains(refused.err, "npm install lpquad occt-import-js"));
      CHECK(contains(refused.err, "npx lpquad convert " + part + " -o part.obj"));
    }
  }
  CHECK(contains(run({"mesh", folder / "missing.step", "-o", folder / "x.msh"}).err, "IO_ERROR"));
}
