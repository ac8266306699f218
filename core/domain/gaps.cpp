// In a wedge the gap shrinks to nothing with the distance t to the tip. Edges proportional to the
// gap would then be needlessly many (1/angle for every factor e of t), so walls that run into a
// common sharp corner may have edges proportional to t instead.
#include "domain/gaps.h"

#include <algorithm>

#include "geometry/predicates.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

constexpr double edges_per_gap = 1 / 1.5;  // edges along a gap up to 1.5 times its width
constexpr double edge_per_distance = 0.5;  // edges in a wedge up to half their distance to the tip
constexpr double straight_run = 1.05;      // arc over chord: still the same wall of the wedge
constexpr double sharp_cosine = 0.5;       // 60 degrees

}  // namespace

Gaps::Gaps(const Domain& domain, std::span<const Segment> segments)
    : domain_(domain), segments_(segments) {
  std::vector<Box> boxes;
  boxes.reserve(segments.size());
  for (const Segment& s : segments) boxes.push_back(box_of(domain.points[s.a], domain.points[s.b]));
  tree_ = BoxTree(boxes);
  find_corners();
}

// Only plain corners count: one segment in, one out, with the same region on the left.
void Gaps::find_corners() {
  const auto& p = domain_.points;
  const Index n = static_cast<Index>(p.size()), count = static_cast<Index>(segments_.size());
  std::vector<Index> degree(n, 0), in(n, none), out(n, none);
  for (Index i = 0; i < count; ++i) {
    const Segment& s = segments_[i];
    ++degree[s.a];
    ++degree[s.b];
    out[s.a] = i;
    in[s.b] = i;
  }
  std::vector<char> sharp(n, 0);
  for (Index v = 0; v < n; ++v) {
    if (degree[v] != 2 || in[v] == none || out[v] == none) continue;
    const Vec2 back = p[segments_[in[v]].a] - p[v], ahead = p[segments_[out[v]].b] - p[v];
    const double l = length(back) * length(ahead);
    const double cosine = dot(ahead, back) / l, sine = cross(ahead, back) / l;
    if (cosine < sharp_cosine) continue;
    // A reflex needle is sharp only for a region on the right.
    const bool inside = sine > 0 ? segments_[in[v]].left != none : segments_[in[v]].right != none;
    if (!inside) continue;
    sharp[v] = 1;
    corners_.push_back({v, sine, cosine});
  }
  std::vector<Index> following(count, none), preceding(count, none);
  for (Index i = 0; i < count; ++i) {
    if (degree[segments_[i].b] == 2) following[i] = out[segments_[i].b];
    if (degree[segments_[i].a] == 2) preceding[i] = in[segments_[i].a];
  }
  wedge_behind_.assign(count, none);
  wedge_ahead_.assign(count, none);
  for (const Corner& corner : corners_) {
    mark_wedge(corner.point, out[corner.point], following, sharp, true);
    mark_wedge(corner.point, in[corner.point], preceding, sharp, false);
  }
}

void Gaps::mark_wedge(Index corner, Index first, const std::vector<Index>& next,
                      const std::vector<char>& sharp, bool ahead) {
  const auto& p = domain_.points;
  double arc = 0;
  for (Index i = first; i != none; i = next[i]) {
    const Index far = ahead ? segments_[i].b : segments_[i].a;
    arc += distance(p[segments_[i].a], p[segments_[i].b]);
    if (arc > straight_run * distance(p[corner], p[far])) return;
    (ahead ? wedge_behind_ : wedge_ahead_)[i] = corner;
    if (sharp[far]) return;
  }
}

bool Gaps::shares_wedge(Index s, Index t, Index& corner) const {
  if (wedge_behind_[s] != none && wedge_behind_[s] == wedge_ahead_[t])
    corner = wedge_behind_[s];
  else if (wedge_ahead_[s] != none && wedge_ahead_[s] == wedge_behind_[t])
    corner = wedge_ahead_[s];
  else
    return false;
  return true;
}

