// See surface_write.h.
#include "io/surface/surface_write.h"

#include "io/escape.h"
#include "io/number.h"
#include "io/unique_names.h"

namespace lpq {
namespace {

/// "group_3" where it has none. Groups stay apart whatever their names are: there are curves where
/// they meet.
std::vector<std::string> names_in_file(std::span<const std::string> names, const char* kind) {
  std::vector<std::string> full(names.begin(), names.end());
  for (std::size_t i = 0; i < full.size(); ++i)
    if (full[i].empty()) full[i] = kind + std::to_string(i + 1);
  return unique_names(full, append_obj_name);
}

void append_name(std::string& out, char keyword, const std::string& name) {
  out += keyword;
  out += ' ';
  out += name;
  out += '\n';
}

}  // namespace

std::string write_surface_obj(const SurfaceMesh& surface, std::span<const std::string> group_names,
                              std::span<const std::string> body_names) {
  std::string out = "# lpquad\n";
  for (const Vec3 p : surface.points) {
    out += "v ";
    append_numbers(out, {p.x, p.y, p.z});
    out += '\n';
  }
  const std::vector<std::string> groups = names_in_file(group_names, "group_"),
                                 bodies = names_in_file(body_names, "body_");
  Index group = none, body = none;
  for (Index t = 0; t < surface.triangle_count(); ++t) {
    const Index new_body = surface.body_of(surface.triangles[t][0]);
    if (!body_names.empty() && new_body != body) {
      body = new_body;
      append_name(out, 'o', bodies[body]);
    }
    if (group_names.size() > 1 && surface.group[t] != group) {
      group = surface.group[t];
      append_name(out, 'g', groups[group]);
    }
    out += 'f';
    for (const Index v : surface.triangles[t]) {
      out += ' ';
      append_integer(out, std::int64_t{v} + 1);
    }
    out += '\n';
  }
  return out;
}

}  // namespace lpq
