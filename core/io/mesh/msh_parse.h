// A .msh file as it is written, with tags instead of indices: the common half of its readers.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "geometry/vec3.h"
#include "io/mesh/output_parts.h"

namespace lpq {

struct MshNode {
  std::int64_t tag = 0;
  Vec3 point;
};

struct MshElement {
  std::array<std::int64_t, 4> nodes{};  // tags
  int size = 0;                         // 1 point, 2 line, 3 triangle, 4 quad
  std::int64_t group = 0;               // physical tag, or -(entity tag) without one
  std::int64_t line = 0, byte = 0;      // of the file; a binary one has no lines
  bool second_order = false;
  bool in_others = false;  // groups, too
};

/// A physical group.
struct MshGroup {
  std::int64_t dimension = 0, tag = 0;
  auto operator<=>(const MshGroup&) const = default;
};

/// A physical name, or the physical tag of an entity: a value kept per (dimension, tag).
template <class Value>
struct MshLabelled {
  std::int64_t dimension = 0, tag = 0;
  Value value;
  bool operator<(const MshLabelled& other) const {
    return dimension != other.dimension ? dimension < other.dimension : tag < other.tag;
  }
};

template <class Value>
const Value* find_msh_label(const std::vector<MshLabelled<Value>>& sorted, std::int64_t dimension,
                            std::int64_t tag) {
  const MshLabelled<Value> key{dimension, tag, {}};
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), key);
  return at != sorted.end() && !(key < *at) ? &at->value : nullptr;
}

struct MshContent {
  /// Elements that are passed over in space.
  struct PassedOver {
    std::int64_t volumes = 0;
    std::int64_t faces = 0;  // of third order or higher
  };
  std::vector<MshLabelled<std::string>> names;  // sorted
  std::vector<MshNode> nodes;                   // sorted by tag, each tag once
  std::vector<MshElement> elements;
  PassedOver passed_over;
  std::vector<MshGroup> other_groups;  // of elements in_others, as often as one is met
  bool repeats_elements = false;       // version 2 has an element for each of its groups
  bool binary = false;

  /// Index into nodes, none if there is no such tag. Cost O(log #nodes).
  Index node_index(std::int64_t tag) const;
};

/// Row by row as Gmsh writes it, versions 2.0 - 2.2, 4.0 and 4.1, ASCII or binary of either byte
/// order. In the plane z must be 0, and elements other than points, lines, triangles and quads of
/// first order are an error, as they would be silently left out. In space: any z, triangles and
/// quads of second order are read as their corners, other kinds (volumes) are passed over and
/// counted. Nothing is reserved from the counts in the file: memory grows only with rows that are
/// really there. Errors: parse_error with byte, and of ASCII with line.
Result<MshContent> parse_msh(std::string_view text, MeshScope scope);

/// Is it a surface, or was it meant as one, rather than a mesh or lines in the plane? A face that
/// leaves the plane z = 0, or volumes; without faces, and of a file that cannot be read to its end,
/// also a node that does.
bool is_msh_in_space(std::string_view text);

}  // namespace lpq
