// An independent check that a matching is optimal: primal and dual feasible, equal objectives.
#pragma once

#include <span>
#include <string>

#include "matching/blossom.h"

namespace lpq {

/// Empty when `matching` is perfect, its duals are feasible and both objectives agree exactly (or,
/// for no_perfect, when the witness proves it); otherwise a sentence about the first violation.
std::string check_certificate(Index node_count, std::span<const CostEdge> edges,
                              const Matching& matching);

}  // namespace lpq
