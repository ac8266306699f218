#include "surface/charts/bff.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/sort_numbers.h"
#include "numerics/elementary.h"
#include "numerics/multigrid.h"
#include "numerics/sparse.h"

namespace lpq {
namespace {

// Share of the area left out at either end when ranges are judged.
constexpr double tail = 0.005;
// Rows from which an estimate is worth it: it takes half as long as factors there, a seventh at
// 100,000.
constexpr Index least_estimated_rows = 10'000;
constexpr double estimate_tolerance = 1e-3;
// Ranges were estimated to 0.3 % at worst, over 65 parts.
constexpr double estimate_margin = 1.03;

class BoundaryFirst {
 public:
  BoundaryFirst(const Part& part, const Intrinsic& disk)
      : part_(part), disk_(disk), weights_(half_cotangents(disk)), angles_(angle_sums(disk)) {}
  MapOutcome run(double largest_range, std::vector<Vec2>& uv);

 private:
  void number_inside();
  bool surely_distorted(double largest_log_range) const;
  SparseRows inner_rows() const;
  bool factorise();
  std::vector<double> laplacian_of(const std::vector<double>& x) const;
  void solve_inside(const std::vector<double>& rhs, std::vector<double>& x) const;
  double log_range(const std::vector<double>& u) const;
  std::vector<Vec2> border_curve(const std::vector<double>& turning) const;
  void extend(std::vector<double>& x) const;

  const Part& part_;
  const Intrinsic& disk_;
  std::vector<double> weights_;  // #half-edges
  std::vector<double> angles_;   // #V
  std::vector<Index> border_;    // vertices in order
  std::vector<Index> row_;       // #V  none on the border
  Index rows_ = 0;
  std::optional<SparseFactor<double>> factor_;
};

void BoundaryFirst::number_inside() {
  row_.assign(disk_.vertices, 0);
  for (const Index e : part_.loops.row(0)) {
    border_.push_back(part_.origin(e));
    row_[border_.back()] = none;
  }
  for (Index& row : row_)
    if (row != none) row = rows_++;
}

/// The system of factorise().
SparseRows BoundaryFirst::inner_rows() const {
  SparseRows rows;
  rows.diagonal.assign(rows_, 0.0);
  const auto each_side = [&](auto&& visit) {
    for (Index e = 0; e < static_cast<Index>(weights_.size()); ++e) {
      const Index a = row_[corners_of(disk_.corners)[e]];
      const Index b = row_[corners_of(disk_.corners)[next_in_triangle(e)]];
      // An inner edge comes by twice, with the weight of one side each time.
      const Index twin = disk_.twins[e];
      if (a != none && a != b) visit(a, b, weights_[e] + (twin == none ? 0 : weights_[twin]));
    }
  };
  each_side([&](Index a, Index, double weight) { rows.diagonal[a] += weight; });
  fill_csr(rows.couplings, rows_, [&](auto&& emit) {
    each_side([&](Index a, Index b, double weight) {
      if (b != none) emit(a, Coupling{b, -weight});
    });
  });
  return rows;
}

bool BoundaryFirst::factorise() {
  std::vector<Triplet> entries;
  entries.reserve(2 * weights_.size());
  for (Index e = 0; e < static_cast<Index>(weights_.size()); ++e) {
    const Index a = row_[corners_of(disk_.corners)[e]];
    const Index b = row_[corners_of(disk_.corners)[next_in_triangle(e)]];
    if (a == b) continue;  // on the border, or an edge from a vertex to itself
    if (a != none) entries.push_back({a, a, weights_[e]});
    if (b != none) entries.push_back({b, b, weights_[e]});
    if (a != none && b != none) entries.push_back({std::max(a, b), std::min(a, b), -weights_[e]});
  }
  factor_.emplace(rows_, entries);
  return factor_->status() == SparseStatus::ok;
}

std::vector<double> BoundaryFirst::laplacian_of(const std::vector<double>& x) const {
  std::vector<double> result(x.size(), 0.0);
  for (Index e = 0; e < static_cast<Index>(weights_.size()); ++e) {
    const Index a = corners_of(disk_.corners)[e];
    const Index b = corners_of(disk_.corners)[next_in_triangle(e)];
    const double flow = weights_[e] * (x[a] - x[b]);
    result[a] += flow;
    result[b] -= flow;
  }
  return result;
}

// x inside with A x = rhs there (#V values; those at the border are not read).
void BoundaryFirst::solve_inside(const std::vector<double>& rhs, std::vector<double>& x) const {
  std::vector<double> b(rows_);
  for (Index v = 0; v < disk_.vertices; ++v)
    if (row_[v] != none) b[row_[v]] = rhs[v];
  factor_->solve(b, b);
  for (Index v = 0; v < disk_.vertices; ++v)
    if (row_[v] != none) x[v] = b[row_[v]];
}

double BoundaryFirst::log_range(const std::vector<double>& u) const {
  std::vector<double> area(disk_.vertices, 0.0);
  for (std::size_t e = 0; e < disk_.length.size(); e += 3) {
    const double quarter = four_areas({disk_.length[e], disk_.length[e + 1], disk_.length[e + 2]});
    for (const Index v : disk_.corners[e / 3]) area[v] += quarter;
  }
  std::vector<std::pair<double, Index>> order;
  double total = 0;
  for (Index v = 0; v < part_.vertex_count(); ++v) {
    order.push_back({u[v], v});
    total += area[v];
  }
  sort_values(order);
  double sum = 0, low = order.back().first, high = order.back().first;
  for (const auto& [value, v] : order) {
    if (sum <= tail * total) low = value;
    sum += area[v];
    if (sum < (1 - tail) * total) high = value;
  }
  return high - low;
}

// Edges of the given turning and, nearly, the lengths of the surface: the lengths change by the
// least (in the paper's weighting, section 4.3.2) that closes the curve.
std::vector<Vec2> BoundaryFirst::border_curve(const std::vector<double>& turning) const {
  const std::size_t n = border_.size();
  std::vector<Vec2> tangent(n);
  Vec2 gap;
  double xx = 0, xy = 0, yy = 0, angle = 0;
  const auto loop = part_.loops.row(0);
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) angle += turning[i];
    const SinCos t = sin_cos(angle);
    tangent[i] = {t.cos, t.sin};
    const double l = part_.length[loop[i]];
    gap += l * tangent[i];
    xx += l * t.cos * t.cos;
    xy += l * t.cos * t.sin;
    yy += l * t.sin * t.sin;
  }
  const double det = xx * yy - xy * xy;
  const Vec2 shift =
      det > 0 ? Vec2{(yy * gap.x - xy * gap.y) / det, (xx * gap.y - xy * gap.x) / det} : Vec2{0, 0};
  std::vector<Vec2> curve(n);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double l = part_.length[loop[i]];
    curve[i + 1] = curve[i] + (l - l * dot(tangent[i], shift)) * tangent[i];
  }
  return curve;
}

