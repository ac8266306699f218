// Surfaces on the command line: every format in and out, options that are not theirs, reports.
#include <filesystem>

#include "catch.h"
#include "cli/args.h"
#include "support/cli_runner.h"
#include "support/contains.h"
#include "support/msh_bytes.h"

using lpq_test::contains;
using lpq_test::file_text;
using lpq_test::run;
using lpq_test::ScratchFolder;

namespace {

const std::string domains = LPQ_DOMAINS;

/// A box of 1 x 1 x 2 as an STL file: two triangles a side.
std::string box_stl() {
  const char* sides[6][4] = {
      {"0 0 0", "0 1 0", "1 1 0", "1 0 0"}, {"0 0 2", "1 0 2", "1 1 2", "0 1 2"},
      {"0 0 0", "1 0 0", "1 0 2", "0 0 2"}, {"1 0 0", "1 1 0", "1 1 2", "1 0 2"},
      {"1 1 0", "0 1 0", "0 1 2", "1 1 2"}, {"0 1 0", "0 0 0", "0 0 2", "0 1 2"}};
  std::string text = "solid box\n";
  for (const auto& side : sides)
    for (const int k : {1, 2}) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (const int corner : {0, k, k + 1}) text += std::string("vertex ") + side[corner] + "\n";
      text += "endloop\nendfacet\n";
    }
  return text + "endsolid box\n";
}

}  // namespace

TEST_CASE("a box becomes every kind of file that has three coordinates") {
  const ScratchFolder folder("surface_formats");
  const std::string box = folder.write("box.stl", box_stl());
  for (const char* ending : {"obj", "msh", "vtu", "vtk", "inp", "bdf", "ply", "geojson", "json"}) {
    INFO(ending);
    const std::string mesh = folder / (std::string("mesh.") + ending);
    const auto made = run({"mesh", box, "-o", mesh, "--size", "0.5"});
    INFO(made.err);
    REQUIRE(made.code == 0);
    CHECK(contains(made.out, "quads 40, triangles 0"));
    CHECK(contains(made.out, "faces 6, curves 12"));
    const std::string text = file_text(mesh);
    CHECK(contains(text, "1.5"));  // a height between the bottom and the lid
    if (std::string(ending) != "obj" && std::string(ending) != "vtu" &&
        std::string(ending) != "vtk")
      CHECK((contains(text, "face 6") || contains(text, "face_6")));
  }
  CHECK(contains(file_text(folder / "mesh.inp"), "TYPE=S4"));
  CHECK(contains(file_text(folder / "mesh.obj"), "\ng box"));
}

TEST_CASE("meshes of surfaces are surfaces again") {
  const ScratchFolder folder("surface_again");
  const std::string box = folder.write("box.STL", box_stl());
  REQUIRE(run({"mesh", box, "-o", folder / "box.msh", "--size", "0.5"}).code == 0);
  // A .msh file with faces in space is a surface, one in the plane a domain.
  const auto again = run({"mesh", folder / "box.msh", "-o", folder / "again.ply", "--size", "0.5"});
  INFO(again.err);
  CHECK(again.code == 0);
  CHECK(contains(again.out, "quads 40, triangles 0"));
  CHECK(contains(again.out, "faces 6, curves 12"));
  REQUIRE(run({"mesh", domains + "/square.json", "-o", folder / "square.msh"}).code == 0);
  CHECK(run({"mesh", folder / "square.msh", "-o", folder / "square.obj", "--keep-boundary"}).code ==
        0);
  CHECK(run({"mesh", folder / "again.ply", "-o", folder / "last.obj", "--size", "0.5"}).code == 0);
  CHECK(run({"mesh", folder / "last.obj", "-o", folder / "more/", "--size", "0.5"}).code == 0);
  CHECK(file_text(folder / "more/last.obj").size() > 100);
}

