// Makes the lists of a JSON domain belong together, or says why they do not.
#pragma once

#include <vector>

#include "io/domain/domain_file.h"

namespace lpq {

/// Errors: parse_error for tags without an edge, with region and loop, and for a guide without a
/// direction; a warning for a loop that has some tags, but not one for each edge: the others are
/// given empty ones.
Problem fit_lists(DomainInput& domain, std::vector<Warning>& warnings);

}  // namespace lpq
