// Least squares over the edges of  |X'_j - E_ij X_i|^2,  X = (Re U, Im U, Re V, Im V): going from i
// to j the phases advance by delta = (x_j - x_i) along the mean axes over the mean size (E_ij turns
// U, V by 2 pi delta), and X'_j are the phases of j in the frame of i, which is k quarter turns
// away: k = 1 makes (U, V) into (V, conj U) and so on. All blocks are orthogonal, so the matrix is
// a connection Laplacian: degree times identity on the diagonal. Frames are combed along a tree
// first: then k = 0 except across cuts between singularities, and U and V hardly meet in the
// factor.
#include "lpcvt/phase_field.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/csr.h"
#include "numerics/elementary.h"
#include "numerics/sparse.h"

namespace lpq {
namespace {

// Integer points this far outside a triangle (barycentric) still count, lest one on an edge be lost
// to rounding by both sides; the copies fall to the distance test of the caller.
constexpr double edge_tolerance = 1e-9;
// A triangle whose image in the (u, v) plane has less than this area is folded flat.
constexpr double flat_image = 1e-6;

// Beyond this many unknowns the factor is not worth its time and memory (about 10 s and 0.6 GB at
// half a million, growing faster than linearly): the caller's packing stands alone. A domain of a
// million elements stays below 300 000, because the background coarsens away from the walls; only
// backgrounds full of boundary (some 100 000 nodes) exceed it.
constexpr Index most_unknowns = 600'000;

// Quarter turns of a frame: (u, v) -> (v, -u), k times.
Vec2 turned(Vec2 uv, int k) {
  switch (k & 3) {
    case 0: return uv;
    case 1: return {uv.y, -uv.x};
    case 2: return {-uv.x, -uv.y};
    default: return {-uv.y, uv.x};
  }
}

// The same turns of an axis: j's axis turned by k arms.
Vec2 arm(Vec2 axis, int k) {
  switch (k & 3) {
    case 0: return axis;
    case 1: return perpendicular(axis);
    case 2: return -axis;
    default: return -perpendicular(axis);
  }
}

// Number of quarter turns that bring axis `from` nearest to `to`.
int quarter_turns(Vec2 from, Vec2 to) {
  const double along = dot(from, to), across = cross(from, to);
  if (std::abs(along) >= std::abs(across)) return along >= 0 ? 0 : 2;
  return across >= 0 ? 1 : 3;
}

double wrapped(double x) { return x - std::floor(x + 0.5); }

struct Step {
  int k = 0;   // quarter turns that bring j's frame to i's
  Vec2 delta;  // advance of (u, v) from i to j in i's frame
};

class PhaseField {
 public:
  PhaseField(const BoundaryMesh& boundary, const Fields& fields)
      : mesh_(fields.background),
        h_(fields.h),
        stretch_(fields.stretch),
        fixed_(static_cast<Index>(boundary.points.size())) {
    axis_.reserve(fields.z.size());
    for (const Vec2 z : fields.z) axis_.push_back(axis_of(z));
  }

  bool solve();
  std::vector<PhasePoint> integer_points() const;

 private:
  Step step(Index i, Index j) const {
    Step s;
    s.k = quarter_turns(axis_[j], axis_[i]);
    const Vec2 sum = axis_[i] + arm(axis_[j], s.k);
    Vec2 e = mesh_.points[j] - mesh_.points[i];
    if (!stretch_.empty()) e = stretched(e, midpoint(stretch_[i], stretch_[j]));
    // One root of the product, not a product of roots: odd powers of two stay exact.
    const double scale = 1 / (length(sum) * std::sqrt(h_[i] * h_[j]));
    s.delta = {scale * dot(sum, e), scale * cross(sum, e)};
    return s;
  }
  void comb();
  void add_edge(Index i, Index j, std::vector<Triplet>& matrix, std::vector<double>& rhs) const;
  Vec2 phase(Index i) const { return phase_[i]; }
  bool unwrap(const Tri& tri, std::array<Vec2, 3>& uv) const;

