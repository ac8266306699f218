#include "io/mesh/region_groups.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace lpq {

RegionGroups region_groups(const OutputMesh& mesh) {
  RegionGroups groups;
  std::map<std::string_view, Index> known;
  Index count = 0;
  for (const std::string& name : mesh.regions) {
    const Index number = name.empty() ? count : known.try_emplace(name, count).first->second;
    groups.group.push_back(number);
    if (number == count) ++count;
  }
  if (groups.group.empty()) groups.group.push_back(count++);
  groups.regions = members_of(groups.group, static_cast<std::size_t>(count));
  return groups;
}

std::vector<std::string> group_names(const OutputMesh& mesh, const RegionGroups& groups) {
  std::vector<std::string> names;
  if (mesh.regions.empty()) return names;
  for (Index g = 0; g < groups.count(); ++g)
    names.push_back(mesh.regions[static_cast<std::size_t>(groups.first(g))]);
  return names;
}

}  // namespace lpq
