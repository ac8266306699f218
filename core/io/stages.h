// Every intermediate value of a run as files, for pictures and for checks from outside: the
// background with its crosses and sizes, the iterations of L_p (iterates.h), the triangles, the
// Voronoi cells, the energy with its gradient, the matching with its certificate, and the quads
// after each stage.
#pragma once

#include <string>
#include <string_view>

#include "base/function_ref.h"
#include "pipeline/report.h"
#include "pipeline/trace.h"

namespace lpq {

/// Called with one file at a time: a plain name such as "cells.json", and its content.
using FileSink = FunctionRef<void(std::string_view name, const std::string& content)>;

/// All coordinates, sizes and gradients in the caller's units.
void write_stages(const Trace& trace, const Report& report, FileSink sink);

/// Whether write_stages() writes a file of this name, whatever the run is.
bool is_stage_name(std::string_view name);

/// The matching and the proof that it is optimal, with duals in whole units ("3.5"):
/// {"n", "edges":[[u,v,cost]..], "matching":[[u,v]..], "y":[..], "blossoms":[{"nodes","z"}..]}.
std::string write_matching_json(std::span<const CostEdge> graph, const Matching& matching);

}  // namespace lpq
