// See surface_write.h.
#include "io/surface/surface_write.h"

#include "io/escape.h"
#include "io/number.h"

namespace lpq {
namespace {

void append_group(std::string& out, const std::string& name, Index group) {
  out += "g ";
  if (name.empty()) {
    out += "group_";
    append_integer(out, std::int64_t{group} + 1);
  } else {
    append_obj_name(out, name);
  }
  out += '\n';
}

}  // namespace

std::string write_surface_obj(const SurfaceMesh& surface,
                              std::span<const std::string> group_names) {
  std::string out = "# lpquad\n";
  for (const Vec3 p : surface.points) {
    out += 'v';
    for (const double x : {p.x, p.y, p.z}) {
      out += ' ';
      append_number(out, x);
    }
    out += '\n';
  }
  Index group = none;
  for (Index t = 0; t < surface.triangle_count(); ++t) {
    if (group_names.size() > 1 && surface.group[t] != group) {
      group = surface.group[t];
      append_group(out, group_names[group], group);
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
