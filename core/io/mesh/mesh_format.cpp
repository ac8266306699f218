// See mesh_format.h.
#include "io/mesh/mesh_format.h"

#include <algorithm>

#include "base/check.h"
#include "io/file_kind.h"
#include "io/mesh/bdf.h"
#include "io/mesh/geojson.h"
#include "io/mesh/mesh_json.h"
#include "io/mesh/obj.h"
#include "io/mesh/ply.h"
#include "io/mesh/su2.h"
#include "io/mesh/vtk.h"
#include "io/mesh/vtu.h"
#include "io/picture/svg.h"
#include "io/plain_text.h"
#include "io/text_place.h"

namespace lpq {
namespace {

/// Calls visit(ending, info) in the order of the table until it returns true.
template <class Visit>
void each_ending(Visit&& visit) {
  for (const MeshFormatInfo& info : mesh_formats) {
    std::string_view rest = info.endings;
    while (!rest.empty()) {
      const std::string_view ending = rest.substr(0, rest.find(' '));
      if (visit(ending, info)) return;
      rest.remove_prefix(std::min(rest.size(), ending.size() + 1));
    }
  }
}

bool ends_with(std::string_view text, std::string_view ending) {
  if (text.size() < ending.size()) return false;
  return same_letters(text.substr(text.size() - ending.size()), ending);
}

/// ".obj, .msh, ... or .json" of the formats that are wanted.
template <class Wanted>
std::string endings_of(Wanted&& wanted) {
  std::string text;
  std::size_t last_comma = 0;
  each_ending([&](std::string_view ending, const MeshFormatInfo& info) {
    if (!wanted(info)) return false;
    if (!text.empty()) {
      last_comma = text.size();
      text += ", ";
    }
    text += ending;
    return false;
  });
  return text.replace(last_comma, 1, " or");
}

}  // namespace

std::string mesh_endings() {
  return endings_of([](const MeshFormatInfo&) { return true; });
}

std::string shell_endings() {
  return endings_of([](const MeshFormatInfo& info) { return info.in_space; });
}

bool is_shell_format(MeshFormat format) {
  return std::any_of(mesh_formats.begin(), mesh_formats.end(), [&](const MeshFormatInfo& info) {
    return info.format == format && info.in_space;
  });
}

std::optional<MeshFormat> mesh_format(std::string_view file_name) {
  std::optional<MeshFormat> found;
  each_ending([&](std::string_view ending, const MeshFormatInfo& info) {
    if (ends_with(file_name, ending)) found = info.format;
    return found.has_value();
  });
  return found;
}

std::optional<MeshFormat> mesh_format_by_name(std::string_view name) {
  for (const MeshFormatInfo& info : mesh_formats)
    if (info.name == name) return info.format;
  return std::nullopt;
}

std::string write_mesh(const OutputMesh& mesh, MeshFormat format, const MeshWriteOptions& options) {
  LPQ_ASSERT(!mesh.in_space() || is_shell_format(format));
  switch (format) {
    case MeshFormat::obj: return write_obj(mesh);
    case MeshFormat::msh: return write_msh(mesh, options.msh_version);
    case MeshFormat::vtu: return write_vtu(mesh);
    case MeshFormat::vtk: return write_vtk(mesh);
    case MeshFormat::inp: return write_inp(mesh, options.inp_element);
    case MeshFormat::su2: return write_su2(mesh);
    case MeshFormat::bdf: return write_bdf(mesh);
    case MeshFormat::ply: return write_ply(mesh);
    case MeshFormat::geojson: return write_geojson(mesh);
    case MeshFormat::svg: return draw_quads(mesh);
    case MeshFormat::json: return write_mesh_json(mesh);
  }
  return {};
}

Result<OutputMesh> read_mesh(std::string_view text, MeshFormat format, MeshScope scope) {
  if (auto wide = refuse_utf16(text)) return *std::move(wide);
  if (format != MeshFormat::obj && format != MeshFormat::msh)
    return Error{ErrorCode::parse_error, "Only .obj and .msh meshes can be read back.", {}};
  const bool is_obj = format == MeshFormat::obj;
  auto mesh = is_obj ? read_obj(text, scope) : read_msh(text, scope);
  if (mesh) return mesh;
  return error_of_kind(mesh.error(), text, is_obj ? "obj" : "msh");
}

}  // namespace lpq
