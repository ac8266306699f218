#include "surface/charts/map_part.h"

#include <utility>

#include "numerics/elementary.h"
#include "surface/charts/bff.h"
#include "surface/charts/conformal.h"
#include "surface/charts/dirichlet.h"
#include "surface/frames.h"

namespace lpq {
namespace {

// Vertex values exaggerate what the triangles' scales will be.
constexpr double early_margin = 1.5;
// The iterations of the last resort are for small parts; large ones are split.
constexpr Index most_iterated_triangles = 2000;
// The same for the dear factors of spectral maps: where two maps have turned a few of very many
// triangles over, this one mostly does as well.
constexpr Index most_spectral_triangles = 100'000;

// A map that keeps the lengths of the border has no more room inside than a circle of that length.
bool too_domed(const SurfaceMesh& mesh, const Part& part, double range) {
  double area = 0;
  for (const Index t : part.triangles) area += layout_of(mesh, t).area;
  const double length = loop_length(part, 0);
  return 4 * pi * area > range * range * length * length;
}

class Attempt {
 public:
  Attempt(const SurfaceMesh& mesh, const Part& part, const MapLimits& limits)
      : mesh_(mesh), part_(part), limits_(limits) {}
  PartMap run(MapMethod last);
  /// One triangle is laid down as it is.
  PartMap lay_down();

 private:
  bool solve(MapMethod method, const Intrinsic& disk);
  void judge(MapMethod method);
  // No other method needs to be asked: the map is good, or conformal and still distorted.
  bool decided() const {
    return map_.verdict == Verdict::accepted || map_.verdict == Verdict::distorted;
  }

  const SurfaceMesh& mesh_;
  const Part& part_;
  const MapLimits& limits_;
  PartMap map_;
};

void Attempt::judge(MapMethod method) {
  map_.check = check_map(mesh_, part_, map_.uv);
  if (map_.check.flipped > 0)
    map_.verdict = Verdict::flipped;
  else if (map_.check.crossing)
    map_.verdict = Verdict::crossing;
  else
    map_.verdict = map_.check.within(limits_) ? Verdict::accepted : Verdict::distorted;
  if (map_.verdict == Verdict::accepted) map_.method = method;
}

// Whether there is a map to judge.
bool Attempt::solve(MapMethod method, const Intrinsic& disk) {
  switch (method) {
    case MapMethod::bff: {
      const double range = early_margin * limits_.scale_range;
      const MapOutcome outcome = map_bff(part_, disk, range, map_.uv);
      if (outcome == MapOutcome::distorted) map_.verdict = Verdict::distorted;
      return outcome == MapOutcome::mapped;
    }
    case MapMethod::lscm: return map_lscm(mesh_, part_, disk, map_.uv);
    case MapMethod::scp:
      return part_.triangle_count() <= most_spectral_triangles && map_scp(part_, disk, map_.uv);
    case MapMethod::symmetric_dirichlet:
      return map_.verdict == Verdict::flipped &&
             part_.triangle_count() <= most_iterated_triangles &&
             map_symmetric_dirichlet(mesh_, part_, map_.uv);
    case MapMethod::none_found: break;
  }
  return false;
}

PartMap Attempt::lay_down() {
  const TriangleLayout layout = layout_of(mesh_, part_.triangles[0]);
  map_.uv.resize(3);
  map_.uv[part_.corners[0][1]] = layout.side[0];
  map_.uv[part_.corners[0][2]] = -layout.side[2];
  judge(MapMethod::bff);
  return std::move(map_);
}

PartMap Attempt::run(MapMethod last) {
  Intrinsic disk = intrinsic_of(mesh_, part_);
  flip_to_delaunay(disk);
  map_.verdict = Verdict::flipped;
  for (const MapMethod method :
       {MapMethod::bff, MapMethod::lscm, MapMethod::scp, MapMethod::symmetric_dirichlet}) {
    if (solve(method, disk)) judge(method);
    if (decided() || method == last) break;
  }
  return std::move(map_);
}

}  // namespace

PartMap map_part(const SurfaceMesh& mesh, const Part& part, const MapLimits& limits, MapMethod last,
                 bool& solved) {
  PartMap map;
  solved = false;
  if (part.loops.rows() == 0 || part.genus() > 0) return map;
  if (part.triangle_count() == 1) return Attempt(mesh, part, limits).lay_down();
  map.verdict = Verdict::distorted;
  if (too_domed(mesh, part, limits.scale_range)) return map;
  solved = true;
  return Attempt(mesh, part, limits).run(last);
}

}  // namespace lpq
