// Surface files by the endings of their names, by short names, and by what is in them.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/result.h"
#include "surface/soup.h"

namespace lpq {

enum class SurfaceFormat { obj, off, stl, ply, msh };

struct SurfaceFormatInfo {
  SurfaceFormat format;
  std::string_view name;  // also the ending of file names
};

/// Every format that can be read; bindings and messages come from here.
inline constexpr std::array<SurfaceFormatInfo, 5> surface_formats{{{SurfaceFormat::obj, "obj"},
                                                                   {SurfaceFormat::off, "off"},
                                                                   {SurfaceFormat::stl, "stl"},
                                                                   {SurfaceFormat::ply, "ply"},
                                                                   {SurfaceFormat::msh, "msh"}}};

inline constexpr std::string_view surface_endings = ".obj, .off, .stl, .ply or .msh";

/// "stl" -> SurfaceFormat::stl; upper or lower case.
std::optional<SurfaceFormat> surface_format_by_name(std::string_view short_name);
/// By the file name's ending, upper or lower case.
std::optional<SurfaceFormat> surface_format_by_ending(std::string_view file_name);
/// By the first bytes; OBJ by its first line that is no comment.
std::optional<SurfaceFormat> surface_format_by_content(std::string_view bytes);

/// Is it a surface rather than a domain in the plane? By the file name's ending; a .msh file is one
/// by is_msh_in_space(). Where the ending says nothing, by the content.
bool is_surface_file(std::string_view file_name, std::string_view bytes);

/// Errors: those of the reader; see its header.
Result<SurfaceSoup> read_surface(std::string_view bytes, SurfaceFormat format);

/// In the format of the file name's ending, or where that says nothing (also for "" and "-") of the
/// content. Errors: also parse_error for an unknown format.
Result<SurfaceSoup> read_surface_file(std::string_view file_name, std::string_view bytes);

}  // namespace lpq
