// Arguments to values: every option of the tables, every way to get one wrong.
#include "cli/args.h"

#include <filesystem>

#include "catch.h"
#include "cli/help.h"
#include "cli/outputs.h"
#include "support/cli_runner.h"

using namespace lpq;

namespace {

Result<MeshArgs> parse(std::vector<std::string_view> args) { return parse_mesh_args(args); }

std::string message(std::vector<std::string_view> args) {
  const auto result = parse_mesh_args(args);
  REQUIRE_FALSE(result.has_value());
  CHECK(result.error().code == ErrorCode::bad_option);
  return result.error().message;
}

}  // namespace

TEST_CASE("options stand anywhere and in both forms") {
  const auto args =
      parse({"a.json", "--norm", "8", "-o", "x.obj", "--keep-boundary", "b.json",
             "--elements=quad-dominant", "--seed=18446744073709", "--", "--odd.json"});
  REQUIRE(args.has_value());
  CHECK(args->inputs == std::vector<std::string>{"a.json", "b.json", "--odd.json"});
  CHECK(args->options.norm == 8);
  CHECK(args->options.keep_boundary);
  CHECK(args->options.elements == Elements::quad_dominant);
  CHECK(args->options.seed == 18446744073709u);
  CHECK(args->files.output == "x.obj");
  CHECK(parse({"--iterations", "-1"}).has_value());
  CHECK(parse({"-o=x.obj"})->files.output == "x.obj");
  CHECK(parse({"-"})->inputs == std::vector<std::string>{"-"});
}

TEST_CASE("a wrong option names the nearest one") {
  CHECK(message({"--nrom", "6"}) == "There is no option --nrom. Did you mean --norm?");
  CHECK(message({"--keep"}) == "There is no option --keep. Did you mean --keep-boundary?");
  CHECK(message({"--keepBoundary"}).find("--keep-boundary") != std::string::npos);
  CHECK(message({"--xyzzy"}) == "There is no option --xyzzy.");
  CHECK(message({"-q"}).find("There is no option -q.") == 0);
}

TEST_CASE("a wrong value says what was expected") {
  CHECK(message({"--norm", "30"}) == "Option --norm must be a number between 2 and 20, not '30'.");
  CHECK(message({"--norm", "six"}).find("between 2 and 20") != std::string::npos);
  CHECK(message({"--norm=nan"}).find("between 2 and 20") != std::string::npos);
  CHECK(message({"--size=-1"}).find("between 0 and 1e+300") != std::string::npos);
  CHECK(message({"--iterations", "2.5"}) ==
        "Option --iterations must be a whole number, not '2.5'.");
  CHECK(message({"--method", "good"}) == "Option --method must be best or paper, not 'good'.");
  CHECK(message({"--size"}) == "Option --size needs a value.");
  CHECK(message({"--strict=yes"}) == "Option --strict takes no value.");
  CHECK(message({"--report", ""}) == "Option --report must be a file name, not ''.");
}

TEST_CASE("a size and a number of quads contradict each other before anything is read") {
  CHECK(message({"part.stl", "--size", "1", "--quads=500"}).find("not both") != std::string::npos);
  const auto args = parse({"part.stl", "--quads=500"});
  REQUIRE(args.has_value());
  CHECK(args->options.quads == 500);
  CHECK(args->surface_options.quads == 500);
}

TEST_CASE("every option of the tables is in the help and can be given") {
  const std::string help = mesh_help();
  const Options options;
  each_field(options, [&](const char* name, const auto& value, const OptionInfo& info) {
    const std::string flag = option_flag(name);
    INFO(flag);
    CHECK(help.find(flag) != std::string::npos);
    CHECK(std::string_view(info.help).size() > 10);
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<T, bool>) {
      CHECK(parse({flag}).has_value());
    } else if constexpr (std::is_enum_v<T>) {
      for (const char* choice : ChoiceNames<T>::names) CHECK(parse({flag, choice}).has_value());
    } else if constexpr (std::is_integral_v<T>) {
      CHECK(parse({flag, std::to_string(static_cast<long long>(info.min))}).has_value());
    } else {
      CHECK(parse({flag, std::to_string(info.min)}).has_value());
    }
  });
  for (std::size_t at = 0, end = 0; at < help.size(); at = end + 1) {
    end = std::min(help.find('\n', at), help.size());
    CHECK(end - at <= 96);
  }
}

