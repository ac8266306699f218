#include "cleanup/ideal_valence.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/ideal_quads.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

constexpr double weight_of_other = 0.5;

// Faces of v from f on, counter-clockwise until a border edge or the start again.
Index count_sector(const QuadTopology& mesh, Index v, Index f) {
  Index quads = 0;
  for (Index g = f; g != none;) {
    ++quads;
    const Index last = prev_corner(mesh.face(g), corner_of(mesh.face(g), v));
    if (mesh.is_wall(v, last)) break;
    g = mesh.face_with_edge(v, last);
    if (g == f || quads > mesh.valence(v)) break;
  }
  return quads;
}

// The last neighbour of the sector that begins with face f.
Index sector_end(const QuadTopology& mesh, Index v, Index f) {
  Index last = none;
  for (Index g = f, guard = mesh.valence(v); g != none && guard > 0; --guard) {
    last = prev_corner(mesh.face(g), corner_of(mesh.face(g), v));
    if (mesh.is_wall(v, last)) break;
    g = mesh.face_with_edge(v, last);
  }
  return last;
}

// The first neighbour of the sector that holds face f; none for a full circle.
Index sector_begin(const QuadTopology& mesh, Index v, Index f) {
  for (Index g = f, guard = mesh.valence(v); guard >= 0; --guard) {
    const Index first = next_corner(mesh.face(g), corner_of(mesh.face(g), v));
    if (mesh.is_wall(v, first)) return first;
    const Index before = mesh.face_with_edge(first, v);
    if (before == none) return first;
    if (before == f) return none;
    g = before;
  }
  return none;
}

}  // namespace

double sector_angle(Vec2 v, Vec2 from, Vec2 to) {
  const double angle = arc_tangent(cross(from - v, to - v), dot(from - v, to - v));
  return from == to || angle <= 0 ? angle + 2 * pi : angle;
}

double irregularity(Index valence, Index ideal, bool fixed) {
  const Index off = valence - ideal;
  if (off == 0) return 0;
  if (fixed) return off < 0 ? -3.0 * off : 1.5 * off;
  const Index far = off < 0 ? -off : off;
  return (far == 1 ? 1.0 : 1.5 * far - 0.5) + (valence < 3 ? 1.0 : 0.0);
}

double IdealValence::Count::weight(Index count) const {
  const double plain = irregularity(count, ideal, border);
  if (!either) return plain;
  return std::min(plain, irregularity(count, 5 - ideal, border) + weight_of_other);
}

IdealValence::IdealValence(const QuadTopology& mesh) {
  std::vector<double> angles;  // where there is one sector
  for (Index v = 0; v < mesh.vertex_count() && mesh.is_fixed(v); ++v) {
    bool bordered = false;
    angles.push_back(0);
    for (const Index f : mesh.faces_of(v)) {
      const Index first = next_corner(mesh.face(f), corner_of(mesh.face(f), v));
      if (!mesh.is_wall(v, first) && mesh.face_with_edge(first, v) != none) continue;
      const Index last = sector_end(mesh, v, f);
      const double angle =
          first == last ? 2 * pi : sector_angle(mesh.point(v), mesh.point(first), mesh.point(last));
      sectors_.values.push_back({first, ideal_quads(angle)});
      angles.back() = bordered ? 0 : angle;
      bordered = true;
    }
    if (!bordered) sectors_.values.push_back({});
    sectors_.end_row();
  }
  find_hollow_bends(mesh, angles);
}

void IdealValence::find_hollow_bends(const QuadTopology& mesh, std::span<const double> angle) {
  const auto at = [&](Index v) { return v < sectors_.rows() ? angle[v] : 0; };
  for (Index v = 0; v < sectors_.rows(); ++v) {
    if (angle[v] == 0) continue;
    Sector& sector = sectors_.values[sectors_.offsets[v]];
    const Index before = sector_end(mesh, v, mesh.face_with_edge(v, sector.first));
    sector.either = is_in_hollow_bend(at(before), angle[v], at(sector.first));
  }
}

double IdealValence::weight(const QuadTopology& mesh, Index v) const {
  const Index valence = mesh.valence(v);
  if (!mesh.is_fixed(v)) return valence == 0 ? 0 : irregularity(valence, 4, false);
  if (mesh.outside(v) != none) return irregularity(valence + mesh.outside(v), 4, false);
  const auto sectors = sectors_.row(v);
  if (sectors.size() == 1)
    return Count{valence, sectors[0].ideal, sectors[0].first != none, sectors[0].either}.weight(
        valence);
  double sum = 0;
  for (const Sector& sector : sectors) {
    const Index f = mesh.face_with_edge(v, sector.first);
    sum += irregularity(f == none ? 0 : count_sector(mesh, v, f), sector.ideal, true);
  }
  return sum;
}

double IdealValence::total_weight(const QuadTopology& mesh) const {
  double sum = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) sum += weight(mesh, v);
  return sum;
}

Index IdealValence::wanted(Index v) const {
  if (v >= sectors_.rows()) return 4;
  Index sum = 0;
  for (const Sector& sector : sectors_.row(v)) sum += sector.ideal;
  return sum;
}

IdealValence::Count IdealValence::sector_count(const QuadTopology& mesh, Index v, Index f) const {
  if (!mesh.is_fixed(v)) return {mesh.valence(v), 4};
  if (mesh.outside(v) != none) return {mesh.valence(v) + mesh.outside(v), 4};
  const auto sectors = sectors_.row(v);
  if (sectors.size() == 1) return {mesh.valence(v), sectors[0].ideal, true, sectors[0].either};
  const Index first = sector_begin(mesh, v, f);
  for (const Sector& sector : sectors)
    if (sector.first == first)
      return {count_sector(mesh, v, mesh.face_with_edge(v, first)), sector.ideal, true};
  LPQ_ASSERT(false);
  return {};
}

}  // namespace lpq
