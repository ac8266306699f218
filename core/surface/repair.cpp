// See repair.h.
#include "surface/repair.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "base/sort_numbers.h"
#include "base/words.h"
#include "surface/flat.h"
#include "surface/hanging.h"
#include "surface/orient.h"
#include "surface/weld.h"

namespace lpq {
namespace {

// Points as near as this, relative to the diagonal, may be the two sides of a slit: of the order of
// what CAD kernels take for one point.
constexpr double slit_width = 1e-6;
constexpr double widest_gap = 1e-3;  // relative to the diagonal, that is told
// A triangle lower than this, relative to the diagonal, is flat: what rounding leaves of collinear
// points. Removing it moves the surface by no more than that.
constexpr double flat_height = 1e-10;
constexpr double most_shorter = 0.9;   // of the edges may be shorter than the distance of welding
constexpr double mostly_open = 1;      // edges of one triangle for every triangle
constexpr double left_open = 0.1;      // of those
constexpr double may_collapse = 0.02;  // of the triangles
constexpr double least_weld = 1e-15;   // below the last bit of the coordinates: equal points only

class Repair {
 public:
  Repair(SurfaceSoup soup, const RepairOptions& options)
      : soup_(std::move(soup)), options_(options) {
    report_.points_given = static_cast<Index>(soup_.points.size());
    report_.triangles_given = static_cast<Index>(soup_.triangles.size());
    if (soup_.group.empty()) soup_.group.assign(soup_.triangles.size(), 0);
  }

  Result<RepairedSurface> run() {
    if (!(options_.weld >= 0 && options_.weld <= 0.01))
      return Error{ErrorCode::bad_option, "Option weld must lie between 0 and 0.01.", {}};
    auto extent = check_soup(soup_);
    if (!extent) return extent.error();
    used_ = std::move(extent->used);
    const auto most = *std::max_element(soup_.group.begin(), soup_.group.end());
    soup_.group_names.resize(
        std::max(soup_.group_names.size(), static_cast<std::size_t>(most) + 1));
    report_.unused_points = extent->unused;
    diagonal_ = extent->diagonal;
    if (const Problem near = check_weld()) return *near;
    part_bodies();
    weld();
    drop_collapsed();
    drop_duplicates();
    close_slits();
    share_hanging();
    if (!remove_flat()) return nothing_left();
    look_for_gaps();
    return finish();
  }

 private:
  /// Triangles of different bodies get points of their own, so that nothing joins them.
  void part_bodies() {
    if (soup_.body.empty()) return soup_.body_names.clear();
    const auto most = *std::max_element(soup_.body.begin(), soup_.body.end());
    soup_.body_names.resize(std::max(soup_.body_names.size(), static_cast<std::size_t>(most) + 1));
    body_.assign(soup_.points.size(), none);
    std::map<std::array<Index, 2>, Index> copies;  // of a point for all bodies but its first
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t)
      for (Index& v : soup_.triangles[t]) {
        const Index body = soup_.body[t];
        if (body_[v] == none) body_[v] = body;
        if (body_[v] == body) continue;
        const auto next = static_cast<Index>(soup_.points.size());
        const auto [copy, is_new] = copies.insert({{v, body}, next});
        if (is_new) add_copy(v, body);
        v = copy->second;
      }
  }

  void add_copy(Index v, Index body) {
    soup_.points.push_back(Vec3{soup_.points[v]});
    if (!soup_.sizes.empty()) soup_.sizes.push_back(double{soup_.sizes[v]});
    used_.push_back(1);
    body_.push_back(body);
  }

  bool joins_nearly_all(double reach) const {
    double edges = 0, shorter = 0;
    for (const Tri& t : soup_.triangles)
      for (int k = 0; k < 3; ++k) {
        const double side = distance(soup_.points[t[k]], soup_.points[t[(k + 1) % 3]]);
        edges += side > 0;
        shorter += side > 0 && side < reach;
      }
    return shorter > most_shorter * edges;
  }

