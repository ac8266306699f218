// The letters of names in DXF (Autodesk, DXF Reference, "Drawing Files"): UTF-8 since release 2007,
// whatever its header says, before that the code page of the header, and \U+00C4 for what that
// lacks.
#pragma once

#include <string>
#include <string_view>

namespace lpq {

enum class DxfLetters : char { utf8, ansi_1252, unknown };

/// Of a whole file whose header names this code page, "" = none: then ANSI_1252 is taken.
DxfLetters dxf_letters(std::string_view text, std::string_view code_page);

/// A name in UTF-8; of unknown letters only those of ASCII and those written as \U+.
std::string dxf_name(std::string_view name, DxfLetters letters);

}  // namespace lpq
