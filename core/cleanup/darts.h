// The last resort for a quad that is not convex and whose corners cannot move: seven in its place.
//
//   A ---------- D ---------- C    A dart A B C D with its reflex (or straight) corner at D is cut
//    `.           \         .'     from D to B, but not quite straight: at a point P just beyond
//      `.    7     \  1-6 .'       the middle of that line, so that A B P D is strictly convex.
//        `.         P   .'
//          `.      /  .'           What is left, the dart B C D P, is a triangle with a point on
//            `.   / .'             one side, nearly, and all of those have the same six strictly
//              `. .'               convex quads, but for an affine map.
//                B
#pragma once

#include "cleanup/quad_topology.h"

namespace lpq {

/// Cuts every quad with one corner that is no strict left turn; none of its own corners moves, and
/// nothing changes beside it. The new quads are valid, not pretty. Left as they are: quads with
/// more such corners, and those too thin for coordinates between. How many were cut.
Index cut_darts(QuadTopology& mesh);

}  // namespace lpq
