// Domain files by the endings of their names, by short names, and by what is in them.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/result.h"
#include "io/domain/domain_file.h"

namespace lpq {

enum class DomainFormat { json, geojson, svg, poly, msh, dxf };

struct DomainFormatInfo {
  DomainFormat format;
  std::string_view name;  // also the ending of file names
};

/// Every format that can be read; bindings and messages come from here.
inline constexpr std::array<DomainFormatInfo, 6> domain_formats{{{DomainFormat::json, "json"},
                                                                 {DomainFormat::geojson, "geojson"},
                                                                 {DomainFormat::svg, "svg"},
                                                                 {DomainFormat::poly, "poly"},
                                                                 {DomainFormat::msh, "msh"},
                                                                 {DomainFormat::dxf, "dxf"}}};

inline constexpr std::string_view domain_endings = ".json, .geojson, .svg, .poly, .msh or .dxf";

/// "dxf" -> DomainFormat::dxf; upper or lower case.
std::optional<DomainFormat> domain_format_by_name(std::string_view short_name);
/// By the file name's ending, upper or lower case.
std::optional<DomainFormat> domain_format_by_ending(std::string_view file_name);
/// By the first bytes, for JSON also by its outermost "type".
std::optional<DomainFormat> domain_format_by_content(std::string_view text);

/// Errors: those of the reader; see its header.
Result<DomainFile> read_domain(std::string_view text, DomainFormat format);

/// In the format of the file name's ending, or where that says nothing (also for "", "-" and .json
/// files that hold GeoJSON) of the content. Errors: also parse_error for an unknown format.
Result<DomainFile> read_domain_file(std::string_view file_name, std::string_view text);

}  // namespace lpq
