// `lpquad convert`: a surface as the mesher sees it, as triangles that other programs read.
#include <optional>

#include "cli/args.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/help.h"
#include "cli/surface_input.h"
#include "io/error_text.h"
#include "io/mesh/mesh_format.h"
#include "io/report_parts.h"
#include "io/surface/surface_format.h"
#include "io/surface/surface_write.h"
#include "surface/repair.h"
#include "surface/repair_warnings.h"

namespace lpq {
namespace {

Problem misuse(const ConvertArgs& args) {
  if (args.inputs.size() != 1)
    return usage("Give one surface: lpquad convert SURFACE -o TRIANGLES.obj.");
  if (args.files.output.empty()) return usage("Nothing to write. Give -o TRIANGLES.obj.");
  if (mesh_format(args.files.output) != MeshFormat::obj)
    return usage("'" + args.files.output + "' must end in .obj.");
  if (real_path(args.files.output) == real_path(args.inputs[0]))
    return usage("'" + args.files.output + "' is the input, and would be overwritten.");
  return std::nullopt;
}

std::string summary(const RepairedSurface& surface, const std::vector<Warning>& warnings,
                    const std::string& output) {
  std::string text;
  Facts facts;
  facts.count("triangles", surface.mesh.triangle_count())
      .count("vertices", surface.mesh.vertex_count())
      .count("groups", static_cast<std::int64_t>(surface.group_names.size()))
      .count("parts", surface.report.components)
      .count("border edges", surface.report.border_edges);
  if (!surface.body_names.empty())
    facts.count("bodies", static_cast<std::int64_t>(surface.body_names.size()));
  append_row(text, "surface", facts.text());
  for (const Warning& warning : warnings) append_row(text, "warning", error_text(warning));
  append_row(text, "wrote", output);
  return text;
}

/// Returns the summary.
Result<std::string> convert(const std::string& input, const std::string& bytes,
                            const ConvertFiles& files) {
  auto soup = read_surface_file(input, bytes);
  if (!soup) return soup.error();
  std::vector<Warning> warnings = std::move(soup->warnings);
  const auto surface = repair_surface(std::move(*soup), {.weld = files.weld});
  if (!surface) return surface.error();
  for (Warning& warning : repair_warnings(surface->report)) warnings.push_back(std::move(warning));
  if (const Problem unwritten =
          write_file(files.output,
                     write_surface_obj(surface->mesh, surface->group_names, surface->body_names)))
    return *unwritten;
  return summary(*surface, warnings, files.output);
}

}  // namespace

int convert_command(std::span<const std::string_view> args, const CliStreams& streams) {
  const auto parsed = parse_convert_args(args);
  if (parsed && parsed->help) {
    streams.out(convert_help());
    return exit_done;
  }
  const Problem wrong = parsed ? misuse(*parsed) : parsed.error();
  if (wrong) {
    print_error(streams, {}, *wrong);
    return exit_usage;
  }
  const std::string& input = parsed->inputs[0];
  const auto bytes = read_input(input, {.size = parsed->files.size});
  if (!bytes) {
    print_error(streams, input, bytes.error());
    return exit_bad_input;
  }
  const auto done = convert(input, *bytes, parsed->files);
  if (!done) {
    print_error(streams, input, done.error());
    return exit_code(done.error().code);
  }
  if (!parsed->files.quiet) streams.out(*done);
  return exit_done;
}

}  // namespace lpq
