// Help texts, made from the option tables.
#pragma once

#include <string>

namespace lpq {

std::string general_help();
std::string mesh_help();
std::string check_help();
std::string convert_help();
std::string version_text();

}  // namespace lpq
