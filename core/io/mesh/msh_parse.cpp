// See msh_parse.h.
#include "io/mesh/msh_parse.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "io/mesh/msh_types.h"
#include "io/mesh_text.h"
#include "io/number.h"

namespace lpq {
namespace {

class MshParser {
 public:
  MshParser(std::string_view text, MeshScope scope) : lines_(text), scope_(scope) {}

  Result<MshContent> parse() {
    if (!read()) return error_;
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
    while (!lines_.at_end() && !failed_) {
      words_.split(lines_.next());
      if (words_.size() > 0) read_section(words_[0]);
    }
    if (!failed_ && version_ == 0) fail("'$MeshFormat' was expected.");
    if (!failed_) sort_nodes();
    return !failed_;
  }

  /// In the last line of a file that ends within a section, what is wrong is the end.
  void fail(std::string message) {
    if (failed_) return;
    failed_ = true;
    if (!section_.empty() && lines_.at_end())
      message +=
          " It is the last line, and '$End" + section_ + "' does not follow: the file was cut off.";
    error_ = lines_.error(std::move(message));
  }

  void read_section(std::string_view name) {
    if (name[0] != '$' || name.substr(0, 4) == "$End")
      return fail("A section '$...' was expected.");
    const std::string section(name);
    section_ = section.substr(1);
    if (version_ == 0 && section != "$MeshFormat") return fail("'$MeshFormat' must come first.");
    if (section == "$MeshFormat") {
      read_format();
    } else if (section == "$PhysicalNames") {
      read_names();
    } else if (section == "$Entities") {
      read_entities();
    } else if (section == "$Nodes") {
      version_ == 4 ? read_blocks(&MshParser::read_node_block) : read_nodes_2();
    } else if (section == "$Elements") {
      version_ == 4 ? read_blocks(&MshParser::read_element_block) : read_elements_2();
    } else {
      return skip_to_end();
    }
    if (failed_) return;
    words_.split(next_line());
    const bool ended = words_.size() == 1 && words_[0] == "$End" + section_;
    const std::string expected = "'$End" + section_ + "' was expected.";
    section_.clear();
    if (!ended) fail(expected);
  }

  std::string_view next_line() {
    if (lines_.at_end()) {
      const std::string section = std::exchange(section_, {});
      fail("The file ends inside its section $" + section + ", before '$End" + section +
           "': it was cut off.");
      return {};
    }
    return lines_.next();
  }

  void skip_to_end() {
    const std::string end = "$End" + section_;
    while (!failed_) {
      words_.split(next_line());
      if (words_.size() != 1 || words_[0] != end) continue;
      section_.clear();
      return;
    }
  }

  /// The next line as at least `count` integers.
  bool read_integers(std::size_t count) {
    words_.split(next_line());
    integers_.clear();
    for (std::size_t i = 0; i < words_.size() && !failed_; ++i) {
      std::int64_t value = 0;
      if (!parse_integer(words_[i], value)) {
        fail("'" + std::string(words_[i].substr(0, 40)) + "' is not an integer.");
      }
      integers_.push_back(value);
    }
    if (!failed_ && integers_.size() < count) fail("The line has too few numbers.");
    return !failed_;
  }

  /// words_[at ..] as x y z.
  void read_point(std::size_t at, Vec3& p) {
    if (words_.size() < at + 3 || !parse_number(words_[at], p.x) ||
        !parse_number(words_[at + 1], p.y) || !parse_number(words_[at + 2], p.z)) {
      return fail("A node needs three finite coordinates.");
    }
    if (p.z != 0 && scope_ == MeshScope::plane)
      fail("A node has z other than 0, but the mesh is read as one in the plane z = 0.");
  }

  void read_format() {
    words_.split(next_line());
    double version = 0;
    if (words_.size() < 3 || !parse_number(words_[0], version)) {
      return fail("'$MeshFormat' needs version, file type and data size.");
    }
    if (words_[1] != "0")
      return fail("Binary .msh files cannot be read; save it as ASCII (in Gmsh: Mesh.Binary = 0).");
    if (version == 4.1) {
      version_ = 4;
    } else if (version >= 2 && version < 3) {
      version_ = 2;
    } else {
      fail("MSH version " + std::string(words_[0].substr(0, 20)) +
           " cannot be read; use 2.2 or 4.1.");
    }
  }

  void read_names() {
    if (!read_integers(1)) return;
    for (std::int64_t left = integers_[0]; left > 0 && !failed_; --left) {
      const std::string_view line = next_line();
      words_.split(line);
      const std::size_t open = line.find('"'), close = line.rfind('"');
      MshLabelled<std::string> name;
      if (failed_ || words_.size() < 3 || !parse_integer(words_[0], name.dimension) ||
          !parse_integer(words_[1], name.tag) || open == close) {
        return fail("A physical name needs dimension, tag and a quoted name.");
      }
      name.value = line.substr(open + 1, close - open - 1);
      content_.names.push_back(std::move(name));
    }
    std::stable_sort(content_.names.begin(), content_.names.end());
  }

