// Errors and warnings for people (one line) and for programs (JSON).
#pragma once

#include <string>

#include "base/result.h"
#include "io/json_write.h"

namespace lpq {

/// "SELF_INTERSECTION: Two edges cross. (loop 0 edge 3, loop 1 edge 7, at 0.5 0.25)"
std::string error_text(const Error& error);

/// {"code":"SELF_INTERSECTION","message":"..","where":{"loop":0,"edge":3,..,"x":0.5,"y":0.25}}
void append_error(JsonWriter& json, const Error& error);

/// The warnings as an array of the same.
std::string errors_json(const std::vector<Error>& errors);

/// {"error":{..}} as a file of its own.
std::string write_error_json(const Error& error);

}  // namespace lpq
