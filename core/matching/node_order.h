// Renumbering the nodes of a graph so that neighbours lie close together in memory.
#pragma once

#include <span>
#include <vector>

#include "matching/blossom.h"

namespace lpq {

/// new_id[v], a permutation of 0 .. node_count-1: breadth first within compact patches.
std::vector<Index> compact_order(Index node_count, std::span<const CostEdge> edges);

}  // namespace lpq
