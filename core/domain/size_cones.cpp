#include "domain/size_cones.h"

#include <cmath>

#include "geometry/box.h"

namespace lpq {
namespace {

// Measured over isolated points in domains of a tenth to a twentieth of the size: with these the
// quads there are 0.8 to 1.5 times as wide as asked whatever the growth, with a disc of half the
// radius they are up to twice as wide, and steeper ones are missed by the integer points of the
// seeds.
constexpr double steepest = 0.5;
constexpr double near_lengths = 3.5, growth_there = 0.5;
constexpr double least_reach = 0.1;  // of h: a smaller disc is none

// Boxes of samples that are this many times farther away than they are wide count as one sample,
// as near and as large as any of theirs.
constexpr double far_boxes = 8;

double farthest(const Box& box, Vec2 p) {
  const Vec2 low = p - box.lo, high = box.hi - p;
  return length(Vec2{std::max(low.x, high.x), std::max(low.y, high.y)});
}

/// Samples, to be asked which of them are larger than one of them and not overruled by it.
class LargerSamples {
 public:
  LargerSamples(std::span<const SizeSample> samples, double growth, double largest)
      : samples_(samples), growth_(growth) {
    std::vector<Box> boxes;
    for (const SizeSample& s : samples) {
      boxes.push_back({s.position, s.position});
      h_.push_back(std::min(s.h, largest));
    }
    tree_ = BoxTree(boxes);
    least_ = tree_.summarise<double>(h_, [](double a, double b) { return std::min(a, b); });
    most_ = tree_.summarise<double>(h_, [](double a, double b) { return std::max(a, b); });
  }

  /// Calls visit(distance, rise) for those for which it may matter: if it does for the least
  /// distance and the largest rise of many, so says `may_matter`.
  template <class MayMatter, class Visit>
  void around(Index i, MayMatter may_matter, Visit visit) const {
    const Vec2 p = samples_[i].position;
    const double h = h_[i];
    tree_.walk(
        [&](Index node, const Box& box) {
          const double rise = most_[node] - h, far = farthest(box, p);
          if (!(rise > 0) || far <= h || least_[node] > h + growth_ * far) return false;
          const double near = std::sqrt(squared_distance(box, Box{p, p}));
          if (!may_matter(std::max(near, h), rise)) return false;
          if (!(longer_side(box) * far_boxes <= near)) return true;
          if (near > h && rise <= growth_ * far) visit(near, std::min(rise, growth_ * near));
          return false;
        },
        [](Index) {});
  }

 private:
  std::span<const SizeSample> samples_;
  double growth_;
  std::vector<double> h_;
  BoxTree tree_;
  std::vector<double> least_, most_;  // h, per node of the tree
};

/// As wide and as flat as the others let it be.
void widen(SizeCone& cone, Index i, const LargerSamples& samples, double growth) {
  cone.slope = std::min(growth, steepest);
  cone.reach = (near_lengths - growth_there / cone.slope) * cone.h;
  samples.around(
      i, [&](double d, double rise) { return cone.reach > 0 && d - rise / growth < cone.reach; },
      [&](double d, double rise) {
        cone.reach = std::clamp(d - rise / growth, 0.0, cone.reach);
        if (cone.reach < least_reach * cone.h) cone.reach = 0;
      });
  samples.around(
      i,
      [&](double d, double rise) {
        return cone.slope < growth && rise > cone.slope * (d - cone.reach);
      },
      [&](double d, double rise) {
        if (rise > cone.slope * (d - cone.reach))
          cone.slope = d > cone.reach ? std::min(growth, rise / (d - cone.reach)) : growth;
      });
}

}  // namespace

std::vector<SizeCone> size_cones(std::span<const SizeSample> samples, double growth,
                                 double largest) {
  std::vector<SizeCone> cones;
  for (const SizeSample& s : samples) cones.push_back({s.position, s.h, 0, growth});
  if (samples.empty() || near_lengths * growth <= growth_there) return cones;
  const LargerSamples larger(samples, growth, largest);
  for (Index i = 0; i < static_cast<Index>(cones.size()); ++i)
    if (cones[i].h < largest) widen(cones[i], i, larger, growth);
  return cones;
}

bool wider_than_growth(std::span<const SizeCone> cones, double growth) {
  return std::any_of(cones.begin(), cones.end(), [growth](const SizeCone& cone) {
    return cone.reach > 0 || cone.slope < growth;
  });
}

LeastCone::LeastCone(std::vector<SizeCone> cones) : cones_(std::move(cones)) {
  std::vector<Box> discs;
  std::vector<double> h, slope;
  for (const SizeCone& cone : cones_) {
    const Vec2 r{cone.reach, cone.reach};
    discs.push_back({cone.tip - r, cone.tip + r});
    h.push_back(cone.h);
    slope.push_back(cone.slope);
  }
  const auto least = [](double a, double b) { return std::min(a, b); };
  tree_ = BoxTree(discs);
  smallest_ = tree_.summarise<double>(h, least);
  flattest_ = tree_.summarise<double>(slope, least);
}

double LeastCone::at(Vec2 p, double bound) const {
  double best = bound;
  tree_.walk(
      [&](Index node, const Box& box) {
        if (smallest_[node] >= best) return false;
        const double room = (best - smallest_[node]) / flattest_[node];
        return squared_distance(box, Box{p, p}) < room * room;
      },
      [&](Index i) { best = std::min(best, cones_[i].at(distance(p, cones_[i].tip))); });
  return best;
}

}  // namespace lpq
