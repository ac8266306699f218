// Domains as JSON text: {"loops": [[[x, y], ...], ...], "tags": as below} for one region, or
// {"regions": [{"name": "steel", "loops": [...], "tags": [["inlet", "", ...], ...]}, ...]},
// with optional "polylines": [{"points": [[x, y], ...], "tag": ""}],
// "points": [[x, y] or {"position": [x, y], "tag": ""}], "h": size, "sizes": [[x, y, h], ...],
// "guides": [[[x, y], ...], ...] and "seedPoints": [[x, y], ...]. Tags are one per edge of a loop;
// "" is none, and edges beyond the last tag have none. No key may be there twice. Other keys are
// ignored, with a warning where one looks like a key that is missing.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "domain/domain.h"
#include "io/domain/domain_file.h"

namespace lpq {

/// Reads the text and judges its form only; make_domain judges the geometry. Errors: parse_error
/// and non_finite with line and byte and, in the message, the path of the value, parse_error for
/// tags without an edge and guides without a direction as well; too_large beyond 1 GiB. Memory
/// grows with the text, never with a number written in it; nesting is limited.
Result<DomainFile> read_json_domain(std::string_view text);

/// Text that reads back as the same domain, bit for bit.
std::string write_domain_json(const DomainInput& domain);

}  // namespace lpq
