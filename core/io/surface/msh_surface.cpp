// See msh_surface.h.
#include "io/surface/msh_surface.h"

#include "base/sort_unique.h"
#include "io/mesh/msh_groups.h"
#include "io/mesh/msh_parse.h"
#include "io/mesh/msh_types.h"
#include "io/surface/soup_builder.h"

namespace lpq {
namespace {

constexpr std::int64_t surfaces = 2;  // dimension of their groups

Error unknown_node(const MshElement& element, std::int64_t tag) {
  Error error{ErrorCode::parse_error,
              "An element names node " + std::to_string(tag) + ", which is not in the file.",
              {}};
  error.where.set_line(element.line, element.byte);
  return error;
}

/// Features of a surface are found, and have no names.
void warn_of_curves(const MshContent& content, SoupBuilder& builder) {
  std::vector<MshGroup> curves;
  for (const MshElement& element : content.elements)
    if (element.size == 2 && element.group > 0 &&
        (curves.empty() || curves.back().tag != element.group))
      curves.push_back({1, element.group});
  sort_unique(curves);
  if (curves.empty()) return;
  builder.warn({ErrorCode::ignored,
                "Physical curves were left out: " + msh_group_names(content, curves) +
                    ". Curves of the surface are its sharp edges, its border and the borders of "
                    "physical surfaces, with names by number.",
                {}});
}

void warn_of_passed_over(const MshContent& content, SoupBuilder& builder) {
  const auto warn = [&](std::int64_t count, const std::string& what, const std::string& rest) {
    if (count == 0) return;
    const std::string number = std::to_string(count) + what;
    builder.warn({ErrorCode::ignored, number + (count == 1 ? " is" : "s are") + rest, {}});
  };
  warn(content.passed_over.volumes, " volume element",
       " left out: the surface is the triangles and quads of the file.");
  warn(content.passed_over.faces, " element", " left out, being faces of third order or higher.");
}

}  // namespace

Result<SurfaceSoup> read_msh_surface(std::string_view text) {
  auto content = parse_msh(text, MeshScope::space);
  if (!content) return content.error();
  SoupBuilder builder;
  if (auto warning = keep_first_groups(*content, surfaces)) builder.warn(*std::move(warning));
  for (const MshNode& node : content->nodes) builder.add_point(node.point);
  std::int64_t group = 0;
  std::int64_t curved = 0;
  for (const MshElement& element : content->elements) {
    if (element.size < 3) continue;
    if (!builder.has_polygon() || element.group != group) {
      group = element.group;
      builder.set_group(std::to_string(group), msh_group_name(*content, {surfaces, group}));
    }
    std::array<Index, 4> corners{};
    const auto size = static_cast<std::size_t>(element.size);
    for (std::size_t k = 0; k < size; ++k) {
      corners[k] = content->node_index(element.nodes[k]);
      if (corners[k] == none) return unknown_node(element, element.nodes[k]);
    }
    builder.add_polygon(std::span(corners).first(size));
    curved += element.second_order;
  }
  if (builder.too_large()) return too_many_triangles();
  if (!builder.has_polygon()) return error_of_no_face(*content);
  warn_of_curves(*content, builder);
  warn_of_passed_over(*content, builder);
  if (curved > 0)
    builder.warn({ErrorCode::adapted,
                  std::to_string(curved) + " elements of second order are read as their corners.",
                  {}});
  return builder.take();
}

}  // namespace lpq
