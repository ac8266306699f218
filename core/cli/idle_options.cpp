// See idle_options.h.
#include "cli/idle_options.h"

#include <algorithm>

#include "pipeline/attempts.h"

namespace lpq {
namespace {

class Idle {
 public:
  explicit Idle(const std::vector<std::string>& given) : given_(given) {}

  /// "--norm has no effect here: L_p does not run."
  void add(bool applies, const char* flag, const char* why) {
    if (!applies || std::find(given_.begin(), given_.end(), flag) == given_.end()) return;
    warnings_.push_back(
        {ErrorCode::ignored, std::string(flag) + " has no effect here: " + why, {}});
  }
  std::vector<Warning> take() { return std::move(warnings_); }

 private:
  const std::vector<std::string>& given_;
  std::vector<Warning> warnings_;
};

/// Those of the planar chain, wherever it runs. `traced`: the L_p energy is written at any rate.
void add_of_chain(const Options& options, bool seeds_given, bool traced, Idle& idle) {
  const std::vector<Attempt> attempts = plan_attempts(options, {.seeds_given = seeds_given});
  const bool optimises =
      attempts[0].iterations > 0 || (attempts[1].alternative && attempts[1].iterations > 0);
  const char* why = "no iterations of L_p are asked for. Give --iterations, or --seeds isotropic.";
  idle.add(!optimises && !traced, "--norm", why);
  idle.add(!optimises && options.restarts > 0, "--restarts", why);
  idle.add(seeds_given, "--seeds", "the domain brings points to start from.");
  idle.add(options.method == Method::paper && options.effort == Effort::high, "--effort",
           "the paper's chain ends before what it would lengthen.");
}

void add_of_files(const RunFiles& files, Idle& idle) {
  const bool written = !files.output.empty();
  idle.add(!written || files.format != MeshFormat::msh, "--msh-version",
           "no .msh file is written.");
  idle.add(!written || files.format != MeshFormat::inp, "--inp-element",
           "no .inp file is written.");
}

}  // namespace

std::vector<Warning> idle_options(const RunFiles& files, const MeshArgs& args, bool seeds_given) {
  Idle idle(args.given);
  const Options& options = args.options;
  add_of_chain(options, seeds_given, !files.stages.empty(), idle);
  idle.add((seeds_given || options.seeds != Seeds::isotropic) && options.method == Method::best &&
               options.effort == Effort::normal,
           "--seed",
           "nothing is drawn at random. It goes with --seeds isotropic or --effort high.");
  idle.add(options.keep_boundary && options.simplify > 0, "--simplify",
           "a kept boundary keeps all its points.");
  idle.add(!options.keep_boundary && options.allow_added_point, "--allow-added-point",
           "only a kept boundary can have an odd count. It goes with --keep-boundary.");
  idle.add(!options.keep_boundary && options.elements == Elements::one_triangle, "--elements",
           "one triangle is for the odd count of a kept boundary; without --keep-boundary all are "
           "quads.");
  idle.add(true, "--threads", "a domain in the plane is meshed in one thread.");
  add_of_files(files, idle);
  return idle.take();
}

std::vector<Warning> idle_surface_options(const RunFiles& files, const MeshArgs& args) {
  Idle idle(args.given);
  add_of_chain(window_options(args.surface_options), false, false, idle);
  add_of_files(files, idle);
  return idle.take();
}

}  // namespace lpq
