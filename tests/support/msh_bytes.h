// A text of Gmsh's MSH format as the binary file of the same content, row by row as the reference
// manual describes it and without the readers' help.
#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "catch.h"
#include "support/surface_files.h"

namespace lpq_test {

class MshBytes {
 public:
  explicit MshBytes(bool big, int count_bytes = 8) : big_(big), count_bytes_(count_bytes) {}

  std::string of(const std::string& text) {
    in_.str(text);
    for (std::vector<std::string> words = row(); !words.empty(); words = row()) {
      const std::string name = words[0].substr(1);
      out_ += words[0] + '\n';
      if (name == "MeshFormat") format();
      if (name == "PhysicalNames") names();
      if (name == "PartitionedEntities") partitions();
      if (name == "Entities" || name == "PartitionedEntities") entities(name != "Entities");
      if (name == "Nodes" || name == "ParametricNodes") nodes(name == "ParametricNodes");
      if (name == "Elements") elements();
      if (name != "PhysicalNames") out_ += '\n';
      REQUIRE(row() == std::vector<std::string>{"$End" + name});
      out_ += "$End" + name + '\n';
    }
    return out_;
  }

 private:
  std::vector<std::string> row() {
    std::string line;
    std::getline(in_, line);
    std::istringstream words(line);
    std::vector<std::string> list;
    for (std::string word; words >> word;) list.push_back(word);
    return list;
  }
  void integer(const std::string& word) {
    append_bits(out_, static_cast<std::uint32_t>(std::stoll(word)), big_);
  }
  void count(const std::string& word) {
    if (count_bytes_ == 4) return integer(word);
    append_bits(out_, static_cast<std::uint64_t>(std::stoll(word)), big_);
  }
  void real(const std::string& word) { append_double(out_, std::stod(word), big_); }

  void format() {
    const std::string version = row()[0];
    version_ = std::stod(version);
    out_ += version + " 1 " + std::to_string(count_bytes_) + '\n';
    integer("1");
  }
  void names() {
    std::string line;
    std::getline(in_, line);
    out_ += line + '\n';
    for (int left = std::stoi(line); left > 0; --left) {
      std::getline(in_, line);
      out_ += line + '\n';
    }
  }
  void partitions() {
    count(row()[0]);
    const std::string ghosts = row()[0];
    count(ghosts);
    for (int left = std::stoi(ghosts); left > 0; --left)
      for (const std::string& one : row()) integer(one);
  }
  void entities(bool are_parts) {
    const std::vector<std::string> counts = row();
    for (const std::string& one : counts) count(one);
    for (std::size_t dimension = 0; dimension < 4; ++dimension)
      for (int left = std::stoi(counts[dimension]); left > 0; --left) {
        const std::vector<std::string> words = row();
        std::size_t at = 0;
        integer(words[at++]);
        if (are_parts) {
          integer(words[at++]);
          integer(words[at++]);
          list(words, at);
        }
        for (const std::size_t end = at + (dimension == 0 && version_ > 4 ? 3 : 6); at < end;)
          real(words[at++]);
        for (int lists = dimension == 0 ? 1 : 2; lists > 0; --lists) list(words, at);
      }
  }
  void list(const std::vector<std::string>& words, std::size_t& at) {
    int size = at < words.size() ? std::stoi(words[at++]) : 0;
    count(std::to_string(size));
    while (size-- > 0) integer(words[at++]);
  }
  /// tag x y z, perhaps with coordinates on an entity.
  void node(const std::vector<std::string>& words, bool with_entity) {
    integer(words[0]);
    for (std::size_t k = 1; k < words.size(); ++k)
      with_entity && (k == 4 || k == 5) ? integer(words[k]) : real(words[k]);
  }
  void nodes(bool with_entity) {
    std::vector<std::string> words = row();
    if (version_ < 4) {
      out_ += words[0] + '\n';
      for (int left = std::stoi(words[0]); left > 0; --left) node(row(), with_entity);
      return;
    }
    for (const std::string& one : words) count(one);
    for (int blocks = std::stoi(words[0]); blocks > 0; --blocks) {
      const int size = block();
      for (int i = 0; i < size; ++i) version_ > 4 ? count(row()[0]) : node(row(), false);
      for (int i = 0; i < size && version_ > 4; ++i)
        for (const std::string& one : row()) real(one);
    }
  }
  int block() {
    const std::vector<std::string> words = row();
    for (std::size_t k = 0; k < 3; ++k) integer(words[k]);
    count(words[3]);
    return std::stoi(words[3]);
  }
  void elements() {
    std::vector<std::string> words = row();
    if (version_ < 4) {
      out_ += words[0] + '\n';
      return elements_2(std::stoi(words[0]));
    }
    for (const std::string& one : words) count(one);
    for (int blocks = std::stoi(words[0]); blocks > 0; --blocks)
      for (int left = block(); left > 0; --left)
        for (const std::string& one : row()) version_ > 4 ? count(one) : integer(one);
  }
  /// In batches of equal type and number of tags.
  void elements_2(int left) {
    std::vector<std::vector<std::string>> rows;
    while (left-- > 0) rows.push_back(row());
    for (std::size_t first = 0, end = 0; first < rows.size(); first = end) {
      const auto is_alike = [&](std::size_t i) {
        return rows[i][1] == rows[first][1] && rows[i][2] == rows[first][2];
      };
      while (end < rows.size() && is_alike(end)) ++end;
      for (const std::string& one : {rows[first][1], std::to_string(end - first), rows[first][2]})
        integer(one);
      for (std::size_t i = first; i < end; ++i)
        for (std::size_t k = 0; k < rows[i].size(); ++k)
          if (k != 1 && k != 2) integer(rows[i][k]);
    }
  }

  std::istringstream in_;
  std::string out_;
  bool big_;
  int count_bytes_;
  double version_ = 0;
};

inline std::string msh_bytes(const std::string& text, bool big = false, int count_bytes = 8) {
  return MshBytes(big, count_bytes).of(text);
}

}  // namespace lpq_test
