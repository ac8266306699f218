// The prices of the matching, in units of 10^-4 of a whole quality point. What cannot be mended
// later (quads at vertices that do not move) costs more than what smoothing mends. An aligned
// triangulation leaves the matching little choice and these prices hardly matter; on an isotropic
// one they decide how many flat quads and irregular vertices are left for the cleanup.
#pragma once

#include <cstdint>

namespace lpq {

inline constexpr double unit_cost = 1e4;                  // of 1 - eta
inline constexpr std::int64_t flat_quad_cost = 20000;     // eta = 0: some corner is flat or reflex
inline constexpr std::int64_t missing_quad_cost = 20000;  // per quad that a wall fan is short of
inline constexpr std::int64_t surplus_quad_cost = 4000;   // per quad that a wall fan has too many
inline constexpr std::int64_t inner_valence_cost = 2000;  // per quad off four at a vertex inside
inline constexpr std::int64_t extra_edge_cost = 60000;    // dearer than several bad quads
inline constexpr std::int64_t leave_cost = 5000;  // a triangle left over, where that is allowed
// There, what a quad that is missing at a fan may cost a merge: triangles fill the fan as well, and
// at more than their price all would stay.
inline constexpr std::int64_t most_beside_triangles = 2000;

}  // namespace lpq
