// `lpquad check`: is a mesh file valid, and how good is it?
#include <algorithm>
#include <optional>

#include "cli/args.h"
#include "cli/check_outline.h"
#include "cli/check_surface.h"
#include "cli/commands.h"
#include "cli/expected_boundary.h"
#include "cli/files.h"
#include "cli/help.h"
#include "io/domain/domain_format.h"
#include "io/mesh/mesh_format.h"
#include "io/number.h"
#include "io/report_parts.h"
#include "mesh/validate.h"

namespace lpq {
namespace {

Result<OutputMesh> load_mesh(const std::string& name) {
  const auto format = mesh_format(name);
  if (format != MeshFormat::obj && format != MeshFormat::msh) {
    return Error{ErrorCode::parse_error,
                 "Only meshes in .obj and .msh files can be checked. Write or convert it as one of "
                 "these.",
                 {}};
  }
  const auto text = read_file(name);
  if (!text) return text.error();
  auto in_plane = read_mesh(*text, *format);
  if (in_plane) return in_plane;
  auto in_space = read_mesh(*text, *format, MeshScope::space);
  return in_space && !in_space->in_space() ? in_plane : in_space;
}

Result<Domain> load_domain(const std::string& name) {
  const auto text = read_file(name);
  if (!text) return text.error();
  const auto file = read_domain_file(name, *text);
  if (!file) return file.error();
  return make_domain(file->domain);
}

QuadMesh plain_mesh(const OutputMesh& mesh) {
  QuadMesh plain;
  plain.points = mesh.points;
  plain.faces = mesh.faces;
  plain.region = mesh.region;
  return plain;
}

std::string violation_text(const Violation& violation) {
  std::string text = "  " + violation.what;
  if (violation.face != none || violation.vertex != none) {
    text += " (at ";
    append_numbers(text, {violation.point.x, violation.point.y});
    text += ')';
  }
  return text + "\n";
}

std::string match_text(const BoundaryMatch& match) {
  std::string text = "boundary      domain edges kept ";
  append_integer(text, match.kept);
  text += ", divided ";
  append_integer(text, match.divided);
  return text + "\n";
}

int invalid(const std::string& name, const std::string& violations, const CliStreams& streams) {
  streams.err("'" + name + "' is not a valid mesh:\n" + violations);
  return exit_invalid;
}

/// What the violations have in common, if all faces share it.
std::string common_cause(const QuadMesh& mesh, const QuadQuality& quality) {
  if (quality.inverted == 0 || quality.inverted < static_cast<Index>(mesh.faces.size())) return {};
  return "  Every face runs clockwise; faces should run counter-clockwise.\n";
}

/// The verdict on a mesh in the plane; `domain` is null where only the mesh itself is judged.
int judge_plane(const std::string& name, const OutputMesh& mesh, const Domain* domain, bool quiet,
                const CliStreams& streams) {
  QuadMesh plain = plain_mesh(mesh);
  const QuadQuality quality = quad_quality(plain);
  std::string text = quality_text(quality);
  std::vector<std::array<Index, 2>> outline;
  if (domain != nullptr) {
    auto match = match_boundary(*domain, mesh);
    if (!match) {
      if (!quiet) streams.out(name + "\n" + text);
      print_error(streams, name, match.error());
      return exit_invalid;
    }
    text += match_text(*match);
    outline = std::move(match->outline);
    plain.walls = std::move(match->walls);
  } else {
    outline = own_outline(mesh);
  }
  std::vector<Violation> violations = validate(plain, {outline});
  if (violations.empty() && domain == nullptr)
    violations = check_own_outline(plain.points, outline);
  if (!quiet) streams.out(name + "\n" + text + (violations.empty() ? "valid         yes\n" : ""));
  if (violations.empty()) return exit_done;
  std::string lines = common_cause(plain, quality);
  for (const Violation& violation : violations) lines += violation_text(violation);
  return invalid(name, lines, streams);
}

int judge_in_space(const std::string& name, const OutputMesh& mesh, const SurfaceMesh* surface,
                   bool quiet, const CliStreams& streams) {
  const ShellVerdict verdict = judge_shell(mesh, surface);
  const bool valid = verdict.violations.empty();
  if (!quiet) streams.out(name + "\n" + verdict.text + (valid ? "valid         yes\n" : ""));
  return valid ? exit_done : invalid(name, verdict.violations, streams);
}

/// What the meshes are compared with.
struct References {
  std::optional<Domain> domain;
  std::optional<SurfaceMesh> surface;
};

int judge(const std::string& name, const References& wanted, bool quiet,
          const CliStreams& streams) {
  const auto mesh = load_mesh(name);
  if (!mesh) {
    print_error(streams, name, mesh.error());
    return exit_bad_input;
  }
  if (wanted.surface) return judge_in_space(name, *mesh, &*wanted.surface, quiet, streams);
  if (!mesh->in_space())
    return judge_plane(name, *mesh, wanted.domain ? &*wanted.domain : nullptr, quiet, streams);
  if (!wanted.domain) return judge_in_space(name, *mesh, nullptr, quiet, streams);
  const Error in_space{
      ErrorCode::bad_option, "The mesh does not lie in the plane: compare it with --surface.", {}};
  print_error(streams, name, in_space);
  return exit_bad_input;
}

/// False, with the error printed, where one cannot be read.
bool load_references(const CheckFiles& files, const CliStreams& streams, References& wanted) {
  const auto load_repaired = [&](const std::string& name) {
    return load_surface(name, files.weld);
  };
  const auto load = [&](const std::string& name, auto&& loader, auto& target) {
    if (name.empty()) return true;
    auto loaded = loader(name);
    if (loaded) {
      target = std::move(*loaded);
    } else {
      print_error(streams, name, loaded.error());
    }
    return loaded.has_value();
  };
  return load(files.domain, load_domain, wanted.domain) &&
         load(files.surface, load_repaired, wanted.surface);
}

Problem misuse(const CheckArgs& args) {
  if (args.inputs.empty()) return usage("No mesh given: lpquad check MESH.");
  if (!args.files.domain.empty() && !args.files.surface.empty())
    return usage("Give --domain or --surface, not both.");
  return std::nullopt;
}

}  // namespace

int check_command(std::span<const std::string_view> args, const CliStreams& streams) {
  const auto parsed = parse_check_args(args);
  if (parsed && parsed->help) {
    streams.out(check_help());
    return exit_done;
  }
  const Problem wrong = parsed ? misuse(*parsed) : parsed.error();
  if (wrong) {
    print_error(streams, {}, *wrong);
    return exit_usage;
  }
  References wanted;
  if (!load_references(parsed->files, streams, wanted)) return exit_bad_input;
  int worst = exit_done;
  for (const std::string& name : parsed->inputs)
    worst = std::max(worst, judge(name, wanted, parsed->files.quiet, streams));
  return worst;
}

}  // namespace lpq
