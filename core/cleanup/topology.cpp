#include "cleanup/topology.h"

#include <algorithm>
#include <vector>

#include "cleanup/cavities.h"
#include "cleanup/refill.h"

namespace lpq {
namespace {

// A corner beyond 155 degrees makes a face flat; its eta is below the other bound then.
constexpr double flat_cosine = -0.906, flat_eta = 0.28;
// Of flat faces nearly all can be mended, but for those in needles: many tries with fewer than one
// in `worth_trying` accepted mean an outline full of these. In small meshes fewer are many.
constexpr Index most_to_know = 100, least_to_know = 4, share_to_know = 20;
constexpr Index worth_trying = 4, tries_per_face = 2;
// Cavities looked at for one bad face, and altogether for each that there was at first, beside
// some. What has been mended in outlines of all kinds took 82 at most, in the mean 65 in the worst
// of them; around a vertex with hundreds of faces, beside an edge that is hundreds of sizes long,
// there are thousands.
constexpr Index most_cavities = 200, cavities_per_face = 60, some_cavities = 1000;

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

// Tries the cavities at v in order, `left` of them at most; the first success ends the round.
RefillResult refill_at(QuadTopology& mesh, Refiller& refiller, Index v, bool wide, Index& left) {
  for (const Cavity& cavity : cavities_at(mesh, v, wide)) {
    if (left-- <= 0) break;
    if (RefillResult result = refiller.refill(cavity); result.accepted) return result;
  }
  return {};
}

bool is_invalid(const QuadTopology& mesh, Index f) {
  return !is_strictly_convex(mesh.points(), mesh.face(f));
}

bool is_flat(const QuadTopology& mesh, Index f) {
  const Face& face = mesh.face(f);
  const int n = corner_count(face);
  for (int k = 0; k < n; ++k) {
    const Vec2 at = mesh.point(face[k]);
    const Vec2 ahead = mesh.point(face[(k + 1) % n]) - at;
    const Vec2 back = mesh.point(face[(k + n - 1) % n]) - at;
    if (dot(ahead, back) < flat_cosine * length(ahead) * length(back)) return true;
  }
  return false;
}

// What repair_all does about whom.
struct Repairs {
  bool (*is_bad)(const QuadTopology&, Index face);
  bool wide = false;         // cavities
  bool may_give_up = false;  // where it hardly ever succeeds
};

// Refills around the corners of f in turn until one succeeds, or no more tries are `left`.
RefillResult refill_around(QuadTopology& mesh, Refiller& refiller, Index f, bool wide,
                           Index& left) {
  const Face face = mesh.face(f);
  RefillResult refill;
  const Index here = std::min(most_cavities, left);
  Index left_here = here;
  for (int k = 0; k < corner_count(face) && !refill.accepted && left_here > 0; ++k)
    refill = refill_at(mesh, refiller, face[k], wide, left_here);
  left -= here - left_here;
  return refill;
}

// Refills around every bad face, and around those that a refill left bad.
void repair_all(QuadTopology& mesh, Refiller& refiller, const Repairs& repairs,
                TopologyStats& stats) {
  std::vector<Index> queue;
  const auto enqueue = [&](Index f) {
    if (mesh.is_alive(f) && repairs.is_bad(mesh, f)) queue.push_back(f);
  };
  for (Index f = 0; f < mesh.face_slots(); ++f) enqueue(f);
  // A refill that mends one face may spoil the next, round and round.
  const Index enough_tries =
      std::clamp(mesh.face_slots() / share_to_know, least_to_know, most_to_know);
  const Index most_tries = enough_tries + tries_per_face * static_cast<Index>(queue.size());
  Index tried = 0, mended = 0,
        left = some_cavities + cavities_per_face * static_cast<Index>(queue.size());
  for (std::size_t i = 0; i < queue.size() && left > 0; ++i) {
    const Index f = queue[i];
    if (!mesh.is_alive(f) || !repairs.is_bad(mesh, f)) continue;
    if (repairs.may_give_up && tried > enough_tries && mended * worth_trying < tried) break;
    if (repairs.may_give_up && tried > most_tries) break;
    ++tried;
    const RefillResult refill = refill_around(mesh, refiller, f, repairs.wide, left);
    if (!refill.accepted) continue;
    ++mended;
    count(refill, stats);
    for (const Index v : refill.vertices)
      for (const Index g : mesh.faces_of(v)) enqueue(g);
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
  repair_all(mesh, quick, {.is_bad = is_invalid, .wide = true}, stats);
  repair_all(mesh, thorough, {.is_bad = is_invalid}, stats);
  return stats;
}

TopologyStats mend_flat(QuadTopology& mesh, const IdealValence& ideal, const Fields& fields,
                        DiskPatterns& patterns) {
  TopologyStats stats;
  Refiller refiller(mesh, ideal, fields, patterns,
                    {.tries = 8, .repair = true, .flat_eta = flat_eta});
  repair_all(mesh, refiller, {.is_bad = is_flat, .wide = true, .may_give_up = true}, stats);
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
    Index left = most_cavities;
    const RefillResult refill = refill_at(mesh, refiller, v, false, left);
    if (!refill.accepted) continue;
    count(refill, stats);
    for (const Index w : refill.vertices) enqueue(w);
  }
  return stats;
}

}  // namespace lpq