  const TriMesh& mesh_;
  const std::vector<double>& h_;
  const std::vector<Vec2>& stretch_;
  Index fixed_;
  std::vector<Vec2> axis_;   // #V  combed
  std::vector<Vec2> phase_;  // #V  (u, v) modulo 1
};

// Breadth-first over the free vertices: each takes the arm nearest to its parent's axis.
void PhaseField::comb() {
  const Index count = mesh_.vertex_count();
  const auto neighbours = csr_from<Index>(count, [&](auto&& emit) {
    for (Index e = 0; e < 3 * mesh_.triangle_count(); ++e)
      if (mesh_.origin(e) >= fixed_ && mesh_.target(e) >= fixed_)
        emit(mesh_.origin(e), mesh_.target(e));
  });
  std::vector<char> seen(count, 0);
  std::vector<Index> queue;
  for (Index root = fixed_; root < count; ++root) {
    if (seen[root]) continue;
    seen[root] = 1;
    queue.assign(1, root);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Index i = queue[next];
      for (const Index j : neighbours.row(i)) {
        if (seen[j]) continue;
        seen[j] = 1;
        axis_[j] = arm(axis_[j], quarter_turns(axis_[j], axis_[i]));
        queue.push_back(j);
      }
    }
  }
}

// Row r of X'_j in terms of X_j: entry source[k][r] times sign[k][r].
constexpr int source[4][4] = {{0, 1, 2, 3}, {2, 3, 0, 1}, {0, 1, 2, 3}, {2, 3, 0, 1}};
constexpr int sign[4][4] = {{1, 1, 1, 1}, {1, 1, 1, -1}, {1, -1, 1, -1}, {1, -1, 1, 1}};

void PhaseField::add_edge(Index i, Index j, std::vector<Triplet>& matrix,
                          std::vector<double>& rhs) const {
  const bool free_i = i >= fixed_, free_j = j >= fixed_;
  if (!free_i && !free_j) return;
  const Step s = step(i, j);
  const Index row_i = 4 * (i - fixed_), row_j = 4 * (j - fixed_);
  const double deltas[2] = {s.delta.x, s.delta.y};
  for (int half = 0; half < 2; ++half) {
    const auto [sine, cosine] = sin_cos(2 * pi * wrapped(deltas[half]));
    // Block -E^T S_k, rows (Re, Im) of this phase of i: E^T = [c s; -s c].
    const int re = 2 * half, im = re + 1;
    const double entries[2][2] = {{-cosine * sign[s.k][re], -sine * sign[s.k][im]},
                                  {sine * sign[s.k][re], -cosine * sign[s.k][im]}};
    for (int r = 0; r < 2; ++r) {
      for (int c = 0; c < 2; ++c) {
        const Index column = source[s.k][re + c];
        const double entry = entries[r][c];
        const double one = column % 2 == 0 ? 1 : 0;  // U = V = 1 at fixed nodes
        if (free_i && free_j) {
          const Index a = row_i + re + r, b = row_j + column;
          matrix.push_back({std::max(a, b), std::min(a, b), entry});
        } else if (free_i) {
          rhs[row_i + re + r] -= entry * one;
        } else if (r == 0) {  // Im X_i = 0
          rhs[row_j + column] -= entry;
        }
      }
    }
  }
  for (int r = 0; r < 4; ++r) {
    if (free_i) matrix.push_back({row_i + r, row_i + r, 1});
    if (free_j) matrix.push_back({row_j + r, row_j + r, 1});
  }
}

bool PhaseField::solve() {
  if (mesh_.vertex_count() - fixed_ > most_unknowns / 4) return false;
  comb();
  const Index n = 4 * (mesh_.vertex_count() - fixed_);
  std::vector<Triplet> matrix;
  matrix.reserve(static_cast<std::size_t>(24) * mesh_.triangles.size());
  std::vector<double> rhs(n, 0.0), x;
  for (Index e = 0; e < 3 * mesh_.triangle_count(); ++e)
    if (mesh_.twins[e] < e) add_edge(mesh_.origin(e), mesh_.target(e), matrix, rhs);
  if (solve_spd(n, matrix, rhs, 1, x) != SparseStatus::ok) return false;
  phase_.assign(mesh_.points.size(), {0, 0});
  constexpr double turns = 1 / (2 * pi);
  for (Index v = fixed_; v < mesh_.vertex_count(); ++v) {
    const double* const p = x.data() + 4 * static_cast<std::size_t>(v - fixed_);
    phase_[v] = {turns * arc_tangent(p[1], p[0]), turns * arc_tangent(p[3], p[2])};
  }
  return true;
}

// Continuous (u, v) at the corners in the frame of the first; false where quarter turns or whole
// turns round the triangle do not cancel.
bool PhaseField::unwrap(const Tri& tri, std::array<Vec2, 3>& uv) const {
  const auto advance = [&](Index i, Index j, const Step& s) {
    const Vec2 other = turned(phase(j), s.k), here = phase(i);
    return Vec2{s.delta.x + wrapped(other.x - here.x - s.delta.x),
                s.delta.y + wrapped(other.y - here.y - s.delta.y)};
  };
  const Step s01 = step(tri[0], tri[1]), s02 = step(tri[0], tri[2]), s12 = step(tri[1], tri[2]);
  if (((s01.k + s12.k - s02.k) & 3) != 0) return false;
  uv[0] = phase(tri[0]);
  uv[1] = uv[0] + advance(tri[0], tri[1], s01);
  uv[2] = uv[0] + advance(tri[0], tri[2], s02);
  const Vec2 gap = uv[2] - uv[1] - turned(advance(tri[1], tri[2], s12), s01.k);
  return std::abs(gap.x) < 0.5 && std::abs(gap.y) < 0.5;
}

std::vector<PhasePoint> PhaseField::integer_points() const {
  std::vector<PhasePoint> points;
  for (Index t = 0; t < mesh_.triangle_count(); ++t) {
    const Tri& tri = mesh_.triangles[t];
    std::array<Vec2, 3> uv;
    if (!unwrap(tri, uv)) continue;
    const Vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    const double area = cross(a, b);
    if (std::abs(area) < flat_image) continue;
    const auto [low_u, high_u] = std::minmax({uv[0].x, uv[1].x, uv[2].x});
    const auto [low_v, high_v] = std::minmax({uv[0].y, uv[1].y, uv[2].y});
    for (double m = std::ceil(low_u - edge_tolerance); m <= high_u + edge_tolerance; ++m)
      for (double n = std::ceil(low_v - edge_tolerance); n <= high_v + edge_tolerance; ++n) {
        const Vec2 d = Vec2{m, n} - uv[0];
        const double l1 = cross(d, b) / area, l2 = cross(a, d) / area, l0 = 1 - l1 - l2;
        if (std::min({l0, l1, l2}) < -edge_tolerance) continue;
        points.push_back(
            {l0 * mesh_.points[tri[0]] + l1 * mesh_.points[tri[1]] + l2 * mesh_.points[tri[2]], t});
      }
  }
  return points;
}

}  // namespace

std::vector<PhasePoint> phase_points(const BoundaryMesh& boundary, const Fields& fields) {
  PhaseField phases(boundary, fields);
  if (!phases.solve()) return {};
  return phases.integer_points();
}

}  // namespace lpq
