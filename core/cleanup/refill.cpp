#include "cleanup/refill.h"

#include <algorithm>

#include "cleanup/descent.h"
#include "mesh/quality.h"

namespace lpq {
namespace {

constexpr double least_gain = 1e-9;  // of irregularity: less is none
// Faces around a cavity: where hundreds meet in one vertex, a try takes long and mends nothing.
constexpr std::size_t largest_ring = 120;
constexpr int first_guess_sweeps = 8;
constexpr int relax_steps = 14;
// A repair may leave this much more irregularity than it found: one quad cut into five leaves 12
// when all its corners are on the boundary.
constexpr double repair_allowance = 12;

struct Shape {
  double flat_eta = 0;
  Index invalid = 0, flat = 0;
  double loss = 0, worst = 1;

  void add(const std::vector<Vec2>& points, const Face& face) {
    if (!is_strictly_convex(points, face)) {
      ++invalid;
      loss += 1;
      worst = 0;
    } else {
      const double eta = face_eta(points, face);
      flat += eta < flat_eta;
      loss += 1 - eta;
      worst = std::min(worst, eta);
    }
  }
};

bool contains(std::span<const Index> list, Index value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

// The hole filled in a mesh of its own: fixed vertices of hole and ring first, then the free ones.
struct Refiller::Trial {
  QuadMesh patch;
  std::vector<Index> vertex;  // number in the whole mesh, none for a new one
  std::vector<Index> loop;    // loop_ and the pattern's interior in patch numbers
  std::size_t filled = 0;     // the first faces of the patch are the pattern's
  Shape shape;

  /// The patch's number of a vertex of the whole mesh.
  Index local(Index v) const {
    return static_cast<Index>(std::find(vertex.begin(), vertex.end(), v) - vertex.begin());
  }
};

Refiller::Refiller(QuadTopology& mesh, const IdealValence& ideal, const Fields& fields,
                   DiskPatterns& patterns, const RefillOptions& options)
    : mesh_(mesh), ideal_(ideal), fields_(fields), patterns_(patterns), options_(options) {}

// The loop around the faces, or false when they are not a disk without fixed vertices inside.
bool Refiller::outline(std::span<const Index> faces) {
  std::vector<std::array<Index, 2>> edges;
  for (const Index f : faces) {
    const Face& face = mesh_.face(f);
    if (face[3] == none) return false;
    for (int k = 0; k < 4; ++k) {
      const Index a = face[k], b = face[(k + 1) & 3];
      const Index other = mesh_.face_with_edge(b, a);
      if (other == none || !contains(faces, other))
        edges.push_back({a, b});
      else if (mesh_.is_wall(a, b))
        return false;
    }
  }
  if (static_cast<Index>(edges.size()) > largest_loop) return false;
  loop_.clear();
  for (Index at = edges[0][0]; loop_.size() <= edges.size();) {
    if (contains(loop_, at)) break;
    loop_.push_back(at);
    const auto next = std::find_if(edges.begin(), edges.end(),
                                   [&](const std::array<Index, 2>& e) { return e[0] == at; });
    if (next == edges.end()) return false;
    at = (*next)[1];
  }
  if (loop_.size() != edges.size()) return false;
  for (const Index f : faces)
    for (const Index v : mesh_.face(f))
      if (mesh_.is_fixed(v) && !contains(loop_, v)) return false;
  return true;
}

// Irregularity now, and of every loop vertex for each number of quads that a pattern may give it.
void Refiller::weigh_loop(std::span<const Index> faces) {
  old_weight_ = 0;
  weight_.assign(loop_.size(), {});
  for (std::size_t i = 0; i < loop_.size(); ++i) {
    const Index v = loop_[i];
    Index inside = 0, some = none;
    for (const Index f : faces)
      if (contains(mesh_.face(f), v)) {
        ++inside;
        some = f;
      }
    const IdealValence::Count now = ideal_.sector_count(mesh_, v, some);
    old_weight_ += now.weight(now.quads);
    for (Index c = 0; c < largest_loop; ++c) weight_[i][c] = now.weight(now.quads - inside + c);
  }
  std::vector<Index> seen;
  for (const Index f : faces)
    for (const Index v : mesh_.face(f))
      if (!contains(loop_, v) && !contains(seen, v)) {
        seen.push_back(v);
        old_weight_ += irregularity(mesh_.valence(v), 4, false);
      }
}

// The patterns of least irregularity, best first.
void Refiller::choose_plans(std::vector<Plan>& plans) {
  const Index length = static_cast<Index>(loop_.size());
  const bool repair = options_.repair && old_invalid_ + old_flat_ > 0;
  double bound = repair ? old_weight_ + repair_allowance : old_weight_ - least_gain;
  const std::size_t tries = options_.tries;
  for (const DiskPattern& pattern : patterns_.of_loop(length)) {
    if (pattern.irregularity > bound) break;  // in ascending order
    double weight = pattern.irregularity;
    for (Index i = 0; i < length && weight <= bound; ++i) weight += weight_[i][pattern.quads_at[i]];
    if (weight > bound) continue;
    const auto at = std::upper_bound(plans.begin(), plans.end(), weight,
                                     [](double w, const Plan& plan) { return w < plan.weight; });
    plans.insert(at, {&pattern, weight});
    if (plans.size() <= tries) continue;
    plans.pop_back();
    bound = std::min(bound, plans.back().weight);
  }
}

// Faces outside the cavity with a free loop vertex, and the shape of cavity and ring as they are.
void Refiller::collect_ring(std::span<const Index> faces) {
  ring_.clear();
  for (const Index v : loop_) {
    if (mesh_.is_fixed(v)) continue;
    for (const Index f : mesh_.faces_of(v))
      if (!contains(faces, f) && !contains(ring_, f)) ring_.push_back(f);
  }
  Shape shape{.flat_eta = options_.flat_eta};
  for (const Index f : faces) shape.add(mesh_.points(), mesh_.face(f));
  for (const Index f : ring_) shape.add(mesh_.points(), mesh_.face(f));
  old_invalid_ = shape.invalid;
  old_flat_ = shape.flat;
  old_loss_ = shape.loss;
  old_worst_ = shape.worst;
}

// Those of the loop, and those of the ring, which stay where they are.
void Refiller::take_vertices(Trial& trial) const {
  std::vector<Index> pinned, free;
  for (const Index v : loop_) (mesh_.is_fixed(v) ? pinned : free).push_back(v);
  for (const Index f : ring_)
    for (int k = 0; k < corner_count(mesh_.face(f)); ++k) {
      const Index v = mesh_.face(f)[k];
      if (!contains(loop_, v) && !contains(pinned, v)) pinned.push_back(v);
    }
  trial.vertex = pinned;
  trial.vertex.insert(trial.vertex.end(), free.begin(), free.end());
  trial.patch.fixed = static_cast<Index>(pinned.size());
  for (const Index v : trial.vertex) trial.patch.points.push_back(mesh_.point(v));
  for (const Index v : loop_) trial.loop.push_back(trial.local(v));
}

// The pattern's quads, its new vertices all in the middle of the loop.
void Refiller::fill_hole(const DiskPattern& pattern, Trial& trial) const {
  const Index length = static_cast<Index>(loop_.size());
  Vec2 centre;
  for (const Index v : loop_) centre += (1.0 / length) * mesh_.point(v);
  for (Index i = 0; i < pattern.interior; ++i) {
    trial.loop.push_back(static_cast<Index>(trial.vertex.size()));
    trial.vertex.push_back(none);
    trial.patch.points.push_back(centre);
  }
  for (const auto& quad : pattern.quads)
    trial.patch.faces.push_back(
        {trial.loop[quad[0]], trial.loop[quad[1]], trial.loop[quad[2]], trial.loop[quad[3]]});
  trial.filled = trial.patch.faces.size();
}

Refiller::Trial Refiller::build(const Plan& plan) const {
  Trial trial;
  trial.shape.flat_eta = options_.flat_eta;
  take_vertices(trial);
  fill_hole(*plan.pattern, trial);
  for (const Index f : ring_) {
    Face face = mesh_.face(f);
    for (int k = 0; k < corner_count(mesh_.face(f)); ++k) face[k] = trial.local(face[k]);
    trial.patch.faces.push_back(face);
  }
  return trial;
}

double Refiller::size_at(Vec2 p) const {
  if (asked_.empty() || asked_.back() != p) asked_.push_back(p);
  return fields_.size(p, hint_);
}

// New vertices to the mean of their neighbours, then the whole neighbourhood by its shapes.
void Refiller::relax(Trial& trial) const {
  QuadMesh& patch = trial.patch;
  const std::size_t first_new = loop_.size();
  for (int sweep = 0; sweep < first_guess_sweeps; ++sweep)
    for (std::size_t i = first_new; i < trial.loop.size(); ++i) {
      const Index v = trial.loop[i];
      Vec2 sum;
      int count = 0;
      for (std::size_t f = 0; f < trial.filled; ++f) {
        const Index k = corner_of(patch.faces[f], v);
        if (k == none) continue;
        sum += patch.points[next_corner(patch.faces[f], k)];
        ++count;
      }
      patch.points[v] = (1.0 / count) * sum;
    }
  if (!invalid_faces(patch).empty()) untangle_patch(patch, options_.untangling);
  if (!invalid_faces(patch).empty()) return;
  const double h = size_at(patch.points[trial.loop[0]]);
  const std::vector<double> unit(patch.faces.size(), 1 / (h * h));
  const std::vector<double> sizes = vertex_sizes(patch);
  const std::vector<Vec2> before = patch.points;
  descend(patch, sizes, relax_steps, [&](std::span<const Vec2> points, std::span<Vec2> gradient) {
    return eta_energy(patch.faces, points, unit, {.rounding = coarse_rounding}, gradient);
  });
  if (!invalid_faces(patch).empty()) patch.points = before;
}

bool Refiller::better(const Trial& trial, const Plan& plan) const {
  const Shape& shape = trial.shape;
  if (shape.invalid != old_invalid_) return shape.invalid < old_invalid_;
  if (shape.flat != old_flat_) return shape.flat < old_flat_;
  const double gain = old_weight_ - plan.weight;
  if (gain < least_gain) return false;
  if (shape.worst < std::min(old_worst_, options_.worst_eta)) return false;
  return shape.loss - old_loss_ < options_.credit * gain;
}

RefillResult Refiller::commit(std::span<const Index> faces, const Plan& plan, const Trial& trial) {
  RefillResult result;
  result.accepted = true;
  result.faces_before = static_cast<Index>(faces.size());
  result.faces_after = static_cast<Index>(trial.filled);
  std::vector<Index> global = trial.vertex;
  for (std::size_t i = 0; i < loop_.size(); ++i) {
    const auto inside = std::count_if(faces.begin(), faces.end(),
                                      [&](Index f) { return contains(mesh_.face(f), loop_[i]); });
    if (mesh_.is_fixed(loop_[i]) && inside != plan.pattern->quads_at[i]) result.boundary = true;
  }
  const Index region = mesh_.region(faces[0]);
  for (const Index f : faces) mesh_.remove_face(f);
  for (std::size_t i = trial.patch.fixed; i < global.size(); ++i) {
    const Vec2 position = trial.patch.points[i];
    if (global[i] == none)
      global[i] = mesh_.add_vertex(position);
    else
      mesh_.move(global[i], position);
  }
  for (std::size_t f = 0; f < trial.filled; ++f) {
    Face face = trial.patch.faces[f];
    for (Index& v : face) v = global[v];
    mesh_.add_face(face, region);
  }
  result.vertices = std::move(global);
  return result;
}

RefillResult Refiller::refill(std::span<const Index> faces) {
  asked_.clear();
  if (const std::vector<Vec2>* asked = refusals_.find(mesh_, faces)) {
    // On the edges of the background a search may end in one cell or the other, by where it began.
    for (const Vec2 p : *asked) fields_.size(p, hint_);
    return {};
  }
  RefillResult result = try_plans(faces);
  if (result.accepted)
    refusals_.forget_around(mesh_, result.vertices);
  else
    refusals_.note(faces, asked_);
  return result;
}

RefillResult Refiller::try_plans(std::span<const Index> faces) {
  if (!outline(faces)) return {};
  weigh_loop(faces);
  if (old_weight_ < least_gain && !options_.repair) return {};
  collect_ring(faces);
  if (ring_.size() > largest_ring) return {};
  std::vector<Plan> plans;
  choose_plans(plans);
  Trial best;
  Plan best_plan;
  double best_score = 0;
  for (const Plan& plan : plans) {
    Trial trial = build(plan);
    relax(trial);
    for (const Face& face : trial.patch.faces) trial.shape.add(trial.patch.points, face);
    if (!better(trial, plan)) continue;
    const double score = options_.credit * plan.weight + trial.shape.loss +
                         4.0 * (trial.shape.invalid + trial.shape.flat);
    if (best_plan.pattern != nullptr && score >= best_score) continue;
    best_score = score;
    best_plan = plan;
    best = std::move(trial);
  }
  if (best_plan.pattern == nullptr) return {};
  return commit(faces, best_plan, best);
}

}  // namespace lpq
