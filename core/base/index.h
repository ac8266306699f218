// Indices into flat arrays, and the half-edge arithmetic that is the whole mesh data structure:
// half-edge e = 3 t + k belongs to triangle t and runs from corner k to corner k+1 (mod 3).
#pragma once

#include <cstdint>

namespace lpq {

using Index = std::int32_t;
inline constexpr Index none = -1;

constexpr Index triangle_of(Index e) { return e / 3; }
constexpr Index next_in_triangle(Index e) { return e % 3 == 2 ? e - 2 : e + 1; }
constexpr Index prev_in_triangle(Index e) { return e % 3 == 0 ? e + 2 : e - 1; }

constexpr Index next_in_quad(Index k) { return (k + 1) & 3; }
constexpr Index prev_in_quad(Index k) { return (k + 3) & 3; }

}  // namespace lpq
