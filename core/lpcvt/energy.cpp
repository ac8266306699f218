// Assembly of F and dF/dx (paper Eqs. 4-10). Every cell is divided into sub-triangles (site, C1,
// C2), Fig. 14; one pass computes their energy and its derivatives by C1 and C2, summed per Voronoi
// vertex so that each vertex's chain rule is applied once; a translation changes nothing, so the
// derivative by the site is minus the sum of the two.
//
// Deviation: the paper interpolates the density linearly on each sub-triangle from values at the
// site and at C1, C2; here rho is constant per cell, taken at the site, which needs a third of the
// field samples and made no measurable difference to the mesh. Its variation still enters the
// gradient exactly, through rho(x_i) and theta(x_i).
//
// Sub-triangles are gathered into blocks of separate arrays, integrated (SIMD), and scattered. Sums
// run in the order of half-edges, then of the rim: the same bits on every platform.
#include "lpcvt/energy.h"

#include <algorithm>

#include "base/check.h"
#include "lpcvt/chain_rule.h"

namespace lpq {
namespace {

class Assembly {
 public:
  Assembly(const TriMesh& mesh, const EnergyOptions& options, EnergyWorkspace& workspace,
           std::span<Vec2> gradient)
      : mesh_(mesh),
        options_(options),
        work_(workspace),
        gradient_(gradient),
        stretched_(!workspace.stretch.empty()) {}

  double run() {
    clear();
    integrate_cells();
    if (!gradient_.empty()) {
      move_circumcentres();
      move_rim();
      if (options_.metric_gradient) move_metric();
      if (options_.metric_gradient && stretched_) move_stretch();
      std::fill_n(gradient_.begin(), std::min<std::size_t>(mesh_.fixed, gradient_.size()), Vec2{});
    }
    return finish_cells();
  }

 private:
  void clear();
  void stretch_frames();
  void integrate_cells();
  void add(FanTriangle fan) {
    fans_[count_++] = fan;
    if (count_ == PieceBlock::capacity) flush();
  }
  void flush();
  void gather();
  void scatter();
  void move_circumcentres();
  void move_rim();
  void move_metric();
  void move_stretch();
  double finish_cells();

