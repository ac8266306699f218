// `lpquad mesh`: read, mesh, write.
#include <algorithm>
#include <filesystem>
#include <new>

#include "cli/args.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/help.h"
#include "cli/idle_options.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/surface_command.h"
#include "cli/surface_input.h"
#include "io/domain/domain_format.h"
#include "io/error_text.h"
#include "io/file_kind.h"
#include "io/picture/svg.h"
#include "io/report.h"
#include "io/stages.h"
#include "io/surface/surface_format.h"
#include "pipeline/mesh_domain.h"

namespace lpq {
namespace {

/// Writes files until one cannot be written.
class Writer {
 public:
  void write(const std::string& name, const std::string& content) {
    if (!failure_) failure_ = write_file(name, content);
  }
  const Problem& failure() const { return failure_; }

 private:
  Problem failure_;
};

class Run {
 public:
  Run(const RunFiles& files, const MeshArgs& args, const CliStreams& streams)
      : files_(files), args_(args), streams_(streams) {}

  int operator()() {
    const SurfaceOptions& asked = args_.surface_options;
    const auto text = read_input(files_.input, {asked.size, static_cast<double>(asked.quads)});
    if (!text) return fail(text.error(), exit_bad_input);
    const bool is_surface = is_cad_file(files_.input) || is_surface_file(files_.input, *text);
    const bool is_known =
        is_surface || domain_format_by_ending(files_.input) || domain_format_by_content(*text);
    if (!is_known) return fail(unknown_format(files_.input, *text));
    if (const auto wrong = misplaced_option(files_, args_, is_surface)) return fail(*wrong);
    return is_surface ? surface(*text) : domain(*text);
  }

  /// Prints the error; with --report it is also written as JSON.
  int fail(const Error& error) { return fail(error, exit_code(error.code)); }

 private:
  int domain(const std::string& text) {
    auto file = read_domain_file(files_.input, text);
    if (!file) return fail(file.error());
    Trace trace;
    auto outcome = mesh(file->domain, files_.stages.empty() ? nullptr : &trace);
    if (!outcome) return fail(outcome.error());
    // The file's come first, then those of the command line.
    std::vector<Warning> warnings = std::move(file->warnings);
    for (const std::vector<Warning>& more :
         {idle_options(files_, args_, !file->domain.seeds.empty()), outcome->report.warnings})
      warnings.insert(warnings.end(), more.begin(), more.end());
    outcome->report.warnings = std::move(warnings);
    Writer writer;
    write_results(writer, *outcome, trace);
    if (writer.failure()) return fail(*writer.failure());
    if (!args_.files.quiet) print_summary(report_text(outcome->report, outcome->mesh));
    return exit_done;
  }

  int surface(const std::string& text) {
    std::string summary;
    {
      ProgressLine progress(streams_, !args_.files.quiet);
      auto done = mesh_surface_file(files_, args_, text, progress.monitor());
      if (!done) return fail(done.error());
      summary = std::move(*done);
    }
    if (!args_.files.quiet) print_summary(summary);
    return exit_done;
  }

  int fail(const Error& error, int code) {
    print_error(streams_, files_.input, error);
    if (!files_.report.empty()) {
      if (const Problem unwritten = write_file(files_.report, write_error_json(error)))
        print_error(streams_, {}, *unwritten);
    }
    return code;
  }

  Result<Outcome> mesh(const DomainInput& domain, Trace* trace) const {
    ProgressLine progress(streams_, !args_.files.quiet);
    return mesh_domain(domain, args_.options, progress.monitor(), trace);
  }

  void write_results(Writer& writer, const Outcome& outcome, const Trace& trace) const {
    if (!files_.output.empty()) {
      writer.write(files_.output, write_mesh(outcome.mesh, files_.format, args_.files.write));
    }
    if (!files_.svg.empty()) writer.write(files_.svg, draw_quads(outcome.mesh));
    if (!files_.report.empty()) {
      writer.write(files_.report, write_report_json(outcome.report, outcome.mesh, args_.options));
    }
    if (!files_.stages.empty()) {
      const std::filesystem::path folder(files_.stages);
      write_stages(trace, outcome.report, [&](std::string_view name, const std::string& content) {
        writer.write((folder / name).string(), content);
      });
    }
  }

  void print_summary(const std::string& report) const {
    std::string text;
    if (args_.inputs.size() > 1) text += files_.input + "\n";
    text += report;
    for (const std::string* name :
         {&files_.output, &files_.svg, &files_.uv, &files_.report, &files_.stages}) {
      if (!name->empty()) text += "wrote         " + *name + "\n";
    }
    streams_.out(text);
  }

  const RunFiles& files_;
  const MeshArgs& args_;
  const CliStreams& streams_;
};

}  // namespace

int mesh_command(std::span<const std::string_view> args, const CliStreams& streams) {
  const auto parsed = parse_mesh_args(args);
  if (parsed && parsed->help) {
    streams.out(mesh_help());
    return exit_done;
  }
  const auto runs = parsed ? plan_files(*parsed) : parsed.error();
  if (!runs) {
    print_error(streams, {}, runs.error());
    return exit_usage;
  }
  int worst = exit_done;
  for (const RunFiles& files : *runs) {
    Run run(files, *parsed, streams);
    try {
      worst = std::max(worst, run());
    } catch (const std::bad_alloc&) {
      const Error error{ErrorCode::out_of_memory, "There is not enough memory for this mesh.", {}};
      worst = std::max(worst, run.fail(error));
    }
  }
  return worst;
}

}  // namespace lpq
