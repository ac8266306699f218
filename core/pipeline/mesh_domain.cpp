// See mesh_domain.h.
#include "pipeline/mesh_domain.h"

#include "pipeline/iterate_log.h"
#include "pipeline/mesher.h"

namespace lpq {
namespace {

// After a step of L_p; once that is over, its optimiser is gone.
int iterations_done(const Mesher& mesher) {
  if (mesher.stage() == Stage::optimise) return mesher.iterations();
  return static_cast<int>(mesher.report().energy_history.size()) - 1;
}

}  // namespace

Result<Outcome> mesh_domain(const DomainInput& input, const Options& options, Monitor monitor,
                            Trace* trace, const UserFields& user) {
  auto mesher = Mesher::start(input, options, user);
  if (!mesher) return mesher.error();
  if (trace != nullptr) mesher->keep_trace();
  IterateLog log;
  while (mesher->stage() != Stage::done) {
    const Progress progress{stage_name(mesher->stage()), mesher->iterations(),
                            mesher->max_iterations(), mesher->energy()};
    if (!monitor(progress)) return Error{ErrorCode::cancelled, "The run was cancelled.", {}};
    const Stage before = mesher->stage();
    if (const auto stage = mesher->step(); !stage) return stage.error();
    if (trace == nullptr) continue;
    if (before == Stage::seeds) log = IterateLog();  // another attempt
    if (before == Stage::optimise) log.add(iterations_done(*mesher), mesher->triangles());
  }
  if (trace != nullptr) {
    *trace = mesher->take_trace();
    const bool optimised = !mesher->report().energy_history.empty();
    if (optimised) trace->iterates = log.take();  // of another chain, if not
  }
  return Outcome{mesher->take_output(), mesher->take_report()};
}

}  // namespace lpq
