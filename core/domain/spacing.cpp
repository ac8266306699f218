#include "domain/spacing.h"

#include <algorithm>
#include <cmath>

#include "domain/gaps.h"

namespace lpq {
namespace {

// A corner narrower than 60 degrees gets finer edges at its tip, so that its two sides, which have
// no other reason to, carry nodes that face each other; but not finer than an eighth of the size,
// since no finite spacing makes the tip of a needle well shaped.
constexpr double finest_tip = 0.125;

// Edges and gaps below this (unit frame) are followed no further: nodes placed closer would have
// few digits left of their distance in double precision.
constexpr double finest = 0x1p-30;

// A gap of width g and length L takes about L/g samples, which has no bound in the size of the
// input; beyond these many, long gaps get longer edges than their width instead.
constexpr Index few_samples = 20000;
constexpr Index samples_per_segment = 50;

double tip_factor(double angle_sine, double angle_cosine) {
  if (angle_cosine < 0.5) return 1.0;
  return std::clamp(2 * std::abs(angle_sine), finest_tip, 1.0);
}

std::vector<double> shortest_edges(const Domain& domain, std::span<const Segment> segments,
                                   double size) {
  std::vector<double> shortest(domain.points.size(), size);
  for (const Segment& s : segments) {
    const double l = std::max(finest, distance(domain.points[s.a], domain.points[s.b]));
    for (const Index v : {s.a, s.b}) shortest[v] = std::min(shortest[v], l);
  }
  return shortest;
}

void add_tips(const Gaps& gaps, const Domain& domain, double size,
              std::vector<BoundarySpacing::Sample>& samples) {
  for (const Gaps::Corner& corner : gaps.sharp_corners()) {
    const double factor = tip_factor(corner.sine, corner.cosine);
    if (factor < 1) samples.push_back({domain.points[corner.point], factor * size});
  }
}

/// Samples below which another one already goes change nothing; without them, asking is faster.
std::vector<BoundarySpacing::Sample> undominated(
    const std::vector<BoundarySpacing::Sample>& samples, const BoundarySpacing& spacing) {
  std::vector<BoundarySpacing::Sample> kept;
  for (const BoundarySpacing::Sample& sample : samples)
    if (spacing.at(sample.at, sample.spacing) >= sample.spacing) kept.push_back(sample);
  return kept;
}

/// Of sizes below the spacing; they are added to the samples instead where those say as much.
LeastCone add_sizes(std::span<const SizeSample> sizes, const SpacingOptions& options,
                    std::vector<BoundarySpacing::Sample>& samples) {
  std::vector<SizeCone> cones = size_cones(sizes, options.growth, options.size);
  std::erase_if(cones, [&](const SizeCone& cone) { return !(cone.h < options.size); });
  for (SizeCone& cone : cones) cone.h = std::max(finest, cone.h);
  if (wider_than_growth(cones, options.growth)) return LeastCone(std::move(cones));
  for (const SizeCone& cone : cones) samples.push_back({cone.tip, cone.h});
  return {};
}

}  // namespace

BoundarySpacing::BoundarySpacing(std::vector<Sample> samples, LeastCone cones,
                                 std::vector<double> bound, const SpacingOptions& options)
    : options_(options),
      samples_(std::move(samples)),
      cones_(std::move(cones)),
      bound_(std::move(bound)) {
  std::vector<Box> boxes;
  std::vector<double> values;
  boxes.reserve(samples_.size());
  values.reserve(samples_.size());
  for (const Sample& sample : samples_) {
    boxes.push_back({sample.at, sample.at});
    values.push_back(sample.spacing);
  }
  tree_ = BoxTree(boxes);
  smallest_ = tree_.summarise<double>(values, [](double a, double b) { return std::min(a, b); });
}

BoundarySpacing::BoundarySpacing(const Domain& domain, std::span<const Segment> segments,
                                 const SpacingOptions& options, std::span<const SizeSample> sizes) {
  const std::vector<double> shortest = shortest_edges(domain, segments, options.size);
  std::vector<Sample> samples;
  for (std::size_t v = 0; v < shortest.size(); ++v)
    if (shortest[v] < options.size) samples.push_back({domain.points[v], shortest[v]});
  const LeastCone cones = add_sizes(sizes, options, samples);
  const Gaps gaps(domain, segments);
  add_tips(gaps, domain, options.size, samples);
  // Gaps matter only where the given edges do not ask for a finer spacing already.
  const BoundarySpacing without_gaps(samples, cones, shortest, options);
  const Index most = few_samples + samples_per_segment * static_cast<Index>(segments.size());
  double floor = finest;
  const std::size_t before = samples.size();
  while (!gaps.sample_walls(without_gaps, options, floor, most, samples)) {
    samples.resize(before);
    floor = std::max(2 * floor, gaps.wall_length() / most);
  }
  const BoundarySpacing all(samples, cones, shortest, options);
  *this = BoundarySpacing(undominated(samples, all), cones, shortest, options);
  gap_floor_ = floor > finest ? floor : 0.0;
}

double BoundarySpacing::at(Vec2 p, double bound) const {
  double best = cones_.at(p, std::min(bound, options_.size));
  tree_.walk(
      [&](Index node, const Box& box) {
        if (smallest_[node] >= best) return false;
        const double room = (best - smallest_[node]) / options_.growth;
        return squared_distance(box, Box{p, p}) < room * room;
      },
      [&](Index i) {
        best = std::min(best, samples_[i].spacing + options_.growth * distance(p, samples_[i].at));
      });
  return best;
}

}  // namespace lpq
