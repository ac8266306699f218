// Names in files: whatever characters a caller's region or tag has, the file stays well formed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace lpq {

/// Whether the text is well-formed UTF-8.
bool is_utf8(std::string_view text);
/// The Unicode character of this number in UTF-8.
void append_character(std::string& out, std::uint32_t code);

/// XML text or attribute value: & < > " ' escaped, characters that XML 1.0 forbids replaced by '?'.
void append_xml(std::string& out, std::string_view text);
/// A JSON string with its quotes. Bytes that are not UTF-8 become U+FFFD.
void append_json_string(std::string& out, std::string_view text);
/// A name between the quotes of Gmsh's $PhysicalNames, which knows no escapes (though meshio takes
/// a backslash for one): double quotes become single ones, backslashes slashes, control characters
/// spaces, and names longer than `longest_msh_name` bytes are cut between characters.
void append_msh_name(std::string& out, std::string_view text);
inline constexpr std::size_t longest_msh_name = 127;
/// A name for one line of an OBJ file: white space, control characters and a '#' in front, which
/// some readers take for a comment, become '_'.
void append_obj_name(std::string& out, std::string_view text);
/// What a text begins with, at most `longest` bytes, without cutting a character of UTF-8.
std::string_view utf8_start(std::string_view text, std::size_t longest);
/// One line of printable ASCII: control characters become spaces, each other character `other`.
void append_ascii(std::string& out, std::string_view text, std::string_view other = "?");
/// append_ascii in double quotes, for comments: double quotes become single ones, and at most
/// `longest` characters are kept.
void append_quoted_ascii(std::string& out, std::string_view text, std::size_t longest);

}  // namespace lpq
