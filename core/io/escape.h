// Names in files: whatever characters a caller's region or tag has, the file stays well formed.
#pragma once

#include <string>
#include <string_view>

namespace lpq {

/// XML text or attribute value: & < > " ' escaped, characters that XML 1.0 forbids replaced by '?'.
void append_xml(std::string& out, std::string_view text);
/// A JSON string with its quotes. Bytes that are not UTF-8 become U+FFFD.
void append_json_string(std::string& out, std::string_view text);
/// A quoted name of Gmsh's $PhysicalNames, which knows no escapes and holds 127 bytes: double
/// quotes become single ones, control characters spaces, longer names are cut between characters.
void append_msh_name(std::string& out, std::string_view text);
/// A name for one line of an OBJ file: white space and control characters become '_'.
void append_obj_name(std::string& out, std::string_view text);

}  // namespace lpq
