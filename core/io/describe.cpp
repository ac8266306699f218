// See describe.h.
#include "io/describe.h"

#include "io/domain/domain_format.h"
#include "io/json_write.h"
#include "io/mesh/mesh_format.h"
#include "io/surface/surface_format.h"
#include "pipeline/options.h"
#include "shell/options.h"

namespace lpq {
namespace {

template <class T>
void append_kind(JsonWriter& json, const T& value, const OptionInfo& info) {
  if constexpr (std::is_same_v<T, bool>) {
    json.member("type", "boolean");
    json.member("default", value);
  } else if constexpr (std::is_enum_v<T>) {
    json.member("type", "choice");
    json.member("default", choice_name(value));
    json.array("choices", ChoiceNames<T>::names);
  } else {
    json.member("type", std::is_integral_v<T> ? "integer" : "number");
    json.member("default", value);
    json.member("min", info.min);
    json.member("max", info.max);
  }
}

template <class Table>
void append_table(JsonWriter& json, std::string_view table, const Table& defaults) {
  json.begin_array(table);
  each_field(defaults, [&](const char* name, const auto& value, const OptionInfo& info) {
    json.begin_object();
    json.member("name", name);
    append_kind(json, value, info);
    json.member("unit", info.unit);
    json.member("help", info.help);
    json.end_object();
  });
  json.end_array();
}

void append_codes(JsonWriter& json) {
  json.begin_array("errorCodes");
  for (int code = 0; code <= static_cast<int>(ErrorCode::io_error); ++code)
    json.value(code_name(static_cast<ErrorCode>(code)));
  json.end_array();
}

template <class Formats>
void append_names(JsonWriter& json, std::string_view key, const Formats& formats) {
  json.begin_array(key);
  for (const auto& info : formats) json.value(info.name);
  json.end_array();
}

/// The formats that hold meshes on surfaces.
void append_shell_formats(JsonWriter& json) {
  json.begin_array("surfaceMeshFormats");
  for (const MeshFormatInfo& info : mesh_formats)
    if (info.in_space) json.value(info.name);
  json.end_array();
}

}  // namespace

const char* version() { return LPQ_VERSION; }

std::string write_description() {
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  json.member("version", version());
  append_table(json, "options", Options{});
  append_table(json, "surfaceOptions", SurfaceOptions{});
  append_table(json, "writeOptions", MeshWriteOptions{});
  append_codes(json);
  append_names(json, "meshFormats", mesh_formats);
  append_names(json, "domainFormats", domain_formats);
  append_names(json, "surfaceFormats", surface_formats);
  append_shell_formats(json);
  json.end_object();
  out += '\n';
  return out;
}

}  // namespace lpq