  const TriMesh& mesh_;
  const EnergyOptions& options_;
  EnergyWorkspace& work_;
  std::span<Vec2> gradient_;
  const bool stretched_;
  PieceBlock block_;
  FanTriangle fans_[PieceBlock::capacity];
  int count_ = 0;
};

void Assembly::clear() {
  const std::size_t sites = mesh_.points.size();
  LPQ_ASSERT(gradient_.empty() || gradient_.size() == sites);
  std::fill(gradient_.begin(), gradient_.end(), Vec2{});
  work_.cell_energy.assign(sites, 0);
  work_.cell_area.assign(sites, 0);
  work_.torque.assign(sites, 0);
  work_.vertex_gradient.assign(work_.dual.vertices.size(), Vec2{});
  work_.frames.resize(sites);
  for (std::size_t i = 0; i < sites; ++i) {
    const FieldSample& metric = work_.metric[i];
    const double inverse_h = 1 / metric.h;
    const double c = metric.axis.x * inverse_h, s = metric.axis.y * inverse_h;
    work_.frames[i] = {mesh_.points[i].x, mesh_.points[i].y, c, s, -s, c};
  }
  if (stretched_) stretch_frames();
  const int degree = options_.gauss_degree > 0 ? options_.gauss_degree : gauss_degree(options_.p);
  const bool gauss = options_.gauss || !has_closed_form(options_.p);
  if (gauss && work_.rule_degree != degree) {
    work_.rule = triangle_rule(degree);
    work_.rule_degree = degree;
  }
}

// The rows of M S are those of M stretched, as S is symmetric.
void Assembly::stretch_frames() {
  work_.shear.assign(work_.frames.size(), Vec2{});
  for (std::size_t i = 0; i < work_.frames.size(); ++i) {
    EnergyWorkspace::SiteFrame& f = work_.frames[i];
    const Vec2 x = stretched({f.xx, f.xy}, work_.stretch[i].mu);
    const Vec2 y = stretched({f.yx, f.yy}, work_.stretch[i].mu);
    f = {f.x, f.y, x.x, x.y, y.x, y.y};
  }
}

void Assembly::integrate_cells() {
  const Index half_edges = 3 * mesh_.triangle_count();
  for (Index e = 0; e < half_edges; ++e) {
    const Index twin = mesh_.twins[e];
    if (!work_.dual.is_regular(e, twin)) continue;
    const Index left = triangle_of(e), right = triangle_of(twin);
    add({mesh_.origin(e), right, left});
    add({mesh_.target(e), left, right});
  }
  for (const FanTriangle& fan : work_.dual.fans) add(fan);
  flush();
}

void Assembly::flush() {
  gather();
  if (options_.gauss || !has_closed_form(options_.p))
    integrate_gauss(options_.p, work_.rule, count_, block_);
  else
    integrate_closed_form(static_cast<int>(options_.p), count_, block_);
  scatter();
  count_ = 0;
}

void Assembly::gather() {
  for (int i = 0; i < count_; ++i) {
    const FanTriangle fan = fans_[i];
    const EnergyWorkspace::SiteFrame f = work_.frames[fan.site];
    const Vec2 c1 = work_.dual.vertices[fan.c1], c2 = work_.dual.vertices[fan.c2];
    const double ax = c1.x - f.x, ay = c1.y - f.y, bx = c2.x - f.x, by = c2.y - f.y;
    block_.ux[i] = f.xx * ax + f.xy * ay;
    block_.uy[i] = f.yx * ax + f.yy * ay;
    block_.vx[i] = f.xx * bx + f.xy * by;
    block_.vy[i] = f.yx * bx + f.yy * by;
  }
}

void Assembly::scatter() {
  for (int i = 0; i < count_; ++i) {
    const Index site = fans_[i].site;
    work_.cell_energy[site] += block_.energy[i];
    work_.cell_area[site] += block_.double_area[i];
    if (gradient_.empty()) continue;
    const EnergyWorkspace::SiteFrame f = work_.frames[site];
    const double dux = block_.dux[i], duy = block_.duy[i];
    const double dvx = block_.dvx[i], dvy = block_.dvy[i];
    const Vec2 d1{f.xx * dux + f.yx * duy, f.xy * dux + f.yy * duy};
    const Vec2 d2{f.xx * dvx + f.yx * dvy, f.xy * dvx + f.yy * dvy};
    work_.vertex_gradient[fans_[i].c1] += d1;
    work_.vertex_gradient[fans_[i].c2] += d2;
    gradient_[site] -= d1 + d2;
    // Turning the cross by d theta turns u by -d theta: du = (u_y, -u_x) d theta.
    work_.torque[site] +=
        (dux * block_.uy[i] - duy * block_.ux[i]) + (dvx * block_.vy[i] - dvy * block_.vx[i]);
    if (stretched_)
      work_.shear[site] += complex_product({dux, duy}, {block_.ux[i], block_.uy[i]}) +
                           complex_product({dvx, dvy}, {block_.vx[i], block_.vy[i]});
  }
}

void Assembly::move_circumcentres() {
  for (Index t = 0; t < mesh_.triangle_count(); ++t) {
    if (work_.dual.sheet[t] != none) continue;
    const Tri& tri = mesh_.triangles[t];
    const ThreeSites d =
        circumcentre_gradient(mesh_.points[tri[0]], mesh_.points[tri[1]], mesh_.points[tri[2]],
                              work_.dual.vertices[t], work_.vertex_gradient[t]);
    gradient_[tri[0]] += d.x0;
    gradient_[tri[1]] += d.x1;
    gradient_[tri[2]] += d.x2;
  }
}

void Assembly::move_rim() {
  const Index triangles = mesh_.triangle_count();
  for (std::size_t k = 0; k < work_.dual.rim.size(); ++k) {
    const RimVertex& rim = work_.dual.rim[k];
    if (rim.kind == VertexKind::corner) continue;
    const Vec2 along = mesh_.points[mesh_.target(rim.wall)] - mesh_.points[mesh_.origin(rim.wall)];
    const std::size_t vertex = static_cast<std::size_t>(triangles) + k;
    const TwoSites d =
        wall_crossing_gradient(mesh_.points[rim.u], mesh_.points[rim.v], along,
                               work_.dual.vertices[vertex], work_.vertex_gradient[vertex]);
    gradient_[rim.u] += d.u;
    gradient_[rim.v] += d.v;
  }
}

// The metric moves with its site: dI/dtheta grad theta, and dI/dlog h = -(p + 2) I because I is
// homogeneous of degree p + 2 in 1/h.
void Assembly::move_metric() {
  const double degree = options_.p + 2;
  for (std::size_t i = 0; i < mesh_.points.size(); ++i) {
    const FieldSample& metric = work_.metric[i];
    gradient_[i] += work_.torque[i] * metric.grad_theta;
    gradient_[i] -= (degree * work_.cell_energy[i]) * metric.grad_log_h;
  }
}

// Of u = M S w, a change of mu by d makes du = (e^{-2 i theta} d conj u - i Im(d conj mu) u) / (1 -
// |mu|^2): a shear in the cross's frame, and a turn like that of theta.
void Assembly::move_stretch() {
  for (std::size_t i = 0; i < mesh_.points.size(); ++i) {
    const auto& [mu, dx, dy] = work_.stretch[i];
    const Vec2 axis = work_.metric[i].axis;
    const Vec2 shear = complex_product(work_.shear[i], complex_product(axis, axis));
    const Vec2 by_mu =
        (1 / (1 - squared_length(mu))) * (shear + work_.torque[i] * perpendicular(mu));
    gradient_[i] += Vec2{dot(by_mu, dx), dot(by_mu, dy)};
  }
}

double Assembly::finish_cells() {
  double total = 0;
  for (std::size_t i = 0; i < mesh_.points.size(); ++i) {
    const double h = work_.metric[i].h;
    work_.cell_area[i] *= 0.5 * h * h;
    total += work_.cell_energy[i];
  }
  return total;
}

}  // namespace

void sample_metric(const TriMesh& mesh, const Fields& fields, EnergyWorkspace& workspace) {
  const std::size_t sites = mesh.points.size();
  workspace.metric.resize(sites);
  workspace.hints.resize(sites, none);
  for (std::size_t i = 0; i < sites; ++i)
    workspace.metric[i] = fields.sample(mesh.points[i], workspace.hints[i]);
  workspace.stretch.resize(fields.stretch.empty() ? 0 : sites);
  for (std::size_t i = 0; i < workspace.stretch.size(); ++i)
    workspace.stretch[i] = fields.sample_stretch(mesh.points[i], workspace.hints[i]);
}

double integrate_energy(const TriMesh& mesh, const EnergyOptions& options,
                        EnergyWorkspace& workspace, std::span<Vec2> gradient) {
  return Assembly(mesh, options, workspace, gradient).run();
}

double lp_energy(const TriMesh& mesh, const Fields& fields, const EnergyOptions& options,
                 EnergyWorkspace& workspace, std::span<Vec2> gradient) {
  clip_dual(mesh, workspace.dual);
  sample_metric(mesh, fields, workspace);
  return integrate_energy(mesh, options, workspace, gradient);
}

}  // namespace lpq
