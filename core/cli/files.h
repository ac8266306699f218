// Files as strings, with errors as values.
#pragma once

#include <string>

#include "base/result.h"

namespace lpq {

/// The whole file; "-" is standard input. Errors: io_error, too_large (beyond 1 GiB).
Result<std::string> read_file(const std::string& name);

/// Where a file of this name is: absolute and behind symbolic links, also those that lead to a file
/// that is not there yet. Two names of one place have the same.
std::string real_path(const std::string& name);

/// Writes a new temporary file beside the old one and renames it, so that nobody ever sees half a
/// file and a failure leaves the old one. Symbolic links and permissions stay; devices and pipes
/// are written into. Creates missing folders. Errors: io_error.
Problem write_file(const std::string& name, const std::string& content);

/// "some/folder/plate.json" -> "plate"
std::string file_stem(const std::string& name);

}  // namespace lpq
