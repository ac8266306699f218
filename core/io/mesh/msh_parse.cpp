// See msh_parse.h.
#include "io/mesh/msh_parse.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "io/mesh/msh_entities.h"
#include "io/mesh/msh_rows.h"
#include "io/mesh/msh_types.h"
#include "io/number.h"

namespace lpq {
namespace {

/// The versions by what their rows hold; 4.0 is all but forgotten, and is 4.1 in another order.
enum class Rows { none, v2, v4_0, v4_1 };

class MshParser {
 public:
  MshParser(std::string_view text, MeshScope scope) : rows_(text), scope_(scope) {}

  Result<MshContent> parse() {
    if (!read()) return rows_.error();
    content_.binary = rows_.is_binary();
    return std::move(content_);
  }

  bool is_in_space() {
    const bool complete = read();
    if (content_.passed_over.volumes > 0) return true;
    bool has_faces = false;
    for (const MshElement& element : content_.elements) {
      if (element.size < 3) continue;
      has_faces = true;
      for (int k = 0; complete && k < element.size; ++k) {
        const Index node = content_.node_index(element.nodes[static_cast<std::size_t>(k)]);
        if (node != none && content_.nodes[static_cast<std::size_t>(node)].point.z != 0)
          return true;
      }
    }
    return !(complete && has_faces) &&
           std::any_of(content_.nodes.begin(), content_.nodes.end(),
                       [](const MshNode& node) { return node.point.z != 0; });
  }

 private:
  bool read() {
    while (rows_.next_section()) read_section(rows_.section());
    if (version_ == Rows::none) rows_.fail("'$MeshFormat' was expected.");
    content_.repeats_elements = version_ == Rows::v2;
    content_.other_groups = entities_.other_groups();
    if (!rows_.failed()) sort_nodes();
    return !rows_.failed();
  }

  void read_section(const std::string& name) {
    constexpr std::string_view needing_format[] = {"Entities", "PartitionedEntities", "Nodes",
                                                   "ParametricNodes", "Elements"};
    const bool needs_format = std::find(std::begin(needing_format), std::end(needing_format),
                                        name) != std::end(needing_format);
    if (version_ == Rows::none && needs_format) return rows_.fail("'$MeshFormat' must come first.");
    if (name == "MeshFormat") {
      read_format();
    } else if (name == "PhysicalNames") {
      read_names();
    } else if (name == "Entities") {
      entities_.read(rows_, version_ == Rows::v4_0);
    } else if (name == "PartitionedEntities") {
      entities_.read_parts(rows_, version_ == Rows::v4_0);
    } else if (name == "ParametricNodes" && version_ == Rows::v2) {
      read_nodes_2();
    } else if (name == "Nodes") {
      version_ == Rows::v2 ? read_nodes_2() : read_blocks(&MshParser::read_node_block);
    } else if (name == "Elements") {
      version_ == Rows::v2 ? read_elements_2() : read_blocks(&MshParser::read_element_block);
    } else {
      return rows_.skip_section();
    }
    rows_.end_section();
  }

  void read_point(Vec3& p) {
    if (!rows_.read_real(p.x) || !rows_.read_real(p.y) || !rows_.read_real(p.z))
      return rows_.fail("A node needs three finite coordinates.");
    if (p.z != 0 && scope_ == MeshScope::plane)
      rows_.fail("A node has z other than 0, but the mesh is read as one in the plane z = 0.");
  }

  void read_format() {
    Words words;
    words.split(rows_.next_line());
    double version = 0;
    if (words.size() < 3 || !parse_number(words[0], version))
      return rows_.fail("'$MeshFormat' needs version, file type and data size.");
    if (version == 4.1) {
      version_ = Rows::v4_1;
    } else if (version == 4) {
      version_ = Rows::v4_0;
    } else if (version >= 2 && version < 3) {
      version_ = Rows::v2;
    } else {
      return rows_.fail("MSH version " + std::string(words[0].substr(0, 20)) +
                        " cannot be read; use 2.2 or 4.1.");
    }
    if (words[1] != "0") begin_binary(words[1], words[2]);
  }

  /// The data size is that of a count in 4.1, and before always that of a real.
  void begin_binary(std::string_view type, std::string_view size) {
    const bool short_counts = size == "4" && version_ == Rows::v4_1;
    if (type != "1" || (size != "8" && !short_counts))
      return rows_.fail("The file type must be 0 (ASCII) or 1 (binary), and the data size 8.");
    rows_.begin_binary(short_counts ? 4 : 8);
  }

