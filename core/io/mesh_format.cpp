// See mesh_format.h.
#include "io/mesh_format.h"

#include "io/mesh_json.h"
#include "io/obj.h"
#include "io/svg.h"
#include "io/vtu.h"

namespace lpq {

std::optional<MeshFormat> mesh_format(std::string_view file_name) {
  struct Ending {
    std::string_view text;
    MeshFormat format;
  };
  constexpr Ending endings[] = {{".obj", MeshFormat::obj},
                                {".msh", MeshFormat::msh},
                                {".vtu", MeshFormat::vtu},
                                {".svg", MeshFormat::svg},
                                {".json", MeshFormat::json}};
  for (const Ending& ending : endings) {
    if (file_name.size() < ending.text.size()) continue;
    const std::string_view tail = file_name.substr(file_name.size() - ending.text.size());
    bool equal = true;
    for (std::size_t i = 0; i < tail.size(); ++i) {
      const char c = tail[i];
      equal =
          equal && (c >= 'A' && c <= 'Z' ? static_cast<char>(c + 'a' - 'A') : c) == ending.text[i];
    }
    if (equal) return ending.format;
  }
  return std::nullopt;
}

std::string write_mesh(const OutputMesh& mesh, MeshFormat format, MshVersion version) {
  switch (format) {
    case MeshFormat::obj: return write_obj(mesh);
    case MeshFormat::msh: return write_msh(mesh, version);
    case MeshFormat::vtu: return write_vtu(mesh);
    case MeshFormat::svg: return draw_quads(mesh);
    case MeshFormat::json: return write_mesh_json(mesh);
  }
  return {};
}

Result<OutputMesh> read_mesh(std::string_view text, MeshFormat format) {
  if (format == MeshFormat::obj) return read_obj(text);
  if (format == MeshFormat::msh) return read_msh(text);
  return Error{ErrorCode::parse_error, "Only .obj and .msh meshes can be read back.", {}};
}

}  // namespace lpq
