// Files as strings, with errors as values.
#pragma once

#include <string>

#include "base/result.h"

namespace lpq {

/// The whole file; "-" is standard input. Errors: io_error, too_large (beyond 1 GiB).
Result<std::string> read_file(const std::string& name);

/// Writes a neighbouring temporary file and renames it, so that nobody ever sees half a file and a
/// failure leaves the old one. Creates missing folders. Errors: io_error.
Problem write_file(const std::string& name, const std::string& content);

/// "some/folder/plate.json" -> "plate"
std::string file_stem(const std::string& name);

}  // namespace lpq