  void read_names() {
    if (!rows_.read_line_of_integers(1)) return;
    Words words;
    for (std::int64_t left = rows_.integers()[0]; left > 0 && !rows_.failed(); --left) {
      const std::string_view line = rows_.next_line();
      words.split(line);
      const std::size_t open = line.find('"'), close = line.rfind('"');
      MshLabelled<std::string> name;
      if (words.size() < 3 || !parse_integer(words[0], name.dimension) ||
          !parse_integer(words[1], name.tag) || open == close) {
        return rows_.fail("A physical name needs dimension, tag and a quoted name.");
      }
      name.value = line.substr(open + 1, close - open - 1);
      content_.names.push_back(std::move(name));
    }
    std::stable_sort(content_.names.begin(), content_.names.end());
  }

  /// A row of tag and point. Behind them is what is not needed: in version 2 perhaps an entity and
  /// the place on it, else `more` coordinates of that place.
  void read_node(std::int64_t more) {
    MshNode node;
    rows_.begin_row();
    if (!rows_.has_words(4) || !rows_.read_int(node.tag))
      return rows_.fail("A node needs a number and three coordinates.");
    read_point(node.point);
    if (rows_.is_binary() && rows_.section() == "ParametricNodes") {
      if (!rows_.read_int(more)) return;
      rows_.skip_ints(1);
    }
    rows_.skip_reals(more);
    content_.nodes.push_back(node);
  }

  void read_nodes_2() {
    if (!rows_.read_line_of_integers(1)) return;
    for (std::int64_t left = rows_.integers()[0]; left > 0 && !rows_.failed(); --left) read_node(0);
  }

  void read_elements_2() {
    if (!rows_.read_line_of_integers(1)) return;
    for (std::int64_t left = rows_.integers()[0]; left > 0 && !rows_.failed();)
      left -= rows_.is_binary() ? read_batch_2(left) : read_element_2();
  }

  std::int64_t read_element_2() {
    if (!rows_.read_integers(3, 0)) return 1;
    const std::int64_t tags = rows_.integers()[2];
    if (tags < 0 || tags > static_cast<std::int64_t>(rows_.integers().size()) - 3) {
      rows_.fail("An element has a wrong number of tags.");
    } else {
      add_tagged_element(rows_.integers()[1], 3, static_cast<std::size_t>(tags));
    }
    return 1;
  }

  /// In bytes, elements of the same type and number of tags have a header for them all.
  std::int64_t read_batch_2(std::int64_t most) {
    if (!rows_.read_integers(3, 0)) return 1;
    const std::int64_t type = rows_.integers()[0], count = rows_.integers()[1];
    const std::int64_t tags = rows_.integers()[2];
    if (count < 1 || count > most) rows_.fail("A block has a wrong number of elements.");
    if (tags < 0) rows_.fail("An element has a wrong number of tags.");
    const std::size_t nodes = nodes_in_bytes(type);
    for (std::int64_t left = count; left > 0 && !rows_.failed(); --left)
      if (rows_.read_integers(1 + static_cast<std::size_t>(tags) + nodes, 0))
        add_tagged_element(type, 1, static_cast<std::size_t>(tags));
    return count;
  }

  struct Block {
    std::int64_t dimension, entity;
    std::int64_t kind;  // of elements; of nodes: do they have coordinates on their entity
    std::int64_t count;
  };

  void read_blocks(void (MshParser::*read_block)(const Block&)) {
    const bool old = version_ == Rows::v4_0;
    if (!rows_.read_integers(0, old ? 2 : 4)) return;
    for (std::int64_t left = rows_.integers()[0]; left > 0; --left) {
      if (!rows_.read_integers(3, 1)) return;
      const std::vector<std::int64_t>& row = rows_.integers();
      (this->*read_block)({row[old ? 1 : 0], row[old ? 0 : 1], row[2], row[3]});
      if (rows_.failed()) return;
    }
  }

  void read_node_block(const Block& block) {
    const std::int64_t more = block.kind != 0 ? block.dimension : 0;
    if (version_ == Rows::v4_0) {
      for (std::int64_t i = 0; i < block.count && !rows_.failed(); ++i) read_node(more);
      return;
    }
    const std::size_t first = content_.nodes.size();
    for (std::int64_t i = 0; i < block.count; ++i) {
      if (!rows_.read_integers(0, 1)) return;
      content_.nodes.push_back({rows_.integers()[0], {}});
    }
    for (std::size_t i = first; i < content_.nodes.size() && !rows_.failed(); ++i) {
      rows_.begin_row();
      read_point(content_.nodes[i].point);
      rows_.skip_reals(more);
    }
  }

