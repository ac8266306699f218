// The readers of domain and surface files: a module of its own, which a page loads when a file is
// opened.
#include <emscripten/bind.h>

#include "io/domain/domain_format.h"
#include "io/domain/json_domain.h"
#include "io/error_text.h"
#include "io/surface/surface_format.h"
#include "marshal.h"

namespace lpq {
namespace {

/// By the short name of a format, or else by the file's name and content.
Result<DomainFile> read_any(const std::string& text, const std::string& format,
                            const std::string& name) {
  if (format.empty()) return read_domain_file(name, text);
  if (const auto known = domain_format_by_name(format)) return read_domain(text, *known);
  return Error{ErrorCode::bad_option, "There is no domain format '" + format + "'.", {}};
}

val read_domain_text(const std::string& text, const std::string& format, const std::string& name) {
  return guarded([&] {
    const auto file = read_any(text, format, name);
    if (!file) return failure(file.error());
    val result = text_result(write_domain_json(file->domain));
    result.set("warnings", errors_json(file->warnings));
    return result;
  });
}

Result<SurfaceSoup> read_any_surface(const std::string& bytes, const std::string& format,
                                     const std::string& name) {
  if (format.empty()) return read_surface_file(name, bytes);
  if (const auto known = surface_format_by_name(format)) return read_surface(bytes, *known);
  return Error{ErrorCode::bad_option, "There is no surface format '" + format + "'.", {}};
}

val read_surface_bytes(const std::string& bytes, const std::string& format,
                       const std::string& name) {
  return guarded([&] {
    const auto soup = read_any_surface(bytes, format, name);
    if (!soup) return failure(soup.error());
    val result = val::object();
    result.set("points", to_array(soup->points));
    result.set("triangles", to_corners(soup->triangles));
    if (!soup->group.empty()) {
      result.set("groups", to_array(soup->group));
      result.set("groupNames", to_strings(soup->group_names));
    }
    if (!soup->sizes.empty()) result.set("sizes", to_array(soup->sizes));
    if (!soup->body.empty()) {
      result.set("bodies", to_array(soup->body));
      result.set("bodyNames", to_strings(soup->body_names));
    }
    result.set("warnings", errors_json(soup->warnings));
    return result;
  });
}

bool is_surface(const std::string& bytes, const std::string& name) {
  return is_surface_file(name, bytes);
}

}  // namespace

EMSCRIPTEN_BINDINGS(lpquad_readers) {
  emscripten::function("readDomain", &read_domain_text);
  emscripten::function("readSurface", &read_surface_bytes);
  emscripten::function("isSurfaceFile", &is_surface);
}

}  // namespace lpq
