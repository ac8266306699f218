// Reads what msh.h promises, line by line as Gmsh writes it. Nothing is reserved from the counts in
// the file: memory grows only with lines that are really there.
#include <algorithm>
#include <array>

#include "io/mesh/msh.h"
#include "io/mesh_text.h"
#include "io/number.h"

namespace lpq {
namespace {

constexpr std::int64_t type_line = 1, type_triangle = 2, type_quad = 3, type_point = 15;

struct Node {
  std::int64_t tag = 0;
  Vec2 point;
};

struct Element {
  std::array<std::int64_t, 4> nodes{};  // tags
  int size = 0;                         // 1 point, 2 line, 3 triangle, 4 quad
  std::int64_t group = 0;               // physical tag, or -(entity tag) without one
};

/// A physical name, or the physical tag of an entity: a value kept per (dimension, tag).
template <class Value>
struct Labelled {
  std::int64_t dimension = 0, tag = 0;
  Value value;
  bool operator<(const Labelled& other) const {
    return dimension != other.dimension ? dimension < other.dimension : tag < other.tag;
  }
};

template <class Value>
const Value* find_label(const std::vector<Labelled<Value>>& sorted, std::int64_t dimension,
                        std::int64_t tag) {
  const Labelled<Value> key{dimension, tag, {}};
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), key);
  return at != sorted.end() && !(key < *at) ? &at->value : nullptr;
}

int corners_of(std::int64_t type) {
  switch (type) {
    case type_point: return 1;
    case type_line: return 2;
    case type_triangle: return 3;
    case type_quad: return 4;
    default: return 0;
  }
}

class MshReader {
 public:
  MshReader(std::string_view text, bool needs_faces) : lines_(text), needs_faces_(needs_faces) {}

  Result<OutputMesh> read() {
    while (!lines_.at_end() && !failed_) {
      words_.split(lines_.next());
      if (words_.size() > 0) read_section(words_[0]);
    }
    if (!failed_ && version_ == 0) fail("'$MeshFormat' was expected.");
    if (!failed_) build();
    if (failed_) return error_;
    return std::move(mesh_);
  }

 private:
  void fail(std::string message) {
    if (failed_) return;
    failed_ = true;
    error_ = lines_.error(std::move(message));
  }

  void read_section(std::string_view name) {
    if (name[0] != '$' || name.substr(0, 4) == "$End")
      return fail("A section '$...' was expected.");
    const std::string section(name);
    if (version_ == 0 && section != "$MeshFormat") return fail("'$MeshFormat' must come first.");
    if (section == "$MeshFormat") {
      read_format();
    } else if (section == "$PhysicalNames") {
      read_names();
    } else if (section == "$Entities") {
      read_entities();
    } else if (section == "$Nodes") {
      version_ == 4 ? read_blocks(&MshReader::read_node_block) : read_nodes_2();
    } else if (section == "$Elements") {
      version_ == 4 ? read_blocks(&MshReader::read_element_block) : read_elements_2();
    } else {
      return skip_to_end(section);
    }
    if (failed_) return;
    words_.split(next_line());
    if (words_.size() != 1 || words_[0] != "$End" + section.substr(1)) {
      fail("'$End" + section.substr(1) + "' was expected.");
    }
  }

  std::string_view next_line() {
    if (lines_.at_end()) {
      fail("The file ends inside a section.");
      return {};
    }
    return lines_.next();
  }

