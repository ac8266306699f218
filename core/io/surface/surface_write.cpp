// See surface_write.h.
#include "io/surface/surface_write.h"

#include "io/escape.h"
#include "io/number.h"

namespace lpq {
namespace {

/// "g name", or "g group_3" where it has none.
void append_name(std::string& out, char keyword, const std::string& name, const char* kind,
                 Index number) {
  out += keyword;
  out += ' ';
  if (name.empty()) {
    out += kind;
    append_integer(out, std::int64_t{number} + 1);
  } else {
    append_obj_name(out, name);
  }
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
  Index group = none, body = none;
  for (Index t = 0; t < surface.triangle_count(); ++t) {
    const Index new_body = surface.body_of(surface.triangles[t][0]);
    if (!body_names.empty() && new_body != body) {
      body = new_body;
      append_name(out, 'o', body_names[body], "body_", body);
    }
    if (group_names.size() > 1 && surface.group[t] != group) {
      group = surface.group[t];
      append_name(out, 'g', group_names[group], "group_", group);
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
