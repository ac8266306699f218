// The iterations of L_p as files that a viewer can step through: iterates.json says what is in
// iterates.bin, which is binary because a run of 1,000 points and 80 iterations is 12 MB of it.
//
//   iterates.json  {"boundaryNodes": number of points that are fixed and come first,
//                   "iterates": [{"iteration": k, "points": #V, "triangles": #T, "pieces": #P,
//                   "corners": #C}, ...]}
//   iterates.bin   for each of these, little-endian, without anything between:
//                   doubles  #V points x, y; #V densities (energy of the cell / its area);
//                            #C corners x, y of the pieces of Voronoi cells, counter-clockwise
//                   uint32   #T triangles, 3 points each; #P sites of the pieces; #P + 1 offsets of
//                            their corners; one zero more if the count of all these is odd
//
// The start (iteration 0) is in start.obj, the end in triangles.json. Long runs of many points are
// thinned out: every 2nd, 4th, ... iteration (pipeline/iterate_log.h).
#pragma once

#include "io/stages.h"

namespace lpq {

/// Both files, or none without iterations. Coordinates and densities in the caller's units. Cost:
/// one evaluation of the energy for each.
void write_iterates(const Trace& trace, FileSink sink);

}  // namespace lpq
