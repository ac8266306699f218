// See surface_input.h.
#include "cli/surface_input.h"

#include "cli/files.h"
#include "io/plain_text.h"

#ifdef __EMSCRIPTEN__
#include <emscripten.h>

#include <cstddef>

// wasm/js/cli.js hands in a reader of CAD files. First it makes the text and tells its length,
// below zero for a code and a sentence that say what is wrong; then it copies the text.
EM_JS(double, lpq_cad_load,
      (const char* bytes, std::size_t length, const char* name, double size, double quads), {
        const from = bytes >>> 0;
        return Module["cad"].load(HEAPU8.slice(from, from + (length >>> 0)), UTF8ToString(name),
                                  size, quads);
      });
EM_JS(void, lpq_cad_take, (char* to), { HEAPU8.set(Module["cad"].take(), to >>> 0); });
#endif

namespace lpq {
namespace {

#ifdef __EMSCRIPTEN__
/// From "CODE What is wrong."
Error error_from(const std::string& text) {
  const std::size_t blank = text.find(' ');
  Error error{ErrorCode::parse_error, text.substr(blank + 1), {}};
  for (int code = 0; code <= static_cast<int>(ErrorCode::io_error); ++code)
    if (text.substr(0, blank) == code_name(static_cast<ErrorCode>(code)))
      error.code = static_cast<ErrorCode>(code);
  return error;
}

Result<std::string> cad_triangles(const std::string& name, const QuadsAsked& asked) {
  const auto bytes = read_file(name);
  if (!bytes) return bytes.error();
  const double length =
      lpq_cad_load(bytes->data(), bytes->size(), name.c_str(), asked.size, asked.quads);
  std::string text(static_cast<std::size_t>(length < 0 ? -length : length), ' ');
  lpq_cad_take(text.data());
  if (length < 0) return error_from(text);
  return text;
}
#else
Result<std::string> cad_triangles(const std::string& name, const QuadsAsked&) {
  const auto bytes = read_file(name);
  if (!bytes) return bytes.error();
  const std::string stem = file_stem(name);
  return Error{ErrorCode::parse_error,
               "This program does not read CAD files. The one for Node does: npm install lpquad "
               "occt-import-js, then npx lpquad mesh " +
                   name + " ..., or npx lpquad convert " + name + " -o " + stem +
                   ".obj for triangles that this one reads.",
               {}};
}
#endif

}  // namespace

bool is_cad_file(std::string_view name) {
  for (const char* ending : {"step", "stp", "iges", "igs", "brep", "brp"})
    if (same_letters(ending_of(name), ending)) return true;
  return false;
}

Result<std::string> read_input(const std::string& name, const QuadsAsked& asked) {
  return is_cad_file(name) ? cad_triangles(name, asked) : read_file(name);
}

}  // namespace lpq
