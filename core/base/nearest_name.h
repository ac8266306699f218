// "Did you mean ...?"
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lpq {

/// The candidate with the fewest edits (insert, delete, replace, swap) from `word`, "" if none is
/// near enough to be meant.
std::string nearest_name(std::string_view word, std::span<const std::string> candidates);

}  // namespace lpq