  void read_entities() {
    if (!read_integers(4)) return;
    const std::array<std::int64_t, 4> counts{integers_[0], integers_[1], integers_[2],
                                             integers_[3]};
    for (std::int64_t dimension = 0; dimension < 4; ++dimension) {
      // tag, then a point or a bounding box, then the physical tags.
      const std::size_t at = dimension == 0 ? 4 : 7;
      for (std::int64_t left = counts[static_cast<std::size_t>(dimension)]; left > 0; --left) {
        words_.split(next_line());
        MshLabelled<std::int64_t> entity{dimension, 0, 0};
        std::int64_t physicals = 0;
        if (failed_ || words_.size() <= at || !parse_integer(words_[0], entity.tag) ||
            !parse_integer(words_[at], physicals) ||
            (physicals > 0 &&
             (words_.size() <= at + 1 || !parse_integer(words_[at + 1], entity.value)))) {
          return fail("An entity needs a tag, its extent and its physical tags.");
        }
        if (physicals > 0) entities_.push_back(entity);
      }
    }
    std::stable_sort(entities_.begin(), entities_.end());
  }

  void read_nodes_2() {
    if (!read_integers(1)) return;
    for (std::int64_t left = integers_[0]; left > 0 && !failed_; --left) {
      words_.split(next_line());
      MshNode node;
      if (words_.size() < 4 || !parse_integer(words_[0], node.tag)) {
        return fail("A node needs a number and three coordinates.");
      }
      read_point(1, node.point);
      content_.nodes.push_back(node);
    }
  }

  void read_elements_2() {
    if (!read_integers(1)) return;
    for (std::int64_t left = integers_[0]; left > 0; --left) {
      if (!read_integers(3)) return;
      const std::int64_t tags = integers_[2];
      if (tags < 0 || tags > static_cast<std::int64_t>(integers_.size()) - 3) {
        return fail("An element has a wrong number of tags.");
      }
      const std::int64_t physical = tags > 0 ? integers_[3] : 0;
      const std::int64_t entity = tags > 1 ? integers_[4] : 0;
      add_element(integers_[1], 3 + static_cast<std::size_t>(tags), physical, entity);
      if (failed_) return;
    }
  }

  void read_blocks(void (MshParser::*read_block)()) {
    if (!read_integers(4)) return;
    for (std::int64_t left = integers_[0]; left > 0; --left) {
      if (!read_integers(4)) return;
      (this->*read_block)();
      if (failed_) return;
    }
  }

  void read_node_block() {
    const std::int64_t count = integers_[3];
    const std::size_t first = content_.nodes.size();
    for (std::int64_t i = 0; i < count; ++i) {
      if (!read_integers(1)) return;
      content_.nodes.push_back({integers_[0], {}});
    }
    for (std::size_t i = first; i < content_.nodes.size() && !failed_; ++i) {
      words_.split(next_line());
      read_point(0, content_.nodes[i].point);
    }
  }

  void read_element_block() {
    const std::int64_t dimension = integers_[0], entity = integers_[1], type = integers_[2];
    const std::int64_t* physical = find_msh_label(entities_, dimension, entity);
    for (std::int64_t left = integers_[3]; left > 0; --left) {
      if (!read_integers(1)) return;
      add_element(type, 1, physical != nullptr ? *physical : 0, entity);
      if (failed_) return;
    }
  }

  /// An element whose node tags start at integers_[at].
  void add_element(std::int64_t type, std::size_t at, std::int64_t physical, std::int64_t entity) {
    MshElement element;
    element.size = msh_corners(type, scope_);
    if (element.size == 0 && scope_ == MeshScope::space) return pass_over(type);
    if (element.size == 0) return refuse_type(type);
    if (integers_.size() < at + static_cast<std::size_t>(element.size)) {
      return fail("An element has too few nodes.");
    }
    for (int k = 0; k < element.size; ++k) {
      element.nodes[static_cast<std::size_t>(k)] = integers_[at + static_cast<std::size_t>(k)];
    }
    // A physical tag may be negative (reversed); entities without one stay apart from physicals.
    constexpr std::int64_t largest = std::int64_t{1} << 62;
    if (physical <= -largest || entity <= -largest || entity >= largest) {
      return fail("A tag is out of range.");
    }
    element.group = physical != 0 ? std::abs(physical) : -std::abs(entity);
    element.second_order = element.size >= 3 && type > msh_quad;
    element.line = lines_.line();
    element.byte = lines_.byte();
    content_.elements.push_back(element);
  }

  void pass_over(std::int64_t type) {
    if (is_msh_volume(type)) ++content_.passed_over.volumes;
    if (is_msh_high_face(type)) ++content_.passed_over.faces;
  }

  void refuse_type(std::int64_t type) {
    fail("Element type " + std::to_string(type) + ", " + msh_type_name(type) +
         ", cannot be read: a mesh in the plane has points, lines, triangles and quads of first "
         "order" +
         (is_msh_volume(type) ? "." : " (in Gmsh: Mesh.ElementOrder = 1)."));
  }

  void sort_nodes() {
    std::stable_sort(content_.nodes.begin(), content_.nodes.end(),
                     [](const MshNode& a, const MshNode& b) { return a.tag < b.tag; });
    for (std::size_t i = 1; i < content_.nodes.size(); ++i)
      if (content_.nodes[i - 1].tag == content_.nodes[i].tag)
        return fail("Node " + std::to_string(content_.nodes[i].tag) + " is defined twice.");
  }

  LineReader lines_;
  MeshScope scope_;
  Words words_;
  std::vector<std::int64_t> integers_;
  std::string section_;                              // that is being read, without its $
  int version_ = 0;                                  // 2 or 4
  std::vector<MshLabelled<std::int64_t>> entities_;  // physical tag of each entity that has one
  MshContent content_;
  bool failed_ = false;
  Error error_;
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
