#include "domain/edge_pairs.h"

#include <utility>

#include "base/sort_numbers.h"
#include "domain/directions.h"

namespace lpq {
namespace {

// Pairs among this many edges cost no more than sorting them does; in triangulations given as
// regions a vertex has about 12.
constexpr Index busy = 32;

}  // namespace

EdgePairs::EdgePairs(std::span<const Vec2> points, std::vector<Ends> edges)
    : edges_(std::move(edges)) {
  std::vector<Index> degree(points.size(), 0);
  for (const Ends& e : edges_)
    for (const Index v : e) ++degree[v];
  build_tree(points, degree);
  find_bundles(points, degree);
}

void EdgePairs::build_tree(std::span<const Vec2> points, std::span<const Index> degree) {
  std::vector<Index> hub;
  boxes_.reserve(edges_.size());
  hub.reserve(edges_.size());
  for (const auto& [a, b] : edges_) {
    boxes_.push_back(box_of(points[a], points[b]));
    const Index busier = degree[a] < degree[b] ? b : a;
    hub.push_back(degree[busier] > busy ? busier : none);
  }
  tree_ = BoxTree(boxes_, hub);
  hub_ = tree_.summarise<Index>(hub, [](Index v, Index w) { return v == w ? v : none; });
}

void EdgePairs::find_bundles(std::span<const Vec2> points, std::span<const Index> degree) {
  const auto count = static_cast<Index>(2 * edges_.size());
  const auto far = [&](Index end) { return points[edges_[end / 2][1 - end % 2]]; };
  Csr<Index> fans = csr_from<Index>(points.size(), [&](auto&& emit) {
    for (Index end = 0; end < count; ++end) {
      const Index v = edges_[end / 2][end % 2];
      // Points that rounding has made one have no direction.
      if (degree[v] > busy && !(far(end) == points[v])) emit(v, end);
    }
  });
  bundle_.assign(count, none);
  for (Index v = 0; v < fans.rows(); ++v) {
    const Counterclockwise before{points[v]};
    const std::span<Index> fan = fans.row(v);
    sort_numbers(fan, [&](Index g, Index h) {
      const bool first = before(far(g), far(h));
      return first != before(far(h), far(g)) ? first : g < h;
    });
    for (std::size_t i = 0, j = 0; i < fan.size(); i = j) {
      while (j < fan.size() && !before(far(fan[i]), far(fan[j]))) ++j;
      if (j - i < 2) continue;
      for (const Index end : fan.subspan(i, j - i)) {
        bundle_[end] = bundles_.rows();
        bundles_.values.push_back(end / 2);
      }
      bundles_.end_row();
    }
  }
}

void EdgePairs::each_near(Index e, FunctionRef<void(Index)> visit, double reach) const {
  const auto [a, b] = edges_[e];
  tree_.walk(
      [&, a = a, b = b](Index node, const Box& box) {
        const Index hub = hub_[node];
        return squared_distance(box, boxes_[e]) <= reach * reach &&
               (hub == none || (hub != a && hub != b));
      },
      visit);
  for (const Index bundle : {bundle_[2 * e], bundle_[2 * e + 1]})
    if (bundle != none)
      for (const Index f : bundles_.row(bundle)) visit(f);
}

}  // namespace lpq
