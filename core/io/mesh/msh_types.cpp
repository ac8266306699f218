// See msh_types.h.
#include "io/mesh/msh_types.h"

#include <iterator>
#include <string>

namespace lpq {
namespace {

constexpr std::int64_t type_line = 1, type_triangle = 2, type_point = 15;
constexpr std::int64_t type_triangle_6 = 9, type_quad_9 = 10, type_quad_8 = 16;

struct Kind {
  std::int64_t from, to;  // numbers of types
  int dimension, order;   // of third order and more: 3
  const char* name;
};

/// Kinds that are not read, or in space alone.
constexpr Kind other_kinds[] = {{4, 4, 3, 1, "a tetrahedron"},
                                {5, 5, 3, 1, "a hexahedron"},
                                {6, 6, 3, 1, "a prism"},
                                {7, 7, 3, 1, "a pyramid"},
                                {8, 8, 1, 2, "a line of second order"},
                                {9, 9, 2, 2, "a triangle of second order"},
                                {10, 10, 2, 2, "a quad of second order"},
                                {11, 14, 3, 2, "a volume of second order"},
                                {16, 16, 2, 2, "a quad of second order"},
                                {17, 19, 3, 2, "a volume of second order"},
                                {20, 25, 2, 3, "a face of higher order"},
                                {26, 28, 1, 3, "a line of higher order"},
                                {29, 31, 3, 3, "a volume of higher order"},
                                {36, 51, 2, 3, "a face of higher order"},
                                {71, 93, 3, 3, "a volume of higher order"}};

/// Of the types 1, 2, ..
constexpr std::uint16_t node_counts[] = {
    2,  3,  4,  4,  8,  6,  5,  3,  6,  9,  10,  27,  18,  14,  1,  8,  // first and second order
    20, 15, 13, 9,  10, 12, 15, 15, 21, 4,  5,   6,   20,  35,  56, 22,  28,  0,
    0,  16, 25, 36, 12, 16, 20, 28, 36, 45, 55,  66,  49,  64,  81, 100, 121,  // faces
    18, 21, 24, 27, 30, 24, 28, 32, 36, 40,  // without inner nodes
    7,  8,  9,  10, 11, 0,  0,  0,  0,  84, 120, 165, 220, 286, 0,  0,   0,   34,
    40, 46, 52, 58, 1,  1,  1,  1,  1,  1,  40,  75,  64,  125};

Kind kind_of(std::int64_t type) {
  for (const Kind& kind : other_kinds)
    if (kind.from <= type && type <= kind.to) return kind;
  return {type, type, 0, 0, "of an unknown kind"};
}

}  // namespace

const char* msh_type_name(std::int64_t type) { return kind_of(type).name; }

bool is_msh_volume(std::int64_t type) { return kind_of(type).dimension == 3; }

bool is_msh_high_face(std::int64_t type) {
  const Kind kind = kind_of(type);
  return kind.dimension == 2 && kind.order == 3;
}

int msh_corners(std::int64_t type, MeshScope scope) {
  switch (type) {
    case type_point: return 1;
    case type_line: return 2;
    case type_triangle: return 3;
    case msh_quad: return 4;
    case type_triangle_6: return scope == MeshScope::space ? 3 : 0;
    case type_quad_8:
    case type_quad_9: return scope == MeshScope::space ? 4 : 0;
    default: return 0;
  }
}

int msh_nodes(std::int64_t type) {
  if (type < 1 || type > static_cast<std::int64_t>(std::size(node_counts))) return 0;
  return node_counts[type - 1];
}

Error error_of_no_face(const MshContent& content) {
  std::string text = "The file has no triangle and no quad";
  if (content.passed_over.volumes > 0) {
    text +=
        ", only volume elements (" + std::to_string(content.passed_over.volumes) +
        "). Extract the surface first: in Gmsh, save the physical surfaces too, or all elements "
        "(-save_all).";
  } else if (content.passed_over.faces > 0) {
    text +=
        " of first or second order, only faces of higher order. Save it with first order (in "
        "Gmsh: Mesh.ElementOrder = 1).";
  } else if (!content.elements.empty()) {
    text +=
        ", only points and lines. Mesh the surfaces first (gmsh -2); the lines of a domain in the "
        "plane need z = 0.";
  } else {
    text += content.nodes.empty() ? ": no node and no element." : ", only nodes.";
  }
  return {ErrorCode::empty, std::move(text), {}};
}

}  // namespace lpq
