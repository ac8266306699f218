// Inputs of the command line: files as they are, and CAD files as the triangles that a program of
// its own makes of them.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace lpq {

/// STEP, IGES or BREP, by the ending of its name?
bool is_cad_file(std::string_view name);

/// How fine a mesh the input is for: its size, or how many quads; 0: not known.
struct QuadsAsked {
  double size = 0, quads = 0;
};

/// The bytes of a file; of a CAD file its triangles as an OBJ file, fine enough for the mesh. Only
/// the program for Node can do that, with the package occt-import-js beside it. Errors: those of
/// read_file; parse_error that says what to do, or what is wrong.
Result<std::string> read_input(const std::string& name, const QuadsAsked& asked = {});

}  // namespace lpq
