// See msh_groups.h.
#include "io/mesh/msh_groups.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "base/sort_unique.h"

namespace lpq {
namespace {

/// An element by its nodes in order; equal ones by their place in the file.
struct MshNodeSet {
  std::array<std::int64_t, 4> nodes{};
  int size = 0;
  std::size_t element = 0;

  bool same_nodes(const MshNodeSet& other) const {
    return size == other.size && nodes == other.nodes;
  }
  bool operator<(const MshNodeSet& other) const {
    if (size != other.size) return size < other.size;
    return nodes != other.nodes ? nodes < other.nodes : element < other.element;
  }
};

MshGroup group_of(const MshElement& element) { return {msh_dimension(element), element.group}; }

void remove_repeated(MshContent& content) {
  std::vector<MshElement>& elements = content.elements;
  std::vector<MshNodeSet> sets;
  sets.reserve(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    sets.push_back({elements[i].nodes, elements[i].size, i});
    std::sort(sets.back().nodes.begin(), sets.back().nodes.begin() + elements[i].size);
  }
  std::sort(sets.begin(), sets.end());
  std::vector<char> keep(elements.size(), 1);
  for (std::size_t i = 1, first = 0; i < sets.size(); ++i) {
    if (!sets[i].same_nodes(sets[first])) {
      first = i;
      continue;
    }
    elements[sets[first].element].in_others = true;
    content.other_groups.push_back(group_of(elements[sets[i].element]));
    keep[sets[i].element] = 0;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (keep[i]) elements[kept++] = elements[i];
  elements.resize(kept);
}

/// Other groups of `least` dimension and more that are the first one of no element.
std::vector<MshGroup> lost_groups(const MshContent& content, std::int64_t least) {
  std::vector<MshGroup> kept, others, lost;
  for (const MshElement& element : content.elements)
    if (kept.empty() || kept.back() != group_of(element)) kept.push_back(group_of(element));
  sort_unique(kept);
  for (const MshGroup group : content.other_groups)
    if (group.dimension >= least && group.dimension <= 2 && group.tag > 0) others.push_back(group);
  sort_unique(others);
  std::set_difference(others.begin(), others.end(), kept.begin(), kept.end(),
                      std::back_inserter(lost));
  return lost;
}

}  // namespace

std::int64_t msh_dimension(const MshElement& element) { return std::min(element.size, 3) - 1; }

std::string msh_group_name(const MshContent& content, MshGroup group) {
  constexpr const char* kinds[] = {"point ", "curve ", "surface "};
  if (const std::string* name = find_msh_label(content.names, group.dimension, group.tag))
    return *name;
  if (group.tag == 0) return {};
  const std::string kind = kinds[group.dimension];
  return group.tag > 0 ? "physical " + kind + std::to_string(group.tag)
                       : kind + std::to_string(-group.tag);
}

std::string msh_group_names(const MshContent& content, const std::vector<MshGroup>& groups) {
  constexpr std::size_t most = 5, longest = 40;
  std::string text;
  for (std::size_t i = 0; i < std::min(groups.size(), most); ++i) {
    if (i > 0) text += ", ";
    text += '"' + msh_group_name(content, groups[i]).substr(0, longest) + '"';
  }
  if (groups.size() > most) text += " and " + std::to_string(groups.size() - most) + " others";
  return text;
}

std::optional<Warning> keep_first_groups(MshContent& content, std::int64_t least) {
  if (content.repeats_elements) remove_repeated(content);
  const auto count =
      std::count_if(content.elements.begin(), content.elements.end(),
                    [&](const MshElement& e) { return e.in_others && msh_dimension(e) >= least; });
  if (count == 0) return std::nullopt;
  std::string text =
      "Of elements in several physical groups the first group was taken: " + std::to_string(count) +
      ".";
  const std::vector<MshGroup> lost = lost_groups(content, least);
  if (!lost.empty()) text += " Nothing is left of " + msh_group_names(content, lost) + ".";
  return Warning{ErrorCode::ignored, std::move(text), {}};
}

}  // namespace lpq
