// `lpquad check`: is a mesh file valid, and how good is it?
#include <algorithm>

#include "cli/args.h"
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
    return Error{ErrorCode::parse_error, "Only .obj and .msh meshes can be checked.", {}};
  }
  const auto text = read_file(name);
  if (!text) return text.error();
  return read_mesh(*text, *format);
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
    append_number(text, violation.point.x);
    text += ' ';
    append_number(text, violation.point.y);
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

/// The verdict on one mesh; `domain` is null where only the mesh itself is judged.
int judge(const std::string& name, const OutputMesh& mesh, const Domain* domain, bool quiet,
          const CliStreams& streams) {
  QuadMesh plain = plain_mesh(mesh);
  std::string text = quality_text(quad_quality(plain));
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
  const std::vector<Violation> violations = validate(plain, {outline});
  if (!quiet) streams.out(name + "\n" + text + (violations.empty() ? "valid         yes\n" : ""));
  if (violations.empty()) return exit_done;
  std::string verdict = "'" + name + "' is not a valid mesh:\n";
  for (const Violation& violation : violations) verdict += violation_text(violation);
  streams.err(verdict);
  return exit_invalid;
}

}  // namespace

int check_command(std::span<const std::string_view> args, const CliStreams& streams) {
  const auto parsed = parse_check_args(args);
  if (parsed && parsed->help) {
    streams.out(check_help());
    return exit_done;
  }
  if (!parsed || parsed->inputs.empty()) {
    const Error none_given{ErrorCode::bad_option, "No mesh given: lpquad check MESH.", {}};
    print_error(streams, {}, parsed ? none_given : parsed.error());
    return exit_usage;
  }
  Domain domain;
  if (!parsed->files.domain.empty()) {
    auto loaded = load_domain(parsed->files.domain);
    if (!loaded) {
      print_error(streams, parsed->files.domain, loaded.error());
      return exit_bad_input;
    }
    domain = std::move(*loaded);
  }
  int worst = exit_done;
  for (const std::string& name : parsed->inputs) {
    const auto mesh = load_mesh(name);
    if (!mesh) {
      print_error(streams, name, mesh.error());
      worst = std::max<int>(worst, exit_bad_input);
      continue;
    }
    const Domain* wanted = parsed->files.domain.empty() ? nullptr : &domain;
    worst = std::max(worst, judge(name, *mesh, wanted, parsed->files.quiet, streams));
  }
  return worst;
}

}  // namespace lpq
