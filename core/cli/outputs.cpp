// See outputs.h.
#include "cli/outputs.h"

#include <algorithm>
#include <filesystem>

#include "cli/files.h"
#include "io/stages.h"

namespace lpq {
namespace {

constexpr std::string_view marker = "{}";

bool is_folder(const std::string& name) {
  if (name.empty()) return false;
  if (name.back() == '/' || name.back() == '\\') return true;
  std::error_code ignored;
  return std::filesystem::is_directory(name, ignored);
}

std::string expand(std::string pattern, const std::string& stem) {
  for (std::size_t at = 0; (at = pattern.find(marker, at)) != std::string::npos;
       at += stem.size()) {
    pattern.replace(at, marker.size(), stem);
  }
  return pattern;
}

struct Output {
  std::string file, name;  // what it is, and how it was given
};

bool before(const Output& one, const Output& two) { return one.file < two.file; }

std::vector<Output> outputs_of(const std::vector<RunFiles>& runs) {
  std::vector<Output> outputs;
  for (const RunFiles& run : runs)
    for (const std::string* name : {&run.output, &run.report, &run.stages, &run.svg, &run.uv})
      if (!name->empty()) outputs.push_back({real_path(*name), *name});
  std::stable_sort(outputs.begin(), outputs.end(), before);
  return outputs;
}

/// Two runs with one file would silently lose a result.
std::string first_repeated(const std::vector<Output>& outputs) {
  const auto repeated =
      std::adjacent_find(outputs.begin(), outputs.end(),
                         [](const Output& one, const Output& two) { return one.file == two.file; });
  return repeated == outputs.end() ? std::string() : repeated->name;
}

/// A folder of .obj surfaces as -o would replace them by their meshes.
std::string first_overwritten(const std::vector<RunFiles>& runs,
                              const std::vector<Output>& outputs) {
  for (const RunFiles& run : runs) {
    const Output input{real_path(run.input), {}};
    const auto found = std::lower_bound(outputs.begin(), outputs.end(), input, before);
    if (found != outputs.end() && found->file == input.file) return found->name;
  }
  return {};
}

/// The first input or output that has the place of a file in a folder of stages. Which of those a
/// run writes is not known before, so none of their names is free.
std::string first_in_stages(const std::vector<RunFiles>& runs, std::vector<Output> files) {
  std::vector<std::string> folders;
  for (const RunFiles& run : runs) {
    files.push_back({real_path(run.input), run.input});
    // Through a name in it, as folders may be given with a slash behind.
    const std::filesystem::path inside(
        real_path((std::filesystem::path(run.stages) / "_").string()));
    if (!run.stages.empty()) folders.push_back(inside.parent_path().string());
  }
  std::sort(folders.begin(), folders.end());
  for (const Output& one : files) {
    const std::filesystem::path place(one.file);
    if (std::binary_search(folders.begin(), folders.end(), place.parent_path().string()) &&
        is_stage_name(place.filename().string()))
      return one.name;
  }
  return {};
}

/// Of one input; `files` are patterns, that of the output with a name.
Result<RunFiles> files_for(const std::string& input, const MeshFiles& files) {
  const std::string stem = file_stem(input);
  RunFiles run{input,
               expand(files.output, stem),
               expand(files.report, stem),
               expand(files.stages, stem),
               expand(files.svg, stem),
               expand(files.uv, stem)};
  if (!run.uv.empty() && mesh_format(run.uv) != MeshFormat::obj)
    return usage("'" + run.uv + "' must end in .obj: --uv writes texture coordinates.");
  if (run.output.empty()) return run;
  const auto format = mesh_format(run.output);
  if (!format) return usage("'" + run.output + "' must end in " + mesh_endings() + ".");
  run.format = *format;
  return run;
}

}  // namespace

Result<std::vector<RunFiles>> plan_files(const MeshArgs& args) {
  MeshFiles files = args.files;
  if (args.inputs.empty())
    return usage("No input. Give a domain: lpquad mesh DOMAIN.json -o MESH.");
  if (files.output.empty() && files.report.empty() && files.stages.empty() && files.svg.empty() &&
      files.uv.empty()) {
    return usage("Nothing to write. Give -o MESH, --svg, --uv, --report or --stages.");
  }
  if (is_folder(files.output))
    files.output = (std::filesystem::path(files.output) / "{}.obj").string();
  std::vector<RunFiles> runs;
  for (const std::string& input : args.inputs) {
    auto run = files_for(input, files);
    if (!run) return run.error();
    runs.push_back(*std::move(run));
  }
  const std::vector<Output> outputs = outputs_of(runs);
  const std::string repeated = first_repeated(outputs);
  if (!repeated.empty())
    return usage(
        "'" + repeated +
        "' would be written twice. Give every file a name of its own; with several inputs, "
        "put {} into the names.");
  const std::string overwritten = first_overwritten(runs, outputs);
  if (!overwritten.empty())
    return usage("'" + overwritten + "' is an input, and would be overwritten.");
  const std::string in_stages = first_in_stages(runs, outputs);
  if (!in_stages.empty())
    return usage(
        "'" + in_stages +
        "' would be overwritten by a file of --stages. Give --stages a folder of its own.");
  return runs;
}

}  // namespace lpq