TEST_CASE("file names are planned before any work") {
  MeshArgs args;
  CHECK(plan_files(args).error().message.find("No input") == 0);
  args.inputs = {"in/a.json", "in/b.json"};
  CHECK(plan_files(args).error().message.find("Nothing to write") == 0);
  args.files.output = "out/mesh.obj";
  CHECK(plan_files(args).error().message.find("'out/mesh.obj' would be written twice") == 0);
  args.files.output = "out/{}-{}.msh";
  auto runs = plan_files(args);
  REQUIRE(runs.has_value());
  CHECK((*runs)[1].output == "out/b-b.msh");
  args.files.output = "out/";
  runs = plan_files(args);
  REQUIRE(runs.has_value());
  CHECK((*runs)[0].output == "out/a.obj");
  args.files.report = "r.json";
  CHECK_FALSE(plan_files(args).has_value());
  args.files.report.clear();
  args.files.output = "{}.stl";
  CHECK(plan_files(args).error().message == "'a.stl' must end in " + mesh_endings() + ".");
  args.inputs = {"x/a.json", "y/a.json"};
  args.files.output = "out/";
  CHECK_FALSE(plan_files(args).has_value());
}

TEST_CASE("stages overwrite no input and no other output") {
  const lpq_test::ScratchFolder folder("planned_stages");
  std::filesystem::create_directories(folder / "sg");
  std::filesystem::create_directory_symlink("sg", folder / "link");
  for (const std::string& stages : {folder / "sg", folder / "sg/", folder / "link"}) {
    MeshArgs args;
    args.inputs = {folder / "a.json"};
    args.files.stages = stages;
    args.files.output = folder / "sg/mesh.obj";
    CHECK(plan_files(args).has_value());
    args.files.output = folder / "sg/quads-1-matched.obj";
    CHECK(plan_files(args).error().message.find("--stages") != std::string::npos);
    args.files.output = folder / "link/background.obj";
    CHECK(plan_files(args).error().message.find("--stages") != std::string::npos);
    args.files.output = folder / "background.obj";
    CHECK(plan_files(args).has_value());
    args.inputs = {folder / "sg/triangles.json"};
    CHECK(plan_files(args).error().message.find("--stages") != std::string::npos);
  }
  MeshArgs args;  // a folder that is not there yet
  args.inputs = {"a.json"};
  args.files.stages = folder / "new/";
  args.files.report = folder / "new/energy.json";
  CHECK_FALSE(plan_files(args).has_value());
}

TEST_CASE("an option is no file name of another, unless it is given as one") {
  const auto swallowed = parse({"a.json", "--report", "--quiet"});
  REQUIRE_FALSE(swallowed.has_value());
  CHECK(swallowed.error().message.find("--report needs a value") != std::string::npos);
  CHECK_FALSE(parse({"a.json", "--size", "--quiet"}).has_value());
  const auto meant = parse({"a.json", "--report=--quiet", "-o", "-"});
  REQUIRE(meant.has_value());
  CHECK(meant->files.report == "--quiet");
  CHECK(meant->files.output == "-");
  CHECK_FALSE(meant->files.quiet);
}

TEST_CASE("the beginning of one option's name means that option") {
  CHECK(parse({"--h"}).error().message.find("Did you mean --help?") != std::string::npos);
  CHECK(parse({"--rep", "x"}).error().message.find("Did you mean --report?") != std::string::npos);
}

TEST_CASE("no file is written over another or over an input, whatever it is called") {
  const lpq_test::ScratchFolder folder("planned");
  MeshArgs args;
  args.inputs = {"c.json"};
  args.files.output = (std::filesystem::current_path() / "c.json").string();
  CHECK(plan_files(args).error().message.find("is an input") != std::string::npos);
  args.inputs = {folder.write("a.json", "{}")};
  std::filesystem::create_symlink("a.json", folder / "b.json");
  args.files.output = folder / "b.json";
  CHECK(plan_files(args).error().message.find("is an input") != std::string::npos);
  args.files.output = "./b.msh";
  args.files.report = "b.msh";
  CHECK(plan_files(args).error().message.find("would be written twice") != std::string::npos);
  args.files.report = "c.msh";
  CHECK(plan_files(args).has_value());
}
