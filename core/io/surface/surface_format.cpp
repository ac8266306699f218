// See surface_format.h.
#include "io/surface/surface_format.h"

#include <algorithm>
#include <string>

#include "io/domain/domain_format.h"
#include "io/file_kind.h"
#include "io/mesh/msh_parse.h"
#include "io/plain_text.h"
#include "io/surface/msh_surface.h"
#include "io/surface/obj_surface.h"
#include "io/surface/off_surface.h"
#include "io/surface/ply_surface.h"
#include "io/surface/stl_surface.h"
#include "io/text_lines.h"
#include "io/text_place.h"

namespace lpq {
namespace {

bool starts_like_obj(std::string_view text) {
  LineReader lines(text);
  Words words;
  while (!lines.at_end()) {
    words.split(lines.next());
    if (words.size() == 0) continue;
    for (const std::string_view keyword : {"v", "vn", "vt", "f", "o", "g", "s", "mtllib", "usemtl"})
      if (words[0] == keyword) return true;
    return false;
  }
  return false;
}

/// Past comments, [ST][C][N][4][n]OFF, or the same in small letters.
bool starts_like_off(std::string_view text) {
  while (!text.empty() && text[0] == '#') {
    text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
    text = past_blanks(text);
  }
  const std::string_view word =
      text.substr(0, std::min(text.find_first_of(" \t\r\n"), text.size()));
  if (word.size() > 2 && word.substr(word.size() - 3) == "off")
    return word.find_first_not_of("stcn4of") == std::string_view::npos;
  const std::size_t off = word.substr(0, 8).find("OFF");
  return off != std::string_view::npos &&
         word.substr(0, off).find_first_not_of("STCN4n") == std::string_view::npos;
}

}  // namespace

std::optional<SurfaceFormat> surface_format_by_name(std::string_view short_name) {
  for (const SurfaceFormatInfo& one : surface_formats)
    if (same_letters(short_name, one.name)) return one.format;
  return std::nullopt;
}

std::optional<SurfaceFormat> surface_format_by_ending(std::string_view file_name) {
  return surface_format_by_name(ending_of(file_name));
}

std::optional<SurfaceFormat> surface_format_by_content(std::string_view bytes) {
  if (is_binary_stl(bytes)) return SurfaceFormat::stl;
  bytes.remove_prefix(byte_order_mark_size(bytes));
  const std::string_view rest = past_blanks(bytes);
  if (rest.empty()) return std::nullopt;
  if (rest.substr(0, 4) == "ply\n" || rest.substr(0, 4) == "ply\r") return SurfaceFormat::ply;
  if (rest.substr(0, 11) == "$MeshFormat") return SurfaceFormat::msh;
  if (same_letters(rest.substr(0, 5), "solid")) return SurfaceFormat::stl;
  if (starts_like_off(rest)) return SurfaceFormat::off;
  return starts_like_obj(rest) ? std::optional(SurfaceFormat::obj) : std::nullopt;
}

bool is_surface_file(std::string_view file_name, std::string_view bytes) {
  auto format = surface_format_by_ending(file_name);
  if (!format && !domain_format_by_ending(file_name) && !kind_by_ending(file_name)) {
    format = surface_format_by_content(bytes);
    if (format != SurfaceFormat::msh && domain_format_by_content(bytes)) return false;
  }
  return format && (*format != SurfaceFormat::msh || is_msh_in_space(bytes));
}

namespace {

Result<SurfaceSoup> read_as(std::string_view bytes, SurfaceFormat format) {
  switch (format) {
    case SurfaceFormat::obj: return read_obj_surface(bytes);
    case SurfaceFormat::off: return read_off_surface(bytes);
    case SurfaceFormat::stl: return read_stl_surface(bytes);
    case SurfaceFormat::ply: return read_ply_surface(bytes);
    case SurfaceFormat::msh: return read_msh_surface(bytes);
  }
  return Error{};
}

}  // namespace

Result<SurfaceSoup> read_surface(std::string_view bytes, SurfaceFormat format) {
  // A binary STL may begin with any bytes.
  if (!is_binary_stl(bytes))
    if (auto wide = refuse_utf16(bytes)) return *std::move(wide);
  auto soup = read_as(bytes, format);
  if (soup) return soup;
  return error_of_kind(soup.error(), bytes, surface_formats[static_cast<std::size_t>(format)].name);
}

Result<SurfaceSoup> read_surface_file(std::string_view file_name, std::string_view bytes) {
  auto format = surface_format_by_ending(file_name);
  if (!format) format = surface_format_by_content(bytes);
  if (format) return read_surface(bytes, *format);
  return unknown_format(file_name, bytes);
}

}  // namespace lpq
