// What happened in a run: one struct, printed by the command line and dumped as JSON.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "field/field.h"
#include "lpcvt/restarts.h"
#include "mesh/quality.h"

namespace lpq {

struct StageTime {
  std::string stage;
  double cpu_seconds = 0;
};

/// Achieved edge length over target, over all edges.
struct SizeFidelity {
  double p10 = 0, p50 = 0, p90 = 0;
  double min = 0, max = 0;
  double off = 0;  // by how much the longer of the two exceeds the other, mean
};

/// Of the ratios of all edges, in any order.
SizeFidelity size_fidelity(std::vector<double> ratios);

struct Report {
  Index boundary_nodes = 0;
  Index boundary_edges = 0;
  Index interior_vertices = 0;
  Index seeds = 0;
  double expected_seeds = 0;
  std::vector<Singularity> singularities;  // unit frame
  LpStatus lp_status = LpStatus::converged;
  std::vector<double> energy_history;  // Fig. 19; empty when L_p did not run
  std::vector<double> gradient_norm_history;
  std::vector<RestartRound> lp_rounds;  // exchanges of points, the undone ones too
  double tau = 0;                       // Eq. 2, of the triangulation before the matching
  std::int64_t matching_cost = 0;
  Index extra_edges = 0;
  Index attempts = 1;  // chains tried until the final check passed
  std::string chain;   // e.g. "aligned + matching + clean-up"
  QuadQuality quality;
  SizeFidelity size;
  double simplify_deviation = 0;  // caller's units
  std::uint64_t hash = 0;         // of the output's points and faces
  std::vector<StageTime> times;
  std::vector<Warning> warnings;
};

/// What holds for the run as a whole, whatever chain of stages makes the mesh.
Report without_attempt(Report report);

}  // namespace lpq