TEST_CASE("binary .msh files are meshed and checked as their texts are") {
  const ScratchFolder folder("surface_msh_bytes");
  const std::string box = folder.write("box.stl", box_stl());
  for (const char* version : {"2.2", "4.1"}) {
    INFO(version);
    const std::string text = folder / "text.msh", again = folder / "again.obj";
    REQUIRE(run({"mesh", box, "-o", text, "--size", "0.5", "--msh-version", version}).code == 0);
    const std::string bytes = folder.write("bytes.msh", lpq_test::msh_bytes(file_text(text)));
    REQUIRE(run({"mesh", text, "-o", again, "--size", "0.5"}).code == 0);
    const std::string expected = file_text(again);
    REQUIRE(run({"mesh", bytes, "-o", again, "--size", "0.5"}).code == 0);
    CHECK(file_text(again) == expected);
    const auto checked = run({"check", bytes, "--surface", box});
    CHECK(checked.code == 0);
    CHECK(contains(checked.out, "quads 40, triangles 0"));
    CHECK(run({"convert", bytes, "-o", folder / "triangles.obj"}).code == 0);

    const std::string plane = folder / "plane.msh";
    REQUIRE(run({"mesh", domains + "/square.json", "-o", plane, "--msh-version", version}).code ==
            0);
    const std::string flat = folder.write("flat.msh", lpq_test::msh_bytes(file_text(plane)));
    CHECK(run({"check", flat, "--domain", domains + "/square.json"}).code == 0);
    CHECK(run({"mesh", flat, "-o", folder / "flat.obj", "--keep-boundary"}).code == 0);
  }
}

TEST_CASE("the report of a surface counts repairs and repeats itself") {
  const ScratchFolder folder("surface_report");
  std::string text = box_stl();
  const std::size_t first = text.find("facet normal"),
                    second = text.find("facet normal", first + 1);
  text.insert(second, text.substr(first, second - first));  // one triangle twice
  const std::string box = folder.write("box.stl", text);
  const auto made =
      run({"mesh", box, "--report", folder / "report.json", "--size", "0.5", "--no-keep-groups"});
  INFO(made.err);
  REQUIRE(made.code == 0);
  CHECK(contains(made.out, "warning       OVERLAPPING_EDGES: 1 triangle was left out"));
  const std::string report = file_text(folder / "report.json");
  for (const char* part : {"\"quads\":40", "\"faces\":6", "\"charts\":6", "\"trianglesGiven\":13",
                           "\"duplicateTriangles\":1", "\"etaMean\":", "\"hash\":\"",
                           "\"cpuSeconds\":{\"repair\":", "\"size\":0.5", "\"keepGroups\":false",
                           "\"warnings\":[{\"code\":\"OVERLAPPING_EDGES\""}) {
    INFO(part);
    CHECK(contains(report, part));
  }
  for (const char* name : {"1.obj", "2.obj"})
    REQUIRE(run({"mesh", box, "-o", folder / name, "--size", "0.3", "--quiet"}).code == 0);
  CHECK(file_text(folder / "1.obj") == file_text(folder / "2.obj"));
}

TEST_CASE("the charts of a surface are written on request") {
  const ScratchFolder folder("surface_uv");
  const std::string box = folder.write("box.stl", box_stl());
  const auto made = run({"mesh", box, "--uv", folder / "{}.uv.obj", "--size", "0.5"});
  INFO(made.err);
  REQUIRE(made.code == 0);
  CHECK(contains(made.out, "box.uv.obj"));
  const std::string atlas = file_text(folder / "box.uv.obj");
  CHECK(contains(atlas, "\nvt 0."));
  CHECK(contains(atlas, "\ng box_face_1 chart_1\nf "));
  const auto refused = [&](std::vector<std::string> args) {
    const auto result = run(args);
    CHECK(result.code == 2);
    return result.err;
  };
  CHECK(contains(refused({"mesh", domains + "/square.json", "--uv", folder / "x.obj"}),
                 "Option --uv is for surfaces"));
  CHECK(contains(refused({"mesh", box, "--uv", folder / "x.msh"}), "must end in .obj"));
  CHECK(contains(refused({"mesh", box, "--uv", folder / "x.obj", "-o", folder / "x.obj"}),
                 "written twice"));
}