  void read_element_block(const Block& block) {
    const MshHome home = entities_.home_of(block.dimension, block.entity);
    const std::size_t numbers = 1 + nodes_in_bytes(block.kind);
    const bool ints = version_ == Rows::v4_0;
    for (std::int64_t left = block.count; left > 0 && !rows_.failed(); --left)
      if (rows_.read_integers(ints ? numbers : 0, ints ? 0 : numbers) && !home.is_cut)
        add_element(block.kind, 1, home);
  }

  /// Nodes of an element as far as they must be known to read it: not of a line.
  std::size_t nodes_in_bytes(std::int64_t type) {
    if (!rows_.is_binary()) return 0;
    const int nodes = msh_nodes(type);
    if (nodes == 0)
      rows_.fail("Element type " + std::to_string(type) +
                 " cannot be read from a binary file, as the number of its nodes is not known.");
    return static_cast<std::size_t>(nodes);
  }

  /// An element whose tags start at integers()[at]: the physical one, the entity, others.
  void add_tagged_element(std::int64_t type, std::size_t at, std::size_t tags) {
    const std::vector<std::int64_t>& row = rows_.integers();
    add_element(type, at + tags,
                {.entity = tags > 1 ? row[at + 1] : 0, .physical = tags > 0 ? row[at] : 0});
  }

  /// An element whose node tags start at integers()[at].
  void add_element(std::int64_t type, std::size_t at, const MshHome& home) {
    MshElement element;
    element.size = msh_corners(type, scope_);
    if (element.size == 0 && scope_ == MeshScope::space) return pass_over(type);
    if (element.size == 0) return refuse_type(type);
    if (rows_.integers().size() < at + static_cast<std::size_t>(element.size))
      return rows_.fail("An element has too few nodes.");
    for (std::size_t k = 0; k < static_cast<std::size_t>(element.size); ++k)
      element.nodes[k] = rows_.integers()[at + k];
    // A physical tag may be negative (reversed); entities without one stay apart from physicals.
    constexpr std::int64_t largest = std::int64_t{1} << 62;
    if (home.physical <= -largest || home.entity <= -largest || home.entity >= largest)
      return rows_.fail("A tag is out of range.");
    element.group = home.physical != 0 ? std::abs(home.physical) : -std::abs(home.entity);
    element.in_others = home.in_others;
    element.second_order = element.size >= 3 && type > msh_quad;
    element.line = rows_.line();
    element.byte = rows_.byte();
    content_.elements.push_back(element);
  }

  void pass_over(std::int64_t type) {
    if (is_msh_volume(type)) ++content_.passed_over.volumes;
    if (is_msh_high_face(type)) ++content_.passed_over.faces;
  }

  void refuse_type(std::int64_t type) {
    rows_.fail("Element type " + std::to_string(type) + ", " + msh_type_name(type) +
               ", cannot be read: a mesh in the plane has points, lines, triangles and quads of "
               "first order" +
               (is_msh_volume(type) ? "." : " (in Gmsh: Mesh.ElementOrder = 1)."));
  }

  void sort_nodes() {
    std::stable_sort(content_.nodes.begin(), content_.nodes.end(),
                     [](const MshNode& a, const MshNode& b) { return a.tag < b.tag; });
    for (std::size_t i = 1; i < content_.nodes.size(); ++i)
      if (content_.nodes[i - 1].tag == content_.nodes[i].tag)
        return rows_.fail("Node " + std::to_string(content_.nodes[i].tag) + " is defined twice.");
  }

  MshRows rows_;
  MeshScope scope_;
  Rows version_ = Rows::none;
  MshEntities entities_;
  MshContent content_;
};

}  // namespace

Index MshContent::node_index(std::int64_t tag) const {
  const auto at =
      std::lower_bound(nodes.begin(), nodes.end(), tag,
                       [](const MshNode& node, std::int64_t t) { return node.tag < t; });
  return at == nodes.end() || at->tag != tag ? none : static_cast<Index>(at - nodes.begin());
}

Result<MshContent> parse_msh(std::string_view text, MeshScope scope) {
  return MshParser(text, scope).parse();
}

bool is_msh_in_space(std::string_view text) {
  return MshParser(text, MeshScope::space).is_in_space();
}

}  // namespace lpq
