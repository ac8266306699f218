#include "field/guides.h"

#include <algorithm>
#include <cmath>

#include "delaunay/locate.h"
#include "field/field.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

// Chords are no shorter than this share of the domain: a bound for their number, and far above the
// rounding of the points between which they run.
constexpr double least_chord = 0x1p-16;
// A chord shorter than this share of the size says nothing: the one before it is prolonged.
constexpr double shortest_end = 0.5;

// Cuts [from, to], shares of the way from `start` by `step`, to where low <= coordinate <= high.
void clip(double start, double step, double low, double high, double& from, double& to) {
  if (step == 0) {
    if (start < low || start > high) to = -1;
    return;
  }
  const double enter = ((step > 0 ? low : high) - start) / step;
  const double leave = ((step > 0 ? high : low) - start) / step;
  from = std::max(from, enter);
  to = std::min(to, leave);
}

Vec2 clamped(Vec2 p, const Box& box) {
  return {std::min(std::max(p.x, box.lo.x), box.hi.x), std::min(std::max(p.y, box.lo.y), box.hi.y)};
}

// The part of the segment in the box; false if there is none.
bool clip(Vec2& a, Vec2& b, const Box& box) {
  const Vec2 start = a, d = b - a;
  double from = 0, to = 1;
  clip(start.x, d.x, box.lo.x, box.hi.x, from, to);
  clip(start.y, d.y, box.lo.y, box.hi.y, from, to);
  if (!(from <= to)) return false;
  if (from > 0) a = clamped(start + from * d, box);
  if (to < 1) b = clamped(start + to * d, box);
  return true;
}

// Walks along a guide and leaves a chord behind whenever it is one size away from the last one.
class Cutter {
 public:
  Cutter(const TriMesh& mesh, std::span<const double> h, std::vector<Chord>& chords)
      : mesh_(mesh), h_(h), locator_(mesh), box_(box_of(mesh.points)), chords_(chords) {
    least_ = least_chord * longer_side(box_);
  }

  void cut(std::span<const Vec2> guide) {
    bool begun = false;
    for (std::size_t i = 1; i < guide.size(); ++i) {
      Vec2 a = guide[i - 1], b = guide[i];
      if (!clip(a, b, box_)) continue;
      if (begun && !(a == at_)) end();  // it was outside meanwhile
      if (!begun || !(a == at_)) begin(a);
      begun = true;
      advance(b);
    }
    if (begun) end();
  }

 private:
  void begin(Vec2 p) {
    at_ = p;
    start_at(p);
    first_ = chords_.size();
  }

  void advance(Vec2 b) {
    while (distance(start_, b) > size_) {
      const Vec2 d = b - at_, e = at_ - start_;
      const double dd = squared_length(d), de = dot(d, e), ee = squared_length(e) - size_ * size_;
      const double root = std::sqrt(std::max(de * de - dd * ee, 0.0));
      const double share = std::min(std::max((root - de) / dd, 0.0), 1.0);
      at_ = at_ + share * d;
      leave_chord();
    }
    at_ = b;
  }

  void end() {
    if (at_ == start_) return;
    const bool follows = chords_.size() > first_ && chords_.back().to == start_;
    if (follows && distance(start_, at_) < shortest_end * size_ && !(chords_.back().from == at_))
      chords_.back().to = at_;
    else
      leave_chord();
  }

  // From the start to here, unless both lie outside the domain.
  void leave_chord() {
    const Vec2 from = start_;
    const bool was_inside = inside_;
    start_at(at_);
    if (was_inside || inside_) chords_.push_back({from, at_});
  }

  void start_at(Vec2 p) {
    start_ = p;
    const Index t = locator_.find_nearest(p, hint_);
    inside_ = t != none && contains(mesh_, t, p);
    const auto [a, b, c] = mesh_.triangles[std::max(t, 0)];
    size_ = std::max(std::min({h_[a], h_[b], h_[c]}), least_);
  }

  const TriMesh& mesh_;
  std::span<const double> h_;
  Locator locator_;
  Box box_;
  std::vector<Chord>& chords_;
  double least_ = 0;
  Index hint_ = none;
  Vec2 start_, at_;        // of the chord to come; how far along the guide it is
  double size_ = 0;        // at start_
  bool inside_ = false;    // start_ lies in the domain
  std::size_t first_ = 0;  // chord of this piece of the guide
};

}  // namespace

std::vector<Chord> chords_of(std::span<const DomainInput::Guide> guides, const TriMesh& mesh,
                             std::span<const double> h) {
  std::vector<Chord> chords;
  if (guides.empty()) return chords;
  Cutter cutter(mesh, h, chords);
  for (const DomainInput::Guide& guide : guides) cutter.cut(guide);
  return chords;
}

std::vector<Index> guides_outside(std::span<const DomainInput::Guide> guides, const TriMesh& mesh,
                                  std::span<const double> h) {
  std::vector<Index> outside;
  if (guides.empty()) return outside;
  std::vector<Chord> chords;
  Cutter cutter(mesh, h, chords);
  for (std::size_t i = 0; i < guides.size(); ++i) {
    const std::size_t before = chords.size();
    cutter.cut(guides[i]);
    if (chords.size() == before) outside.push_back(static_cast<Index>(i));
  }
  return outside;
}

std::vector<Source> sources_along(std::span<const Chord> chords) {
  std::vector<Source> sources;
  for (const Chord& chord : chords) {
    const double side = distance(chord.from, chord.to);
    for (const Vec2 p : {chord.from, midpoint(chord.from, chord.to), chord.to})
      sources.push_back({p, side});
  }
  return sources;
}

ChordTree::ChordTree(std::span<const Chord> chords) : chords_(chords) {
  std::vector<Box> boxes;
  for (const Chord& chord : chords) boxes.push_back(box_of(chord.from, chord.to));
  tree_ = BoxTree(boxes);
}

ChordTree::Sum ChordTree::meeting(Vec2 a, Vec2 b) const {
  Sum sum;
  const Box around = box_of(a, b);
  tree_.walk([&](Index, const Box& box) { return overlap(box, around); },
             [&](Index i) {
               const Chord& chord = chords_[i];
               if (meet(a, b, chord.from, chord.to) == Meeting::apart) return;
               sum.z += cross_of(chord.to - chord.from);
               ++sum.count;
             });
  return sum;
}

}  // namespace lpq
