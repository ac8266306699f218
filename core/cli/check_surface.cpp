// See check_surface.h.
#include "cli/check_surface.h"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.h"
#include "cli/surface_input.h"
#include "io/report_parts.h"
#include "io/surface/surface_format.h"
#include "io/surface_report.h"
#include "shell/distance.h"
#include "shell/quality.h"
#include "shell/topology.h"
#include "surface/repair.h"

namespace lpq {
namespace {

ShellMesh as_shell(const OutputMesh& mesh) {
  ShellMesh shell;
  for (Index v = 0; v < static_cast<Index>(mesh.points.size()); ++v)
    shell.points.push_back(mesh.point(v));
  shell.faces = mesh.faces;
  return shell;
}

std::string topology_text(const char* name, const ShellTopology& topology) {
  std::string out;
  Facts facts;
  facts.count("parts", topology.components).count("borders", topology.borders);
  facts.count("Euler number", topology.euler);
  if (topology.meeting_edges > 0)
    facts.count("edges of three faces or more", topology.meeting_edges);
  if (topology.pinches > 0) facts.count("pinched vertices", topology.pinches);
  append_row(out, name, facts.text());
  return out;
}

class Judge {
 public:
  Judge(const OutputMesh& mesh, bool has_bodies) : shell_(as_shell(mesh)) {
    if (has_bodies) tell_parts();
  }

  void alone() {
    topology_ = shell_topology(shell_.faces);
    verdict_.text = quality_text(shell_quality(shell_)) + topology_text("mesh", topology_);
    for (const Violation& violation : validate_faces(shell_.points, shell_.faces, most, parts_))
      add(violation.what, shell_.points[violation.vertex]);
  }

  /// One-sided edges are wrong, except where the surface itself is one-sided.
  void orientation(bool one_sided) {
    if (topology_.one_sided_edges == 0 || one_sided) return;
    add("Faces beside " + std::to_string(topology_.one_sided_edges) +
        " edges look to opposite sides.");
  }

  void against(const SurfaceMesh& surface) {
    const ShellTopology wanted = shell_topology(faces_of(surface.triangles));
    verdict_.text += topology_text("surface", wanted);
    compare("parts", topology_.components, wanted.components);
    compare("borders", topology_.borders, wanted.borders);
    compare("Euler number", topology_.euler, wanted.euler);
    if (topology_.meeting_edges > 0 && wanted.meeting_edges == 0)
      add("Three faces or more meet at an edge, which the surface has nowhere.");
    orientation(wanted.one_sided_edges > 0);
    const SurfaceDistance distance = surface_distance(surface.points, surface.triangles, shell_);
    verdict_.text += distance_text(distance);
    const double longest = longest_edge();
    if (distance.to_surface.max > longest)
      add("The mesh goes farther from the surface than its longest edge is long.");
    if (distance.from_surface.max > longest)
      add("The surface goes farther from the mesh than its longest edge is long.");
  }

  ShellVerdict take() { return std::move(verdict_); }

 private:
  static constexpr std::size_t most = 10;

  /// What hangs together: bodies of the surface may touch, and their meshes then as well.
  void tell_parts() {
    DisjointSets sets(static_cast<Index>(shell_.points.size()));
    for (const Face& face : shell_.faces)
      for (int k = 1; k < corner_count(face); ++k) sets.unite(face[0], face[k]);
    for (Index v = 0; v < static_cast<Index>(shell_.points.size()); ++v)
      parts_.push_back(sets.root(v));
  }

  void add(const std::string& what) { verdict_.violations += "  " + what + "\n"; }
  void add(const std::string& what, Vec3 at) {
    verdict_.violations += "  " + what + " (at " + short_number(at.x) + " " + short_number(at.y) +
                           " " + short_number(at.z) + ")\n";
  }
  void compare(const char* what, Index got, Index wanted) {
    if (got == wanted) return;
    add("The mesh has " + std::string(what) + " " + std::to_string(got) + ", the surface " +
        std::to_string(wanted) + ".");
  }

  double longest_edge() const {
    double longest = 0;
    for (const Face& face : shell_.faces)
      for (int k = 0, n = corner_count(face); k < n; ++k)
        longest = std::max(
            longest, squared_length(shell_.points[face[(k + 1) % n]] - shell_.points[face[k]]));
    return std::sqrt(longest);
  }

  ShellMesh shell_;
  std::vector<Index> parts_;  // #V  empty: vertices in one place are one too many
  ShellTopology topology_;
  ShellVerdict verdict_;
};

}  // namespace

ShellVerdict judge_shell(const OutputMesh& mesh, const SurfaceMesh* surface) {
  Judge judge(mesh, surface != nullptr && !surface->body.empty());
  judge.alone();
  if (surface != nullptr) {
    judge.against(*surface);
  } else {
    judge.orientation(false);
  }
  return judge.take();
}

Result<SurfaceMesh> load_surface(const std::string& name, double weld) {
  const auto bytes = read_input(name);
  if (!bytes) return bytes.error();
  auto soup = read_surface_file(name, *bytes);
  if (!soup) return soup.error();
  auto repaired = repair_surface(std::move(*soup), {.weld = weld});
  if (!repaired) return repaired.error();
  return std::move(repaired->mesh);
}

}  // namespace lpq
