// See obj.h.
#include "io/mesh/obj.h"

#include <map>
#include <string>
#include <string_view>

#include "io/escape.h"
#include "io/mesh/region_groups.h"
#include "io/mesh_text.h"
#include "io/number.h"
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
  ObjReader(std::string_view text, MeshScope scope) : lines_(text), scope_(scope) {}

  Result<OutputMesh> read() {
    while (!lines_.at_end() && !failed_) {
      words_.split(lines_.next());
      if (words_.size() == 0) continue;
      if (words_[0] == "v") {
        read_vertex();
      } else if (words_[0] == "f") {
        read_face();
      } else if (words_[0] == "g") {
        enter_group(words_.size() > 1 ? words_[1] : std::string_view());
      }
    }
    if (failed_) return error_;
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

  void read_vertex() {
    Vec2 p;
    double z = 0;
    if (words_.size() < 3 || !parse_number(words_[1], p.x) || !parse_number(words_[2], p.y) ||
        (words_.size() > 3 && !parse_number(words_[3], z))) {
      return fail("A vertex needs two or three finite numbers: 'v x y 0'.");
    }
    if (z != 0 && scope_ == MeshScope::plane)
      return fail("A vertex has z different from 0; only plane meshes can be read.");
    mesh_.points.push_back(p);
    mesh_.z.push_back(z);
  }

  void read_face() {
    const std::size_t corners = words_.size() - 1;
    if (corners != 3 && corners != 4) return fail("A face must have three or four corners.");
    Face face{none, none, none, none};
    const auto count = static_cast<std::int64_t>(mesh_.points.size());
    for (std::size_t k = 0; k < corners; ++k) {
      const std::string_view word = words_[k + 1];
      std::int64_t index = 0;
      if (!parse_integer(word.substr(0, word.find('/')), index)) {
        return fail("A face corner must be a vertex number.");
      }
      index = index > 0 ? index - 1 : count + index;
      if (index < 0 || index >= count) return fail("A face names a vertex that is not there.");
      face[k] = static_cast<Index>(index);
    }
    if (mesh_.regions.empty()) enter_group({});
    mesh_.faces.push_back(face);
    mesh_.region.push_back(group_);
  }

  void enter_group(std::string_view name) {
    const auto [at, is_new] =
        groups_.insert({std::string(name), static_cast<Index>(mesh_.regions.size())});
    if (is_new) mesh_.regions.emplace_back(name);
    group_ = at->second;
  }

  LineReader lines_;
  MeshScope scope_;
  Words words_;
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
