// Reads what msh.h promises: from the tags of the file to indices.
#include <map>
#include <utility>

#include "io/mesh/msh.h"
#include "io/mesh/msh_groups.h"
#include "io/mesh/msh_parse.h"
#include "io/mesh/msh_types.h"
#include "io/mesh/output_parts.h"
#include "io/text_place.h"

namespace lpq {
namespace {

/// Numbers of groups by dimension and tag.
using KnownGroups = std::map<std::pair<std::int64_t, std::int64_t>, Index>;

class MshReader {
 public:
  explicit MshReader(const MshContent& content) : content_(content) {}

  Result<OutputMesh> read() {
    for (const MshNode& node : content_.nodes) {
      mesh_.points.push_back({node.point.x, node.point.y});
      mesh_.z.push_back(node.point.z);
    }
    drop_flat_heights(mesh_);
    for (const MshElement& element : content_.elements) {
      add(element);
      if (failed_) return error_;
    }
    return std::move(mesh_);
  }

 private:
  void fail(std::string message, const MshElement& element) {
    if (failed_) return;
    failed_ = true;
    error_ = {ErrorCode::parse_error, std::move(message), {}};
    error_.where.set_line(element.line, element.byte);
  }

  void add(const MshElement& element) {
    Face v{none, none, none, none};
    for (std::size_t k = 0; k < static_cast<std::size_t>(element.size); ++k) {
      v[k] = content_.node_index(element.nodes[k]);
      if (v[k] == none)
        return fail("An element names node " + std::to_string(element.nodes[k]) +
                        ", which is not in the file.",
                    element);
    }
    if (element.size >= 3) {
      mesh_.faces.push_back(v);
      mesh_.region.push_back(label_index(mesh_.regions, known_regions_, 2, element));
    } else if (element.size == 2) {
      const Index tag = label_index(mesh_.tags, known_tags_, 1, element);
      mesh_.edges.push_back({.a = v[0], .b = v[1], .tag = tag});
    } else {
      const Index tag = label_index(mesh_.tags, known_tags_, 0, element);
      mesh_.tagged_points.push_back({v[0], tag});
    }
  }

  /// Index into `list` of the group's name; a new entry for a new group.
  Index label_index(std::vector<std::string>& list, KnownGroups& known, std::int64_t dimension,
                    const MshElement& element) {
    const auto [at, is_new] =
        known.insert({{dimension, element.group}, static_cast<Index>(list.size())});
    if (is_new) {
      const std::string* name = find_msh_label(content_.names, dimension, element.group);
      list.push_back(name != nullptr ? *name : std::string());
    }
    return at->second;
  }

  const MshContent& content_;
  OutputMesh mesh_;
  KnownGroups known_regions_, known_tags_;
  bool failed_ = false;
  Error error_;
};

}  // namespace

Result<OutputMesh> read_msh(std::string_view text, MeshScope scope) {
  const auto content = parse_msh(text, scope);
  if (!content) return content.error();
  auto mesh = MshReader(*content).read();
  if (mesh && mesh->faces.empty()) {
    Error error = error_at(text, text.size(), error_of_no_face(*content).message);
    if (content->binary) error.where.line = none;
    return error;
  }
  if (mesh) drop_unused_points(*mesh);
  return mesh;
}

Result<MshElements> read_msh_elements(std::string_view text) {
  auto content = parse_msh(text, MeshScope::plane);
  if (!content) return content.error();
  MshElements elements;
  if (auto warning = keep_first_groups(*content)) elements.warnings.push_back(*std::move(warning));
  auto mesh = MshReader(*content).read();
  if (!mesh) return mesh.error();
  elements.mesh = *std::move(mesh);
  return elements;
}

}  // namespace lpq
