// Domains from DXF, ASCII, any release (Autodesk, DXF Reference).
// Outlines are the LINE, ARC, CIRCLE, ELLIPSE, SPLINE, LWPOLYLINE and POLYLINE entities of model
// space (of paper space if model space has none), joined where they meet: points of open pieces
// that are nearer than 1e-5 of the drawing's size to another one become one (a warning says so
// beyond rounding), and lines are divided where others end on them, or on the curves that they
// stand for, and where corners of neighbouring closed outlines lie on them. Everything must close.
// The even-odd rule says what is material, as in svg_domain.h; lines that divide an outline make
// neighbouring regions, and what was drawn again on another layer exactly over the border of a hole
// fills it. A layer other than "0" becomes the tag of its edges, and the name of the regions that
// its lines alone enclose, or a closed outline of it, the smallest around. Coordinates are taken as
// they are: $INSUNITS is ignored, and z. Blocks are drawn where INSERT entities put them, scaled,
// mirrored, turned, in rows and columns, and within other blocks; what a block has on layer "0" is
// on the layer of its INSERT. What is invisible, or on a layer that is off or frozen, is left out
// with a warning, and so are other entities (TEXT, DIMENSION, HATCH ...).
#pragma once

#include <string_view>

#include "base/result.h"
#include "io/domain/domain_file.h"

namespace lpq {

/// Curves become polylines within 2e-4 of the drawing's size. Errors: parse_error (also an open
/// outline, with the point where it is open), non_finite, empty, with line and byte;
/// too_large where curves have more corners than the text has bytes (and more than a million).
Result<DomainFile> read_dxf_domain(std::string_view text);

}  // namespace lpq
