// See domain_format.h.
#include "io/domain/domain_format.h"

#include "io/domain/dxf_domain.h"
#include "io/domain/geojson_domain.h"
#include "io/domain/json_domain.h"
#include "io/domain/msh_domain.h"
#include "io/domain/poly_domain.h"
#include "io/domain/svg_domain.h"
#include "io/file_kind.h"
#include "io/number.h"
#include "io/plain_text.h"
#include "io/surface/surface_format.h"
#include "io/text_lines.h"
#include "io/text_place.h"

namespace lpq {
namespace {

/// Two integers on the first line with words: a .poly file. One, and "SECTION" after it: DXF.
std::optional<DomainFormat> format_by_lines(std::string_view text) {
  LineReader lines(text);
  Words words;
  while (!lines.at_end()) {
    words.split(lines.next());
    if (words.size() == 0) continue;
    std::int64_t value = 0;
    if (!parse_integer(words[0], value)) return std::nullopt;
    if (words.size() > 1) {  // vertices, dimension
      const bool is_poly = parse_integer(words[1], value) && (value == 2 || value == 3);
      return is_poly ? std::optional(DomainFormat::poly) : std::nullopt;
    }
    constexpr std::int64_t comment = 999;
    if (value == comment) return DomainFormat::dxf;
    words.split(lines.next());
    if (value == 0 && words.size() == 1 && words[0] == "SECTION") return DomainFormat::dxf;
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<DomainFormat> domain_format_by_name(std::string_view short_name) {
  for (const DomainFormatInfo& one : domain_formats)
    if (same_letters(one.name, short_name)) return one.format;
  return std::nullopt;
}

std::optional<DomainFormat> domain_format_by_ending(std::string_view file_name) {
  return domain_format_by_name(ending_of(file_name));
}

std::optional<DomainFormat> domain_format_by_content(std::string_view text) {
  text.remove_prefix(byte_order_mark_size(text));
  const std::string_view rest = past_blanks(text);
  if (rest.empty()) return std::nullopt;
  if (rest[0] == '{') return looks_like_geojson(rest) ? DomainFormat::geojson : DomainFormat::json;
  if (rest[0] == '<') return DomainFormat::svg;
  if (rest.substr(0, 11) == "$MeshFormat") return DomainFormat::msh;
  if (rest.substr(0, 14) == "AutoCAD Binary") return DomainFormat::dxf;
  return format_by_lines(text);
}

namespace {

Result<DomainFile> read_as(std::string_view text, DomainFormat format) {
  switch (format) {
    case DomainFormat::json: return read_json_domain(text);
    case DomainFormat::geojson: return read_geojson_domain(text);
    case DomainFormat::svg: return read_svg_domain(text);
    case DomainFormat::poly: return read_poly_domain(text);
    case DomainFormat::msh: return read_msh_domain(text);
    case DomainFormat::dxf: return read_dxf_domain(text);
  }
  return Error{};
}

}  // namespace

Result<DomainFile> read_domain(std::string_view text, DomainFormat format) {
  if (auto wide = refuse_utf16(text)) return *std::move(wide);
  auto file = read_as(text, format);
  if (file) return file;
  return error_of_kind(file.error(), text, domain_formats[static_cast<std::size_t>(format)].name);
}

Result<DomainFile> read_domain_file(std::string_view file_name, std::string_view text) {
  if (auto wide = refuse_utf16(text)) return *std::move(wide);
  auto format = domain_format_by_ending(file_name);
  const bool is_other = surface_format_by_ending(file_name) || kind_by_ending(file_name);
  if ((!format && !is_other) || format == DomainFormat::json) {
    const auto found = domain_format_by_content(text);
    if (!format || found == DomainFormat::geojson) format = found;
  }
  if (format) return read_domain(text, *format);
  return unknown_format(file_name, text);
}

}  // namespace lpq
