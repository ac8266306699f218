#include "patches/refit.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "mesh/quality.h"
#include "numerics/elementary.h"
#include "patches/likeness.h"

namespace lpq {
namespace {

constexpr double least_gain = 1e-9;  // of irregularity: less is none

double worst_eta(const QuadMesh& mesh) {
  double worst = 1;
  for (const Face& face : mesh.faces) worst = std::min(worst, face_eta(mesh.points, face));
  return worst;
}

// A filling may have this many times fewer or more quads than the size field asks for, or else no
// farther from it than the old one: without this, regularity wins over a fine spot's size. More is
// the lesser evil (and costs energy anyway): small patches with a quad missing at a wall can often
// be mended with many more quads only.
constexpr double least_count = 0.75, most_count = 2;

bool is_count_kept(double wanted, double before, double after) {
  if (after < before) return after >= least_count * wanted;
  return after <= before || after <= most_count * wanted;
}

// Where sizes are small at points, the count of a large patch does not tell whether a filling keeps
// them: no face of it may be this many times as wide as the least size in it, unless one is
// already.
constexpr double most_coarseness = 2;

// Share of the credit where triangles give way: their vertices count as irregular, though there is
// no better number of faces beside a triangle. With all of it nearly every triangle goes, and mean
// eta with them; with none nearly all stay, and the lowest eta of the quads beside them.
constexpr double credit_of_triangles = 0.2;

// What a change may cost at most: nothing, or with a temperature what chance allows [Metropolis].
double most_change(const RefitRule& rule) {
  if (rule.temperature <= 0) return 0;
  return -rule.temperature * logarithm(1 - rule.rng->unit());
}

}  // namespace

Refitter::Refitter(QuadTopology& mesh, const IdealValence& ideal, const Fields& fields,
                   const PatchOptions& options)
    : mesh_(mesh),
      fields_(fields),
      options_(options),
      patch_(mesh, ideal, options.takes_triangles) {}

Polygon Refitter::polygon() const {
  Polygon polygon;
  polygon.corner = outline_.corner;
  for (const Index v : outline_.loop) {
    polygon.points.push_back(mesh_.point(v));
    polygon.size.push_back(fields_.size(mesh_.point(v), hint_));
  }
  return polygon;
}

/// Integral of dA / h^2 over the patch.
double Refitter::wanted_quads() const {
  double sum = 0;
  for (const Index f : patch_.faces()) {
    const Face& face = mesh_.face(f);
    Vec2 points[4];
    for (int k = 0; k < 4; ++k) points[k] = mesh_.point(face[k] == none ? face[0] : face[k]);
    const double h = fields_.size(
        midpoint(midpoint(points[0], points[2]), midpoint(points[1], points[3])), hint_);
    sum += 0.5 * std::fabs(cross(points[2] - points[0], points[3] - points[1])) / (h * h);
  }
  return sum;
}

/// Of which two triangles make one.
double Refitter::patch_quads() const {
  return static_cast<double>(patch_.faces().size()) - 0.5 * patch_.triangles();
}

/// What the outline, whose polygon is `shape`, can be filled with under the rule.
std::vector<Plan> Refitter::plans(const Polygon& shape, const RefitRule& rule) const {
  const int corners = static_cast<int>(outline_.corner.size());
  // A disk with n corners and flat sides needs irregular vertices worth |n - 4| at least.
  const double allowed = outline_.weight - outline_.rim_weight +
                         (rule.extra_weight > 0 ? rule.extra_weight : -least_gain);
  if (corners < least_corners || corners > most_corners || allowed < std::abs(corners - 4))
    return {};
  std::vector<Plan> plans =
      make_plans(shape, {.most_irregular = static_cast<int>(allowed), .count = options_.plans});
  if (rule.rng != nullptr && !plans.empty()) return {plans[rule.rng->below(plans.size())]};
  return plans;
}

Refit Refitter::refit(const RefitRule& rule) {
  if (!patch_.close(rule.largest)) return Refit::hopeless;
  if (!patch_.outline(outline_)) return Refit::rejected;
  const Polygon shape = polygon();
  const std::vector<Plan> plans = this->plans(shape, rule);
  if (plans.empty()) return Refit::rejected;
  const Surroundings around(mesh_, fields_, patch_, outline_, options_.rings);
  const Trial best = best_trial(around, shape, plans, most_change(rule));
  if (best.mesh.faces.empty()) return Refit::rejected;
  commit(around, best);
  return Refit::done;
}

/// That of the plans which changes the energy least, below `best_change`; without faces if none.
Trial Refitter::best_trial(const Surroundings& around, const Polygon& shape,
                           std::span<const Plan> plans, double best_change) {
  const double now = around.energy_now(options_.energy);
  const double credit = options_.credit * (patch_.triangles() > 0 ? credit_of_triangles : 1);
  const double least_eta = std::min(options_.worst_eta, around.worst_eta_now());
  const double coarsest = std::max(most_coarseness, around.coarseness_now());
  const double wanted = wanted_quads(), before = patch_quads();
  Trial best;
  for (const Plan& plan : plans) {
    ++tried_;
    const Filling filling = fill(shape, plan);
    if (!is_count_kept(wanted, before, static_cast<double>(filling.faces.size()))) continue;
    const double gain = outline_.weight - outline_.rim_weight - plan.irregular;
    // What is there already: annealing would draw and accept it in every second trial.
    if (gain == 0 && patch_.triangles() == 0 && filling.faces.size() == patch_.faces().size() &&
        is_like_patch(filling, outline_, mesh_))
      continue;
    Trial trial = around.place(filling);
    const double even = now + credit * gain;
    if (!around.relax(trial, {.energy = options_.energy, .bound = even + best_change})) continue;
    const double change = trial.energy - even;
    if (change >= best_change || worst_eta(trial.mesh) < least_eta) continue;
    if (around.coarseness(trial.mesh) > coarsest) continue;
    best_change = change;
    best = std::move(trial);
  }
  return best;
}

void Refitter::commit(const Surroundings& around, const Trial& trial) {
  const Index region = mesh_.region(patch_.faces()[0]);
  const std::vector<Index> old = patch_.faces();
  patch_.clear();
  for (const Index f : old) mesh_.remove_face(f);
  changed_ = around.vertices();
  for (std::size_t i = around.pinned(); i < trial.mesh.points.size(); ++i) {
    if (i < changed_.size())
      mesh_.move(changed_[i], trial.mesh.points[i]);
    else
      changed_.push_back(mesh_.add_vertex(trial.mesh.points[i]));
  }
  for (Index f = 0; f < trial.filled; ++f) {
    Face face = trial.mesh.faces[f];
    for (Index& v : face) v = changed_[v];
    mesh_.add_face(face, region);
  }
}

}  // namespace lpq
