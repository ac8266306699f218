// See obj.h.
#include "io/mesh/obj.h"

#include <map>
#include <string>
#include <string_view>

#include "io/escape.h"
#include "io/mesh/output_parts.h"
#include "io/mesh/region_groups.h"
#include "io/number.h"
#include "io/obj_text.h"
#include "io/surface/surface_text.h"
#include "io/text_lines.h"
#include "io/unique_names.h"

namespace lpq {
namespace {

void append_vertex(std::string& out, Vec3 p) {
  out += "v ";
  append_numbers(out, {p.x, p.y, p.z});
  out += '\n';
}

template <std::size_t N>
void append_face(std::string& out, const std::array<Index, N>& face) {
  out += 'f';
  for (const Index v : face) {
    if (v == none) break;
    out += ' ';
    append_integer(out, std::int64_t{v} + 1);
  }
  out += '\n';
}

std::vector<std::string> names_in_file(const OutputMesh& mesh, const RegionGroups& groups) {
  std::vector<std::string> names;
  for (Index g = 0; g < groups.count(); ++g) names.push_back(region_label(mesh, groups.first(g)));
  return unique_names(names, append_obj_name);
}

}  // namespace

std::string write_obj(const OutputMesh& mesh) {
  std::string out = "# lpquad\n";
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    append_vertex(out, mesh.point(static_cast<Index>(v)));
  // Faces keep their order: a new `g` line wherever the region changes.
  const RegionGroups groups = region_groups(mesh);
  const std::vector<std::string> names = names_in_file(mesh, groups);
  Index region = none;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.regions.size() > 1 && mesh.region[f] != region) {
      region = mesh.region[f];
      out += "g ";
      out += names[static_cast<std::size_t>(groups.of(region))];
      out += '\n';
    }
    append_face(out, mesh.faces[f]);
  }
  return out;
}

std::string write_obj(const TriMesh& mesh) {
  std::string out = "# lpquad\n";
  for (const Vec2 p : mesh.points) append_vertex(out, {p.x, p.y, 0});
  for (const Tri& triangle : mesh.triangles) append_face(out, triangle);
  return out;
}

namespace {

class ObjReader {
 public:
  ObjReader(std::string_view text, MeshScope scope)
      : lines_(text), corners_(lines_), scope_(scope) {}

  Result<OutputMesh> read() {
    while (!lines_.at_end() && !failed_) {
      const Words& words = lines_.next();
      if (words.size() == 0) continue;
      if (words[0] == "v") {
        read_vertex(words);
      } else if (words[0] == "f") {
        read_face(words);
      } else if (words[0] == "g") {
        enter_group(joined_words(words, 1));
      }
    }
    if (failed_) return error_;
    if (!corners_.all_there(static_cast<Index>(mesh_.points.size()))) return corners_.error();
    if (mesh_.faces.empty()) return lines_.error("The file has no face (no line 'f ...').");
    drop_unused_points(mesh_);
    drop_flat_heights(mesh_);
    return std::move(mesh_);
  }

 private:
  void fail(std::string message) {
    failed_ = true;
    error_ = lines_.error(std::move(message));
  }

  void read_vertex(const Words& words) {
    Vec2 p;
    double z = 0;
    if (words.size() < 3 || !parse_number(words[1], p.x) || !parse_number(words[2], p.y) ||
        (words.size() > 3 && !parse_number(words[3], z))) {
      return fail("A vertex needs two or three finite numbers: 'v x y 0'.");
    }
    if (z != 0 && scope_ == MeshScope::plane)
      return fail("A vertex has z different from 0; only plane meshes can be read.");
    mesh_.points.push_back(p);
    mesh_.z.push_back(z);
  }

  void read_face(const Words& words) {
    const std::size_t corners = words.size() - 1;
    if (corners != 3 && corners != 4) return fail("A face must have three or four corners.");
    Face face{none, none, none, none};
    for (std::size_t k = 0; k < corners; ++k) {
      face[k] = corners_.read(words[k + 1], static_cast<Index>(mesh_.points.size()));
      if (face[k] != none) continue;
      failed_ = true;
      error_ = corners_.error();
      return;
    }
    if (mesh_.regions.empty()) enter_group({});
    mesh_.faces.push_back(face);
    mesh_.region.push_back(group_);
  }

  void enter_group(const std::string& name) {
    const auto [at, is_new] = groups_.try_emplace(name, static_cast<Index>(mesh_.regions.size()));
    if (is_new) mesh_.regions.emplace_back(name);
    group_ = at->second;
  }

  ObjLines lines_;
  ObjCorners corners_;
  MeshScope scope_;
  OutputMesh mesh_;
  std::map<std::string, Index> groups_;  // numbers of the regions
  Index group_ = 0;
  bool failed_ = false;
  Error error_;
};

}  // namespace

Result<OutputMesh> read_obj(std::string_view text, MeshScope scope) {
  return ObjReader(text, scope).read();
}

}  // namespace lpq