TEST_CASE("threads make the same file", "[slow]") {
  const ScratchFolder folder("surface_threads");
  const std::string box = folder.write("box.stl", box_stl());
  std::string alone;
  for (const char* threads : {"1", "2", "5"}) {
    const std::string obj = folder / (std::string("x") + threads + ".obj");
    CHECK(run({"mesh", box, "-o", obj, "--threads", threads, "--quiet"}).code == 0);
    const std::string bytes = file_text(obj);
    if (alone.empty()) alone = bytes;
    CHECK(bytes == alone);
  }
  CHECK(run({"mesh", box, "-o", folder / "y.obj", "--threads", "-1"}).code == 2);
}

TEST_CASE("what surfaces do not have is refused in words") {
  const ScratchFolder folder("surface_refused");
  const std::string box = folder.write("box.stl", box_stl());
  const std::string obj = folder / "x.obj";
  const auto message = [&](std::vector<std::string> args, int code) {
    const auto result = run(args);
    CHECK(result.code == code);
    CHECK_FALSE(std::filesystem::exists(obj));
    return result.err;
  };
  CHECK(contains(message({"mesh", box, "-o", obj, "--simplify", "1"}, 2),
                 "Option --simplify is for domains in the plane; this is a surface."));
  CHECK(contains(message({"mesh", domains + "/square.json", "-o", obj, "--feature-angle", "30"}, 2),
                 "Option --feature-angle is for surfaces; this is a domain in the plane."));
  CHECK(contains(message({"mesh", box, "-o", folder / "x.su2"}, 2), "must end in .obj, .msh"));
  CHECK(contains(message({"mesh", box, "-o", folder / "x.svg"}, 2), "a mesh in the plane"));
  CHECK(contains(message({"mesh", box, "-o", obj, "--svg", folder / "x.svg"}, 2), "--svg"));
  CHECK(contains(message({"mesh", box, "-o", obj, "--stages", folder / "s"}, 2), "--stages"));
  CHECK(contains(message({"mesh", box, "-o", folder / "x.inp", "--inp-element", "CPE4"}, 2),
                 "--inp-element S4"));
  CHECK(contains(message({"mesh", box, "-o", obj, "--turn", "100"}, 2), "between 0 and 90"));
  CHECK(contains(message({"mesh", box, "-o", obj, "--size", "1e-6"}, 3), "TOO_MANY_ELEMENTS"));
  CHECK(contains(message({"mesh", folder.write("broken.off", "OFF\n1"), "-o", obj}, 3),
                 "PARSE_ERROR"));
  CHECK(contains(message({"mesh", folder / "missing.stl", "-o", obj}, 3), "IO_ERROR"));
}

TEST_CASE("no input is overwritten") {
  const ScratchFolder folder("surface_overwritten");
  const std::string box = folder.write("box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n");
  const auto refused = run({"mesh", box, "-o", folder / "", "--size", "0.2"});
  CHECK(refused.code == 2);
  CHECK(contains(refused.err, "is an input"));
  CHECK(file_text(box).size() < 50);
}

TEST_CASE("options of surfaces are in the help and can be given") {
  const std::string help = run({"mesh", "--help"}).out;
  const lpq::SurfaceOptions options;
  lpq::each_field(options, [&](const char* name, const auto&, const lpq::OptionInfo&) {
    const std::string flag = lpq::option_flag(name);
    INFO(flag);
    CHECK(contains(help, flag.substr(2)));
  });
  CHECK(contains(help, "--[no-]keep-groups"));
  std::vector<std::string_view> args{"a.stl", "--no-keep-groups", "--size=3", "--growth", "0.5"};
  const auto parsed = lpq::parse_mesh_args(args);
  REQUIRE(parsed.has_value());
  CHECK_FALSE(parsed->surface_options.keep_groups);
  CHECK(parsed->surface_options.size == 3);
  CHECK(parsed->options.size == 3);
  CHECK(parsed->surface_options.growth == 0.5);
  CHECK(parsed->options.growth == 0.5);
  CHECK(parsed->given == std::vector<std::string>{"--keep-groups", "--size", "--growth"});
}
