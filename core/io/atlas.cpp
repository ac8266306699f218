// See atlas.h.
#include "io/atlas.h"

#include <map>

#include "io/escape.h"
#include "io/number.h"
#include "io/unique_names.h"
#include "shell/output.h"
#include "surface/charts/layout.h"

namespace lpq {
namespace {

void append_point(std::string& out, const char* keyword, std::initializer_list<double> numbers) {
  out += keyword;
  out += ' ';
  append_numbers(out, numbers);
  out += '\n';
}

void append_chart(std::string& out, const SurfaceMesh& surface, const Chart& chart,
                  std::int64_t first_place) {
  for (std::size_t k = 0; k < chart.triangles.size(); ++k) {
    out += 'f';
    for (std::size_t corner = 0; corner < 3; ++corner) {
      out += ' ';
      append_integer(out, std::int64_t{surface.triangles[chart.triangles[k]][corner]} + 1);
      out += '/';
      append_integer(out, first_place + chart.plane.triangles[k][corner]);
    }
    out += '\n';
  }
}

/// Faces of one name share it in the file, too.
std::vector<std::string> island_names(const ShellOutcome& outcome) {
  UniqueNames unique;
  std::map<std::string, std::string> known;
  std::vector<std::string> names = face_names(outcome);
  for (std::string& name : names) {
    const auto [at, is_new] = known.try_emplace(name);
    std::string plain;
    append_obj_name(plain, name);
    if (is_new) at->second = unique.add(plain);
    name = at->second;
  }
  return names;
}

}  // namespace

std::string write_atlas_obj(const ShellOutcome& outcome) {
  const std::vector<Chart>& charts = outcome.atlas.charts;
  const AtlasLayout layout = lay_out(charts);
  const std::vector<std::string> names = island_names(outcome);
  std::string out = "# lpquad: charts of a surface; the square's side is ";
  append_number(out, layout.side);
  out += " long\n";
  for (const Vec3 p : outcome.surface.points) append_point(out, "v", {p.x, p.y, p.z});
  std::int64_t first_place = 1;
  for (Index c = 0; c < static_cast<Index>(charts.size()); ++c) {
    for (const Vec2 p : charts[c].plane.points) {
      const Vec2 uv = layout.place(c, p);
      append_point(out, "vt", {uv.x, uv.y});
    }
    out += "g ";
    out += names[charts[c].face];
    out += " chart_";
    append_integer(out, std::int64_t{c} + 1);
    out += '\n';
    append_chart(out, outcome.surface, charts[c], first_place);
    first_place += static_cast<std::int64_t>(charts[c].plane.points.size());
  }
  return out;
}

}  // namespace lpq
