// A whole run in one call: the loop around a Mesher.
#pragma once

#include "base/monitor.h"
#include "base/result.h"
#include "domain/domain.h"
#include "mesh/output_mesh.h"
#include "pipeline/options.h"
#include "pipeline/report.h"
#include "pipeline/trace.h"

namespace lpq {

struct Outcome {
  OutputMesh mesh;
  Report report;
};

/// The whole run. `monitor` is asked between steps; stopping gives the error `cancelled`. With a
/// `trace` the intermediate values are left there. Errors: those of Mesher::start and Mesher::step;
/// cancelled.
Result<Outcome> mesh_domain(const DomainInput& input, const Options& options = {},
                            Monitor monitor = {}, Trace* trace = nullptr,
                            const UserFields& user = {});

}  // namespace lpq
