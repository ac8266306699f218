// The shared benchmark domains, valid and invalid, with what is expected of each.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "catch.h"
#include "domain/domain.h"
#include "io/domain/json_domain.h"

namespace lpq_test {

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The .json files of a folder of the shared data, sorted; says so if the folder is absent.
inline std::vector<std::filesystem::path> shared_domains(const std::string& folder) {
  const std::filesystem::path root = std::filesystem::path(LPQ_SHARED_DATA) / "data" / folder;
  std::vector<std::filesystem::path> files;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(root, missing))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) WARN("SKIPPED: nothing tested here because " << root << " has no domains");
  return files;
}

/// The value of a string member anywhere in a flat piece of JSON text, "" if it is absent.
inline std::string json_member(const std::string& text, const std::string& key) {
  std::size_t at = text.find("\"" + key + "\"");
  if (at == std::string::npos) return "";
  at = text.find('"', text.find(':', at));
  return text.substr(at + 1, text.find('"', at + 1) - at - 1);
}

inline lpq::DomainInput read_domain(const std::filesystem::path& path) {
  auto file = lpq::read_json_domain(read_text(path));
  INFO(path);
  REQUIRE(file.has_value());
  return std::move(file->domain);
}

}  // namespace lpq_test