/// The spacing that the walls opposite to p, on segment `own`, ask for; at most `reach`.
double Gaps::spacing_at(Index own, Vec2 p, double reach) const {
  const auto& points = domain_.points;
  const Segment& s = segments_[own];
  // Seen across the outside of the domain, a wall does not matter.
  const auto faces = [&](const Segment& wall, Vec2 q) {
    const int side = orient2d(points[wall.a], points[wall.b], q);
    return side == 0 || (side > 0 ? wall.left : wall.right) != none;
  };
  double best = reach;
  tree_.walk(
      [&](Index, const Box& box) {
        const double gap = best * edges_per_gap;
        return squared_distance(box, Box{p, p}) < gap * gap;
      },
      [&](Index i) {
        const Segment& t = segments_[i];
        if (i == own || t.a == s.a || t.a == s.b || t.b == s.a || t.b == s.b) return;
        const Vec2 q = closest_point(p, points[t.a], points[t.b]);
        double spacing = distance(p, q) / edges_per_gap;
        if (spacing >= best || !faces(s, q) || !faces(t, p)) return;
        Index corner = none;
        if (shares_wedge(own, i, corner))
          spacing = std::max(spacing, edge_per_distance * distance(p, points[corner]));
        best = std::min(best, spacing);
      });
  return best;
}

double Gaps::wall_length() const {
  double total = 0;
  for (const Segment& s : segments_) total += distance(domain_.points[s.a], domain_.points[s.b]);
  return total;
}

/// Whether the piece is to be halved; if not, adds the sample that it asks for, if any. `known` is
/// the spacing in its middle without gaps.
bool Gaps::is_too_long(Index segment, const Piece& piece, double known, double growth, double floor,
                       std::vector<BoundarySpacing::Sample>& samples) const {
  const Vec2 middle = midpoint(piece.a, piece.b);
  const double half = 0.5 * distance(piece.a, piece.b);
  // At rounding distance from each other the halves would be the piece again.
  const bool atom = middle == piece.a || middle == piece.b;
  // Short pieces see near walls only, and that is quick.
  if (2 * half > known && !atom) return true;
  // Gap and spacing have bounded slopes: beyond this reach no point of the piece is concerned.
  const double reach = known + half * (growth + 1 / edges_per_gap);
  const double asked = spacing_at(segment, middle, reach);
  if (asked >= reach) return false;
  const double spacing = std::max(asked, floor);
  if (2 * half * edges_per_gap > spacing && !atom) return true;
  if (spacing < known) samples.push_back({middle, spacing});
  return false;
}

bool Gaps::sample_walls(const BoundarySpacing& without_gaps, const SpacingOptions& options,
                        double floor, Index most,
                        std::vector<BoundarySpacing::Sample>& samples) const {
  std::vector<Piece> waiting;
  const std::size_t limit = samples.size() + static_cast<std::size_t>(most);
  for (Index i = 0; i < static_cast<Index>(segments_.size()); ++i) {
    const Segment& s = segments_[i];
    const Vec2 a = domain_.points[s.a], b = domain_.points[s.b];
    const double at_ends = std::min(without_gaps.bound(s.a), without_gaps.bound(s.b));
    waiting.push_back({a, b, at_ends + 0.5 * options.growth * distance(a, b)});
    while (!waiting.empty()) {
      const Piece piece = waiting.back();
      waiting.pop_back();
      const Vec2 middle = midpoint(piece.a, piece.b);
      const double known = without_gaps.at(middle, piece.bound);
      if (is_too_long(i, piece, known, options.growth, floor, samples)) {
        const double half = 0.5 * distance(piece.a, piece.b);
        const double bound = known + 0.5 * options.growth * half;
        waiting.push_back({middle, piece.b, bound});
        waiting.push_back({piece.a, middle, bound});
      }
      if (samples.size() > limit) return false;
    }
  }
  return true;
}

}  // namespace lpq
