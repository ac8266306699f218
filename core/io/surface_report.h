// The report of a surface run as JSON and as text.
#pragma once

#include <string>

#include "io/report_parts.h"
#include "shell/mesh_surface.h"

namespace lpq {

/// One object: counts, quality, sizes, distances, repairs, bodies, options, times and warnings.
/// Members that are in the report of a domain have the same names here.
std::string write_surface_report_json(const ShellOutcome& outcome, const SurfaceOptions& options,
                                      const ReportFormat& format = {});

/// How far mesh and surface lie apart, as a row of the text.
std::string distance_text(const SurfaceDistance& distance);

/// A dozen lines for a terminal.
std::string surface_report_text(const ShellOutcome& outcome);

}  // namespace lpq