  /// A point far away from all others, or too large a weld, would make one point of nearly all.
  Problem check_weld() const {
    const double reach = options_.weld * diagonal_;
    if (!joins_nearly_all(reach)) return {};
    Vec3 sum{};
    for (const Tri& t : soup_.triangles)
      for (const Index v : t) sum += soup_.points[v];
    const Vec3 mean = (1 / (3.0 * static_cast<double>(soup_.triangles.size()))) * sum;
    Vec3 far = mean;
    for (const Tri& t : soup_.triangles)
      for (const Index v : t)
        if (distance(soup_.points[v], mean) > distance(far, mean)) far = soup_.points[v];
    return Error{ErrorCode::lost_precision,
                 "Nearly all edges are shorter than " + short_number(reach) +
                     ", the distance at which points become one. Is the point " +
                     place_in_space(far.x, far.y, far.z) +
                     " in its place? If so, use a smaller weld.",
                 {}};
  }

  void weld() {
    first_ = welded(options_.weld);
    widen_weld();
    for (std::size_t v = 0; v < first_.size(); ++v)
      report_.welded_points += first_[v] != static_cast<Index>(v);
    renumber(first_);
  }

  std::vector<Index> welded(double weld) const {
    return weld_points(soup_.points, used_, weld < least_weld ? 0 : weld * diagonal_, body_);
  }

  /// Files that round the points of every face for themselves fall to pieces: the first distance
  /// that makes nearly whole what is open nearly everywhere is theirs.
  void widen_weld() {
    if (options_.weld < least_weld) return;
    const OpenEdges given = open_edges(soup_.triangles, first_);
    const auto all = static_cast<double>(soup_.triangles.size());
    if (given.count < mostly_open * all) return;
    for (const double wider : {1e-8, 1e-7, 1e-6, 1e-5}) {
      if (wider <= options_.weld) continue;
      if (joins_nearly_all(wider * diagonal_)) return;
      std::vector<Index> first = welded(wider);
      const OpenEdges now = open_edges(soup_.triangles, first);
      if (now.collapsed > given.collapsed + may_collapse * all ||
          now.count > left_open * given.count)
        continue;
      first_ = std::move(first);
      report_.rounding = wider * diagonal_;
      return;
    }
  }

  void renumber(const std::vector<Index>& number) {
    for (Tri& t : soup_.triangles)
      for (Index& v : t) v = number[v];
  }

  void close_slits() {
    if (options_.weld < least_weld || !(diagonal_ > 0)) return;
    const std::vector<Index> across =
        points_across_slits(soup_.points, soup_.triangles, slit_width * diagonal_);
    if (across.empty()) return;
    for (std::size_t v = 0; v < across.size(); ++v)
      report_.slit_points += across[v] != static_cast<Index>(v);
    renumber(across);
    for (Index& v : first_) v = across[v];
    drop_collapsed();
    drop_duplicates();
  }

  void share_hanging() {
    if (options_.weld < least_weld || !(diagonal_ > 0)) return;
    report_.hanging_points =
        share_hanging_points(soup_.points, std::max(slit_width, options_.weld) * diagonal_,
                             soup_.triangles, soup_.group);
  }

  void look_for_gaps() {
    if (!(diagonal_ > 0)) return;
    report_.gap = border_gap(soup_.points, soup_.triangles, widest_gap * diagonal_, body_);
    if (report_.gap.points == 0) return;
    report_.closing_weld = slit_width;
    while (report_.closing_weld * diagonal_ < report_.gap.width) report_.closing_weld *= 2;
  }

