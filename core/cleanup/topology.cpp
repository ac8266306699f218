#include "cleanup/topology.h"

#include <algorithm>
#include <vector>

#include "cleanup/cavities.h"
#include "cleanup/refill.h"

namespace lpq {
namespace {

bool remove_doublet(QuadTopology& mesh, Index v) {
  if (mesh.is_fixed(v) || mesh.valence(v) != 2) return false;
  const Index f = mesh.faces_of(v)[0], g = mesh.faces_of(v)[1];
  const Face one = mesh.face(f), two = mesh.face(g);
  if (one[3] == none || two[3] == none || mesh.region(f) != mesh.region(g)) return false;
  const Index k = corner_of(one, v), p = one[(k + 2) & 3];
  const Index q = two[(corner_of(two, v) + 2) & 3];
  if (p == q) return false;
  const Index region = mesh.region(f);
  mesh.remove_face(f);
  mesh.remove_face(g);
  mesh.add_face({one[(k + 1) & 3], p, one[(k + 3) & 3], q}, region);
  return true;
}

void count(const RefillResult& refill, TopologyStats& stats) {
  if (refill.faces_after < refill.faces_before)
    ++stats.diamonds;
  else if (refill.faces_after == refill.faces_before)
    ++stats.rotations;
  else
    ++stats.splits;
  stats.boundary_repairs += refill.boundary;
}

// Tries the cavities at v in order; the first success ends the round.
RefillResult refill_at(QuadTopology& mesh, Refiller& refiller, Index v, bool wide) {
  for (const Cavity& cavity : cavities_at(mesh, v, wide))
    if (RefillResult result = refiller.refill(cavity); result.accepted) return result;
  return {};
}

// Refills around every invalid face, and around those that a refill left invalid.
void repair_all(QuadTopology& mesh, Refiller& refiller, bool wide, TopologyStats& stats) {
  std::vector<Index> queue;
  const auto enqueue = [&](Index f) {
    if (mesh.is_alive(f) && !is_strictly_convex(mesh.points(), mesh.face(f))) queue.push_back(f);
  };
  for (Index f = 0; f < mesh.face_slots(); ++f) enqueue(f);
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index f = queue[i];
    if (!mesh.is_alive(f) || is_strictly_convex(mesh.points(), mesh.face(f))) continue;
    const Face face = mesh.face(f);
    for (int k = 0; k < corner_count(face); ++k) {
      const RefillResult refill = refill_at(mesh, refiller, face[k], wide);
      if (!refill.accepted) continue;
      count(refill, stats);
      for (const Index v : refill.vertices)
        for (const Index g : mesh.faces_of(v)) enqueue(g);
      break;
    }
  }
}

}  // namespace

Index remove_doublets(QuadTopology& mesh) {
  Index removed = 0;
  // The corners a and b lose a face each and may become doublets in turn.
  std::vector<Index> queue;
  for (Index v = 0; v < mesh.vertex_count(); ++v) queue.push_back(v);
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index v = queue[i];
    if (mesh.is_fixed(v) || mesh.valence(v) != 2) continue;
    const Face face = mesh.face(mesh.faces_of(v)[0]);
    if (!remove_doublet(mesh, v)) continue;
    ++removed;
    for (const Index w : face)
      if (w != none && w != v) queue.push_back(w);
  }
  return removed;
}

TopologyStats repair_invalid(QuadTopology& mesh, const IdealValence& ideal, const Fields& fields,
                             DiskPatterns& patterns) {
  TopologyStats stats;
  // Most repairs need only a good look at many patterns; what is left gets more work on fewer,
  // smaller cavities.
  Refiller quick(mesh, ideal, fields, patterns,
                 {.tries = 8, .repair = true, .untangling = Untangling::patient});
  Refiller thorough(mesh, ideal, fields, patterns,
                    {.tries = 3, .repair = true, .untangling = Untangling::thorough});
  repair_all(mesh, quick, true, stats);
  repair_all(mesh, thorough, false, stats);
  return stats;
}

TopologyStats regularise(QuadTopology& mesh, const IdealValence& ideal, const Fields& fields,
                         DiskPatterns& patterns) {
  TopologyStats stats;
  Refiller refiller(mesh, ideal, fields, patterns, {});
  std::vector<Index> queue;
  std::vector<char> queued;
  const auto enqueue = [&](Index v) {
    queued.resize(mesh.vertex_count(), 0);
    if (queued[v] || mesh.valence(v) == 0 || ideal.is_regular(mesh, v)) return;
    queued[v] = 1;
    queue.push_back(v);
  };
  for (Index v = 0; v < mesh.vertex_count(); ++v) enqueue(v);
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index v = queue[i];
    queued[v] = 0;
    if (mesh.valence(v) == 0 || ideal.is_regular(mesh, v)) continue;
    const RefillResult refill = refill_at(mesh, refiller, v, false);
    if (!refill.accepted) continue;
    count(refill, stats);
    for (const Index w : refill.vertices) enqueue(w);
  }
  return stats;
}

}  // namespace lpq
