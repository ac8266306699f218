// Arguments to values. The mesher's options come from its option tables (pipeline/options.h, for
// surfaces shell/options.h), the rest - files and how to print - from a second table of the same
// kind.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "io/mesh/mesh_format.h"
#include "pipeline/options.h"
#include "shell/options.h"

namespace lpq {

/// Of surfaces that are repaired but not meshed.
inline constexpr OptionInfo weld_info{0, 0.01, "",
                                      "Points nearer than this share of the diagonal become one."};

/// What `lpquad mesh` reads and writes. "" = not asked for.
struct MeshFiles {
  std::string output, report, stages, svg, uv;
  MeshWriteOptions write;
  int threads = 0;
  bool quiet = false;
};

template <class O, class F>
requires std::is_same_v<std::remove_const_t<O>, MeshFiles>
void each_field(O& o, F&& visit) {
  static const std::string output_help =
      "The mesh: " + mesh_endings() + "; for several inputs a folder, or a name with {}.";
  visit("output", o.output, OptionInfo{0, 0, "file", output_help.c_str()});
  visit("svg", o.svg, OptionInfo{0, 0, "file", "A picture of the mesh (domains only)."});
  visit("uv", o.uv,
        OptionInfo{0, 0, "file", "The charts of a surface: an .obj with texture coordinates."});
  visit("report", o.report,
        OptionInfo{0, 0, "file",
                   "Counts, quality, energies and times as JSON; on failure the error."});
  visit("stages", o.stages,
        OptionInfo{0, 0, "folder", "Every intermediate value of the run (domains only)."});
  each_field(o.write, visit);
  visit(
      "threads", o.threads,
      OptionInfo{0, 1024, "",
                 "For the charts of a surface, with the same result (native program); 0 = as many "
                 "as the machine runs at once."});
  visit("quiet", o.quiet, OptionInfo{0, 0, "", "Print nothing but errors."});
}

struct CheckFiles {
  std::string domain, surface;
  double weld = SurfaceOptions{}.weld;
  bool quiet = false;
};

template <class O, class F>
requires std::is_same_v<std::remove_const_t<O>, CheckFiles>
void each_field(O& o, F&& visit) {
  visit(
      "domain", o.domain,
      OptionInfo{0, 0, "file", "The domain it should be a mesh of: its boundary is compared too."});
  visit("surface", o.surface,
        OptionInfo{0, 0, "file",
                   "The surface it should be a mesh of: topology and distances are compared."});
  visit("weld", o.weld, weld_info);
  visit("quiet", o.quiet, OptionInfo{0, 0, "", "Print nothing but errors."});
}

/// What `lpquad convert` reads and writes.
struct ConvertFiles {
  std::string output;
  double size = 0;
  double weld = SurfaceOptions{}.weld;
  bool quiet = false;
};

template <class O, class F>
requires std::is_same_v<std::remove_const_t<O>, ConvertFiles>
void each_field(O& o, F&& visit) {
  visit("output", o.output, OptionInfo{0, 0, "file", "The triangles: .obj, groups kept."});
  visit("size", o.size,
        OptionInfo{0, 1e300, "length",
                   "Of the quads to come: triangles of CAD files are fine enough for it."});
  visit("weld", o.weld, weld_info);
  visit("quiet", o.quiet, OptionInfo{0, 0, "", "Print nothing but errors."});
}

struct ConvertArgs {
  std::vector<std::string> inputs;
  ConvertFiles files;
  bool help = false;
};

struct MeshArgs {
  std::vector<std::string> inputs;
  MeshFiles files;
  Options options;
  SurfaceOptions surface_options;
  std::vector<std::string> given;  // flags of the options, as in "--size"
  bool help = false;
};

struct CheckArgs {
  std::vector<std::string> inputs;
  CheckFiles files;
  bool help = false;
};

/// A wrong command line.
inline Error usage(std::string message) { return {ErrorCode::bad_option, std::move(message), {}}; }

/// "keepBoundary" -> "--keep-boundary"
std::string option_flag(std::string_view name);

/// Is the flag one of a table's options?
template <class Table>
bool has_option(const Table& table, std::string_view flag) {
  bool found = false;
  each_field(table, [&](const char* name, const auto&, const OptionInfo&) {
    found = found || option_flag(name) == flag;
  });
  return found;
}

/// Options may stand anywhere, as `--name value` or, for a value that begins with `--`,
/// `--name=value`; `-o` is --output, `-h` is
/// --help; `--no-name` sets a flag to false; after `--` everything is an input. An option that
/// domains and surfaces share is set for both. Errors: bad_option, with the nearest name where an
/// option does not exist.
Result<MeshArgs> parse_mesh_args(std::span<const std::string_view> args);
Result<CheckArgs> parse_check_args(std::span<const std::string_view> args);
Result<ConvertArgs> parse_convert_args(std::span<const std::string_view> args);

}  // namespace lpq
