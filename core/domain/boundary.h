// The 1D mesh: the nodes and edges that the planar mesh must contain, unchanged.
#pragma once

#include <vector>

#include "base/function_ref.h"
#include "base/result.h"
#include "domain/domain.h"

namespace lpq {

/// A target size at a point, unit frame.
struct SizeSample {
  Vec2 position;
  double h = 0;
};

struct BoundaryOptions {
  bool keep = true;                // the given points are the 1D mesh
  double size = 0;                 // unit frame; edges longer than this are divided (refined mode)
  double growth = 0.3;             // slope limit of the spacing along and across the boundary, > 0
  double simplify_tolerance = 0;   // unit frame; 0 keeps every given vertex (refined mode)
  bool require_even = true;        // every part's boundary count must be even (all quads)
  bool allow_added_point = false;  // kept mode: cure an odd part with one midpoint
  Index max_nodes = 5'000'000;     // refined mode refuses more before allocating them
  std::vector<SizeSample> sizes = {};  // edges near them are no longer than that (refined mode)
  std::vector<Index> pieces = {};      // #S  refined mode: how many, in place of what sizes ask for
};

/// How a refined boundary's segments, those left after simplification, were divided; empty where
/// the boundary was kept. Edges of one segment follow each other, in the order of segments.
struct SegmentPieces {
  std::vector<double> wanted;  // #S  the integral of 1/spacing
  std::vector<Index> count;    // #S
  std::vector<char> is_whole;  // #S  cannot be divided
};

struct BoundaryMesh {
  std::vector<Vec2> points;     // #B  unit frame, snapped so that the frame map is exact on them
  std::vector<Vec2> world;      // #B  in the caller's units; given points bit for bit
  std::vector<Index> source;    // #B  point of the Domain, none for a node added by refinement
  std::vector<Segment> edges;   // #E  a, b index `points`; sides, tag and origin as in the Domain
  std::vector<double> spacing;  // #B  mean length of the edges at the node (target h there)
  std::vector<Index> output_rank;  // #B  permutation: number of this node in the output mesh
  double simplify_deviation = 0;   // unit frame
  SegmentPieces pieces;
  std::vector<Warning> warnings;  // beside the domain's; one for each point by allow_added_point
};

/// Kept mode returns the domain's points as they are; refined mode divides long edges evenly with
/// graded spacing and an even count for every part of a region between polylines. Errors:
/// odd_boundary, bad_size, too_many_elements, lost_precision.
/// Places of errors are in the unit frame.
Result<BoundaryMesh> sample_boundary(const Domain& domain, const BoundaryOptions& options = {});

}  // namespace lpq
