#include "patches/surroundings.h"

#include <algorithm>
#include <cmath>

#include "base/sort_unique.h"
#include "cleanup/descent.h"
#include "cleanup/untangle.h"
#include "mesh/quality.h"

namespace lpq {
namespace {

// A trial whose smallest corner has this share of its target area is good enough for the eta
// energy, which cannot start from tangled faces and is slow on flat ones.
constexpr double usable_corner = 0.15;
constexpr int untangling_rounds = 3;
// After the first look the energy of a trial that is accepted in the end drops by at most this
// share in 96 of 100 cases; giving up the others there saves three quarters of the work.
constexpr double hoped_drop = 0.3;
// Energy of a face that is not strictly convex: more than any valid face has.
constexpr double invalid_energy = 50;

bool contains(std::span<const Index> sorted, Index value) {
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

/// Side of the square of the face's area over the least size at its corners and centre.
double coarseness_of(const Fields& fields, const std::vector<Vec2>& points, const Face& face,
                     Index& hint) {
  double least = fields.size(centre_of(points, face), hint), area = 0;
  const Vec2 a = points[face[0]];
  const int n = corner_count(face);
  for (int k = 0; k < n; ++k) {
    const Vec2 b = points[face[k]], c = points[face[(k + 1) % n]];
    least = std::min(least, fields.size(b, hint));
    area += 0.5 * cross(b - a, c - a);
  }
  return std::sqrt(std::max(area, 0.0)) / least;
}

}  // namespace

void Aims::append(const Aims& others) {
  target.insert(target.end(), others.target.begin(), others.target.end());
  share.insert(share.end(), others.share.begin(), others.share.end());
  pull.insert(pull.end(), others.pull.begin(), others.pull.end());
  stretch.insert(stretch.end(), others.stretch.begin(), others.stretch.end());
}

void Aims::clear() {
  target.clear();
  share.clear();
  pull.clear();
  stretch.clear();
}

Surroundings::Surroundings(const QuadTopology& mesh, const Fields& fields, const PatchGrowth& patch,
                           const PatchOutline& outline, int rings)
    : mesh_(mesh), fields_(fields), outline_(outline), patch_(patch.faces()) {
  collect(patch, rings);
  numbers_.reserve(vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    numbers_.push_back({vertices_[i], static_cast<Index>(i)});
  std::sort(numbers_.begin(), numbers_.end());
  for (const Index f : outside_) {
    Face face = mesh_.face(f);
    aim(centre_of(mesh_.points(), face), ring_aims_);
    for (int k = 0; k < corner_count(mesh_.face(f)); ++k) face[k] = local(face[k]);
    ring_.push_back(face);
  }
}

void Surroundings::collect(const PatchGrowth& patch, int rings) {
  std::vector<Index> free, all = outline_.loop;
  for (const Index v : outline_.loop)
    if (!mesh_.is_fixed(v)) free.push_back(v);
  for (int ring = 0; ring < rings; ++ring) {
    for (const Index v : free)
      for (const Index f : mesh_.faces_of(v))
        if (!patch.contains(f)) outside_.push_back(f);
    sort_unique(outside_);
    for (const Index f : outside_)
      for (int k = 0; k < corner_count(mesh_.face(f)); ++k) all.push_back(mesh_.face(f)[k]);
    sort_unique(all);
    if (ring + 1 == rings) break;
    for (const Index v : all)
      if (!mesh_.is_fixed(v)) free.push_back(v);
  }
  sort_unique(all);
  sort_unique(free);
  for (const Index v : all)
    if (!contains(free, v)) vertices_.push_back(v);
  pinned_ = static_cast<Index>(vertices_.size());
  vertices_.insert(vertices_.end(), free.begin(), free.end());
}

Index Surroundings::local(Index v) const {
  return (*std::lower_bound(numbers_.begin(), numbers_.end(), std::array<Index, 2>{v, none}))[1];
}

void Surroundings::aim(Vec2 centre, Aims& aims) const {
  const double h = fields_.size(centre, hint_);
  aims.target.push_back(1 / (h * h));
  aims.share.push_back(share_at_slope(fields_.slope(centre, hint_)));
  if (!fields_.pull.empty()) aims.pull.push_back(fields_.pull_at(centre, hint_));
  if (!fields_.stretch.empty()) aims.stretch.push_back(fields_.stretch_at(centre, hint_));
}

double Surroundings::energy_now(const EtaEnergyOptions& options) const {
  std::vector<Vec2> points, gradient(4);
  std::vector<Index> faces = patch_;
  faces.insert(faces.end(), outside_.begin(), outside_.end());
  EtaEnergyOptions own = options;
  Aims aims;
  double sum = 0;
  for (const Index f : faces) {
    const Face& face = mesh_.face(f);
    const int n = corner_count(face);
    points.clear();
    for (int k = 0; k < n; ++k) points.push_back(mesh_.point(face[k]));
    const Face alone{0, 1, 2, n == 4 ? 3 : none};
    aims.clear();
    aim(centre_of(mesh_.points(), face), aims);
    own.size_share = aims.share;
    own.stretch = aims.stretch;
    const Evaluation one = eta_energy({&alone, 1}, points, aims.target, own, gradient, aims.pull);
    sum += one.status == EvalStatus::ok ? std::min(one.value, invalid_energy) : invalid_energy;
  }
  return sum;
}

double Surroundings::worst_eta_now() const {
  double worst = 1;
  for (const std::vector<Index>* faces : {&patch_, &outside_})
    for (const Index f : *faces) worst = std::min(worst, face_eta(mesh_.points(), mesh_.face(f)));
  return worst;
}

double Surroundings::coarseness_now() const {
  double most = 0;
  if (!fields_.has_spots) return most;
  for (const std::vector<Index>* faces : {&patch_, &outside_})
    for (const Index f : *faces)
      most = std::max(most, coarseness_of(fields_, mesh_.points(), mesh_.face(f), hint_));
  return most;
}

double Surroundings::coarseness(const QuadMesh& mesh) const {
  double most = 0;
  if (!fields_.has_spots) return most;
  for (const Face& face : mesh.faces)
    most = std::max(most, coarseness_of(fields_, mesh.points, face, hint_));
  return most;
}

Trial Surroundings::place(const Filling& filling) const {
  Trial trial;
  const Index length = static_cast<Index>(outline_.loop.size());
  trial.mesh.fixed = pinned_;
  for (const Index v : vertices_) trial.mesh.points.push_back(mesh_.point(v));
  trial.mesh.points.insert(trial.mesh.points.end(), filling.points.begin() + length,
                           filling.points.end());
  std::vector<Index> number;
  for (const Index v : outline_.loop) number.push_back(local(v));
  const Index first_new = static_cast<Index>(vertices_.size()) - length;
  for (Face face : filling.faces) {
    for (Index& v : face) v = v < length ? number[v] : first_new + v;
    trial.mesh.faces.push_back(face);
    aim(centre_of(trial.mesh.points, face), trial.aims);
  }
  trial.filled = static_cast<Index>(trial.mesh.faces.size());
  trial.mesh.faces.insert(trial.mesh.faces.end(), ring_.begin(), ring_.end());
  trial.aims.append(ring_aims_);
  return trial;
}

bool Surroundings::relax(Trial& trial, const RelaxOptions& options) const {
  QuadMesh& mesh = trial.mesh;
  const std::vector<double> sizes = vertex_sizes(mesh);
  for (int round = 0; round < untangling_rounds; ++round) {
    const double worst = smallest_corner(mesh.faces, mesh.points, trial.aims.target);
    if (worst > usable_corner) break;
    MeanRatioOptions ratio;
    ratio.stretch = trial.aims.stretch;
    if (worst < untangled_corner) ratio.epsilon = untangling_epsilon(worst);
    descend(mesh, sizes, options.untangling,
            [&](std::span<const Vec2> points, std::span<Vec2> gradient) {
              return mean_ratio_energy(mesh.faces, points, trial.aims.target, ratio, gradient);
            });
    if (worst >= untangled_corner) break;
  }
  EtaEnergyOptions shape = options.energy;
  shape.size_share = trial.aims.share;
  shape.stretch = trial.aims.stretch;
  const auto energy = [&](std::span<const Vec2> points, std::span<Vec2> gradient) {
    return eta_energy(mesh.faces, points, trial.aims.target, shape, gradient, trial.aims.pull);
  };
  if (smallest_corner(mesh.faces, mesh.points, trial.aims.target) <= 0) return false;
  std::vector<Vec2> gradient(mesh.points.size());
  descend(mesh, sizes, options.first_look, energy);
  if ((1 - hoped_drop) * energy(mesh.points, gradient).value > options.bound) return false;
  descend(mesh, sizes, options.smoothing - options.first_look, energy);
  const Evaluation now = energy(mesh.points, gradient);
  trial.energy = now.value;
  return now.status == EvalStatus::ok && invalid_faces(mesh).empty();
}

}  // namespace lpq