  /// Keeps the triangles for which keep(t) holds, and says how many it dropped.
  template <class Keep>
  Index filter(Keep&& keep) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
      if (!keep(t)) continue;
      soup_.triangles[kept] = soup_.triangles[t];
      soup_.group[kept++] = soup_.group[t];
    }
    const auto dropped = static_cast<Index>(soup_.triangles.size() - kept);
    soup_.triangles.resize(kept);
    soup_.group.resize(kept);
    return dropped;
  }

  void drop_collapsed() {
    report_.collapsed_triangles += filter([this](std::size_t i) {
      const Tri& t = soup_.triangles[i];
      return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    });
  }

  void drop_duplicates() {
    std::vector<Tri> keys = soup_.triangles;
    for (Tri& key : keys) std::sort(key.begin(), key.end());
    const std::vector<Index> order = sorted_numbers(
        keys.size(), [&](Index i, Index j) { return std::tie(keys[i], i) < std::tie(keys[j], j); });
    std::vector<char> repeated(keys.size(), 0);
    for (std::size_t k = 1; k < keys.size(); ++k)
      repeated[order[k]] = keys[order[k]] == keys[order[k - 1]];
    report_.duplicate_triangles += filter([&](std::size_t i) { return !repeated[i]; });
  }

  /// False if no triangle has a height.
  bool remove_flat() {
    const double height = flat_height * diagonal_;
    const auto has_height = [&](const Tri& t) {
      return !is_flat(soup_.points[t[0]], soup_.points[t[1]], soup_.points[t[2]], height);
    };
    if (std::none_of(soup_.triangles.begin(), soup_.triangles.end(), has_height)) return false;
    const FlatRemoval removal =
        remove_flat_triangles(soup_.points, height, soup_.triangles, soup_.group);
    report_.flat_triangles = removal.removed;
    report_.divided_triangles = removal.divided;
    report_.flat_left = removal.left;
    if (removal.removed > 0) drop_duplicates();
    return !soup_.triangles.empty();
  }

  Error nothing_left() const {
    return {ErrorCode::zero_area,
            "None of the surface's " + std::to_string(report_.triangles_given) +
                " triangles has an area.",
            {}};
  }

  RepairedSurface finish() {
    RepairedSurface result;
    number_points(result);
    result.mesh.triangles = std::move(soup_.triangles);
    result.mesh.group = std::move(soup_.group);
    result.group_names = std::move(soup_.group_names);
    result.body_names = std::move(soup_.body_names);
    const Orientation found = orient_surface(result.mesh);
    report_.turned_triangles = found.turned;
    report_.components = found.components;
    report_.border_edges = found.borders;
    report_.nonmanifold_edges = found.nonmanifold;
    report_.conflict_edges = found.conflicts;
    report_.nonmanifold_vertices = found.pinched_vertices;
    result.report = report_;
    return result;
  }

  void carry_sizes(RepairedSurface& result) const {
    if (soup_.sizes.empty()) return;
    result.sizes.assign(result.mesh.points.size(), 0);
    for (std::size_t p = 0; p < soup_.sizes.size(); ++p) {
      const Index v = result.vertex_of_point[p];
      if (v == none || !(soup_.sizes[p] > 0)) continue;
      double& size = result.sizes[v];
      size = size > 0 ? std::min(size, soup_.sizes[p]) : soup_.sizes[p];
    }
  }

  void number_points(RepairedSurface& result) {
    std::vector<Index>& number = result.vertex_of_point;
    number.assign(soup_.points.size(), none);
    for (const Tri& t : soup_.triangles)
      for (const Index v : t) number[v] = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (number[v] == none) continue;
      number[v] = result.mesh.vertex_count();
      result.mesh.points.push_back(soup_.points[v]);
      if (!body_.empty()) result.mesh.body.push_back(body_[v]);
    }
    for (Tri& t : soup_.triangles)
      for (Index& v : t) v = number[v];
    for (std::size_t v = 0; v < number.size(); ++v) number[v] = number[first_[v]];
    carry_sizes(result);
    number.resize(static_cast<std::size_t>(report_.points_given));
  }

  SurfaceSoup soup_;
  RepairOptions options_;
  std::vector<char> used_;    // #points
  std::vector<Index> first_;  // #points  what each is welded to
  std::vector<Index> body_;   // #points  empty: there is one
  double diagonal_ = 0;
  RepairReport report_;
};

}  // namespace

Result<RepairedSurface> repair_surface(SurfaceSoup soup, const RepairOptions& options) {
  return Repair(std::move(soup), options).run();
}

}  // namespace lpq
