// The surfaces of the shared data.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "catch.h"

namespace lpq_test {

inline std::string read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The files of a folder of the shared data, sorted; says so if there is none.
inline std::vector<std::filesystem::path> shared_surfaces(const std::string& folder) {
  const std::filesystem::path root = std::filesystem::path(LPQ_SHARED_DATA) / "data" / folder;
  std::vector<std::filesystem::path> files;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(root, missing))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) WARN("SKIPPED: nothing tested here because " << root << " has no surfaces");
  return files;
}

}  // namespace lpq_test
