// What this build of the library knows, as data: for bindings, their types and user interfaces.
#pragma once

#include <string>

namespace lpq {

/// "0.1.0"
const char* version();

/// JSON: {"version", "options": [{"name", "type": "number"|"integer"|"boolean"|"choice", "default",
/// "min", "max" (numbers), "choices" (choices), "unit", "help"}, ..] in order,
/// "surfaceOptions", "writeOptions": the same for surfaces and for writing meshes, "errorCodes":
/// ["PARSE_ERROR", ..], "meshFormats": [..], "domainFormats": [..], "surfaceFormats": [..],
/// "surfaceMeshFormats": [..]}, the last those that hold meshes on surfaces.
std::string write_description();

}  // namespace lpq
