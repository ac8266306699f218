// Physical groups of .msh files: what they are called, and elements that are in several.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "io/mesh/msh_parse.h"

namespace lpq {

/// Of the elements: 0 points, 1 lines, 2 triangles and quads.
std::int64_t msh_dimension(const MshElement& element);

/// The name; without one "physical surface 3", or by the entity "surface 3". Empty without either.
std::string msh_group_name(const MshContent& content, MshGroup group);

/// "a", "b": the names of groups, of very many the first ones, in a sentence.
std::string msh_group_names(const MshContent& content, const std::vector<MshGroup>& groups);

/// A mesh has one name for an element: the first group counts. Elements of version 2 that are
/// there again for another group are removed. The warning is about elements of `least` dimension
/// and more, and says which groups have lost all of theirs. Cost O(n log n).
std::optional<Warning> keep_first_groups(MshContent& content, std::int64_t least = 0);

}  // namespace lpq