void BoundaryFirst::extend(std::vector<double>& x) const {
  std::vector<double> rhs = laplacian_of(x);  // x is zero inside
  for (double& value : rhs) value = -value;
  solve_inside(rhs, x);
}

/// Most large parts that are tried are too distorted, and a solution to a few digits tells, for a
/// fraction of what factors cost. What is close to the limit is left to them.
bool BoundaryFirst::surely_distorted(double largest_log_range) const {
  if (rows_ < least_estimated_rows) return false;
  std::vector<double> b, x, u(disk_.vertices, 0.0);
  for (Index v = 0; v < disk_.vertices; ++v)
    if (row_[v] != none) b.push_back(angles_[v] - 2 * pi);
  if (!solve_nearly(inner_rows(), b, estimate_tolerance, x)) return false;
  for (Index v = 0; v < disk_.vertices; ++v)
    if (row_[v] != none) u[v] = x[row_[v]];
  return log_range(u) > estimate_margin * largest_log_range;
}

MapOutcome BoundaryFirst::run(double largest_range, std::vector<Vec2>& uv) {
  number_inside();
  const double largest_log_range = logarithm(largest_range);
  if (surely_distorted(largest_log_range)) return MapOutcome::distorted;
  if (!factorise()) return MapOutcome::unsolved;
  std::vector<double> u(disk_.vertices, 0.0), rhs(disk_.vertices, 0.0);
  for (Index v = 0; v < disk_.vertices; ++v) rhs[v] = angles_[v] - 2 * pi;
  solve_inside(rhs, u);
  if (log_range(u) > largest_log_range) return MapOutcome::distorted;

  const std::vector<double> flow = laplacian_of(u);
  std::vector<double> turning;
  for (const Index v : border_) turning.push_back(pi - angles_[v] + flow[v]);
  const std::vector<Vec2> curve = border_curve(turning);
  std::vector<double> x(disk_.vertices, 0.0), y(disk_.vertices, 0.0);
  for (std::size_t i = 0; i < border_.size(); ++i) {
    x[border_[i]] = curve[i].x;
    y[border_[i]] = curve[i].y;
  }
  extend(x);
  extend(y);
  uv.resize(part_.vertex.size());
  for (std::size_t v = 0; v < uv.size(); ++v) uv[v] = {x[v], y[v]};
  return MapOutcome::mapped;
}

}  // namespace

MapOutcome map_bff(const Part& part, const Intrinsic& disk, double largest_range,
                   std::vector<Vec2>& uv) {
  return BoundaryFirst(part, disk).run(largest_range, uv);
}

}  // namespace lpq