  void skip_to_end(const std::string& section) {
    const std::string end = "$End" + section.substr(1);
    while (!failed_) {
      words_.split(next_line());
      if (words_.size() == 1 && words_[0] == end) return;
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
  void read_point(std::size_t at, Vec2& p) {
    double z = 0;
    if (words_.size() < at + 3 || !parse_number(words_[at], p.x) ||
        !parse_number(words_[at + 1], p.y) || !parse_number(words_[at + 2], z)) {
      return fail("A node needs three finite coordinates.");
    }
    if (z != 0) fail("A node has z different from 0; only plane meshes can be read.");
  }

  void read_format() {
    words_.split(next_line());
    double version = 0;
    if (words_.size() < 3 || !parse_number(words_[0], version)) {
      return fail("'$MeshFormat' needs version, file type and data size.");
    }
    if (words_[1] != "0") return fail("Binary .msh files cannot be read; save it as ASCII.");
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
    if (integers_[0] > static_cast<std::int64_t>(max_names))
      return fail("Too many physical names.");
    for (std::int64_t left = integers_[0]; left > 0 && !failed_; --left) {
      const std::string_view line = next_line();
      words_.split(line);
      const std::size_t open = line.find('"'), close = line.rfind('"');
      Labelled<std::string> name;
      if (failed_ || words_.size() < 3 || !parse_integer(words_[0], name.dimension) ||
          !parse_integer(words_[1], name.tag) || open == close) {
        return fail("A physical name needs dimension, tag and a quoted name.");
      }
      name.value = line.substr(open + 1, close - open - 1);
      names_.push_back(std::move(name));
    }
    std::stable_sort(names_.begin(), names_.end());
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
        Labelled<std::int64_t> entity{dimension, 0, 0};
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
      Node node;
      if (words_.size() < 4 || !parse_integer(words_[0], node.tag)) {
        return fail("A node needs a number and three coordinates.");
      }
      read_point(1, node.point);
      nodes_.push_back(node);
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

  void read_blocks(void (MshReader::*read_block)()) {
    if (!read_integers(4)) return;
    for (std::int64_t left = integers_[0]; left > 0; --left) {
      if (!read_integers(4)) return;
      (this->*read_block)();
      if (failed_) return;
    }
  }

  void read_node_block() {
    const std::int64_t count = integers_[3];
    const std::size_t first = nodes_.size();
    for (std::int64_t i = 0; i < count; ++i) {
      if (!read_integers(1)) return;
      nodes_.push_back({integers_[0], {}});
    }
    for (std::size_t i = first; i < nodes_.size() && !failed_; ++i) {
      words_.split(next_line());
      read_point(0, nodes_[i].point);
    }
  }

  void read_element_block() {
    const std::int64_t dimension = integers_[0], entity = integers_[1], type = integers_[2];
    const std::int64_t* physical = find_label(entities_, dimension, entity);
    for (std::int64_t left = integers_[3]; left > 0; --left) {
      if (!read_integers(1)) return;
      add_element(type, 1, physical != nullptr ? *physical : 0, entity);
      if (failed_) return;
    }
  }

  /// An element whose node tags start at integers_[at].
  void add_element(std::int64_t type, std::size_t at, std::int64_t physical, std::int64_t entity) {
    Element element;
    element.size = corners_of(type);
    if (element.size == 0) {
      return fail("Element type " + std::to_string(type) +
                  " is not a point, line, triangle or quad of first order.");
    }
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
    elements_.push_back(element);
  }

  // --- from tags to indices

  Index node_index(std::int64_t tag) {
    const auto at = std::lower_bound(nodes_.begin(), nodes_.end(), tag,
                                     [](const Node& node, std::int64_t t) { return node.tag < t; });
    if (at == nodes_.end() || at->tag != tag) {
      fail("An element names node " + std::to_string(tag) + ", which is not in the file.");
      return none;
    }
    return static_cast<Index>(at - nodes_.begin());
  }

  /// Index into `list` of the group's name; a new entry for a new group.
  Index label_index(std::vector<std::string>& list, std::vector<Labelled<Index>>& known,
                    std::int64_t dimension, std::int64_t group) {
    const Labelled<Index> key{dimension, group, static_cast<Index>(list.size())};
    const auto at = std::lower_bound(known.begin(), known.end(), key);
    if (at != known.end() && !(key < *at)) return at->value;
    if (list.size() >= max_names) fail("The file has too many groups.");
    const std::string* name = find_label(names_, dimension, group);
    list.push_back(name != nullptr ? *name : std::string());
    known.insert(at, key);
    return key.value;
  }

  void build() {
    std::stable_sort(nodes_.begin(), nodes_.end(),
                     [](const Node& a, const Node& b) { return a.tag < b.tag; });
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (i > 0 && nodes_[i - 1].tag == nodes_[i].tag) {
        return fail("Node " + std::to_string(nodes_[i].tag) + " is defined twice.");
      }
      mesh_.points.push_back(nodes_[i].point);
    }
    std::vector<Labelled<Index>> known_regions, known_tags;
    for (const Element& element : elements_) {
      Face v{none, none, none, none};
      for (std::size_t k = 0; k < static_cast<std::size_t>(element.size); ++k)
        v[k] = node_index(element.nodes[k]);
      if (element.size >= 3) {
        mesh_.faces.push_back(v);
        mesh_.region.push_back(label_index(mesh_.regions, known_regions, 2, element.group));
      } else if (element.size == 2) {
        const Index tag = label_index(mesh_.tags, known_tags, 1, element.group);
        mesh_.edges.push_back({.a = v[0], .b = v[1], .tag = tag});
      } else {
        const Index tag = label_index(mesh_.tags, known_tags, 0, element.group);
        mesh_.tagged_points.push_back({v[0], tag});
      }
      if (failed_) return;
    }
    if (mesh_.faces.empty() && needs_faces_) fail("The file has no triangle and no quad.");
  }

  LineReader lines_;
  bool needs_faces_;
  Words words_;
  std::vector<std::int64_t> integers_;
  int version_ = 0;  // 2 or 4
  std::vector<Labelled<std::string>> names_;
  std::vector<Labelled<std::int64_t>> entities_;  // physical tag of each entity that has one
  std::vector<Node> nodes_;
  std::vector<Element> elements_;
  OutputMesh mesh_;
  bool failed_ = false;
  Error error_;
};

}  // namespace

Result<OutputMesh> read_msh(std::string_view text) {
  auto mesh = MshReader(text, true).read();
  if (mesh) drop_unused_points(*mesh);
  return mesh;
}

Result<OutputMesh> read_msh_elements(std::string_view text) {
  return MshReader(text, false).read();
}

}  // namespace lpq
