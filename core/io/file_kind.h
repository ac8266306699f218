// What a file is in truth: told by the ending of its name or by its first bytes, in words. For
// messages alone; the readers themselves choose by domain_format.h and surface_format.h.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace lpq {

/// "a ZIP archive", and what to do with one: "Unpack it first."
struct FileKind {
  std::string what, advice;
  std::string_view formats = {};  // names of the readers that take it, "json geojson"; "" = none
};

/// Of endings that belong to a format which no reader takes: .3mf, .glb, .sldprt, .vtu, ..
std::optional<FileKind> kind_by_ending(std::string_view file_name);

/// By the first bytes; none where they say nothing. Cost: the first lines, and one search through
/// a JSON text.
std::optional<FileKind> kind_by_content(std::string_view bytes);

/// `found`, the error of a reader of `format` ("stl"); where the bytes are none or plainly another
/// kind of file, an error that says so (empty, parse_error).
Error error_of_kind(Error found, std::string_view bytes, std::string_view format);

/// The error for a file whose format is not known, with the formats that are: parse_error, or empty
/// for no bytes at all.
Error unknown_format(std::string_view file_name, std::string_view bytes);

}  // namespace lpq
