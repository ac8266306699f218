// The report of a run as JSON and as text.
#pragma once

#include <string>

#include "io/report_parts.h"
#include "mesh/output_mesh.h"
#include "pipeline/options.h"
#include "pipeline/report.h"

namespace lpq {

/// One object: counts, quality, energies, times, warnings and the options it ran with.
std::string write_report_json(const Report& report, const OutputMesh& mesh, const Options& options,
                              const ReportFormat& format = {});

/// A dozen lines for a terminal.
std::string report_text(const Report& report, const OutputMesh& mesh);

}  // namespace lpq
