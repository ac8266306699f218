// See surface_command.h.
#include "cli/surface_command.h"

#include "cli/files.h"
#include "cli/idle_options.h"
#include "io/atlas.h"
#include "io/surface/surface_format.h"
#include "io/surface_report.h"
#include "shell/mesh_surface.h"
#include "shell/output.h"

namespace lpq {
namespace {

/// What a run on a surface cannot write.
Problem unwritable(const RunFiles& files, const MeshArgs& args) {
  if (!files.stages.empty()) return usage("Option --stages is for domains in the plane.");
  if (!files.svg.empty()) return usage("Option --svg is for domains in the plane.");
  if (!files.output.empty() && !is_shell_format(files.format))
    return usage("'" + files.output +
                 "' would be a mesh in the plane. The mesh of a surface must end in " +
                 shell_endings() + ".");
  for (const std::string& flag : args.given)
    if (flag == "--inp-element" && args.files.write.inp_element != InpElement::s4)
      return usage("The elements of a surface are shells: --inp-element S4.");
  return std::nullopt;
}

}  // namespace

Problem misplaced_option(const RunFiles& files, const MeshArgs& args, bool is_surface) {
  for (const std::string& flag : args.given) {
    const bool of_domain = has_option(args.options, flag);
    const bool of_surface = has_option(args.surface_options, flag);
    if (is_surface && of_domain && !of_surface)
      return usage("Option " + flag + " is for domains in the plane; this is a surface.");
    if (!is_surface && of_surface && !of_domain)
      return usage("Option " + flag + " is for surfaces; this is a domain in the plane.");
  }
  if (is_surface) return unwritable(files, args);
  if (!files.uv.empty())
    return usage("Option --uv is for surfaces; this is a domain in the plane.");
  return std::nullopt;
}

Result<std::string> mesh_surface_file(const RunFiles& files, const MeshArgs& args,
                                      const std::string& bytes, Monitor monitor) {
  auto soup = read_surface_file(files.input, bytes);
  if (!soup) return soup.error();
  auto outcome = mesh_surface(std::move(*soup), args.surface_options, monitor, args.files.threads);
  if (!outcome) return outcome.error();
  for (Warning& idle : idle_surface_options(files, args))
    outcome->report.warnings.push_back(std::move(idle));
  if (!files.output.empty()) {
    if (const Problem unwritten = write_file(
            files.output, write_mesh(shell_output(*outcome), files.format, args.files.write)))
      return *unwritten;
  }
  if (!files.uv.empty()) {
    if (const Problem unwritten = write_file(files.uv, write_atlas_obj(*outcome)))
      return *unwritten;
  }
  if (!files.report.empty()) {
    if (const Problem unwritten =
            write_file(files.report, write_surface_report_json(*outcome, args.surface_options)))
      return *unwritten;
  }
  return surface_report_text(*outcome);
}

}  // namespace lpq
