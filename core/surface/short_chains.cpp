#include "surface/short_chains.h"

#include <algorithm>

#include "base/disjoint_sets.h"

namespace lpq {
namespace {

/// Side branches: from a loose end to where three or more features meet.
class StubCutter {
 public:
  StubCutter(const SurfaceMesh& mesh, std::span<const double> size, double shortest,
             SurfaceFeatures& features)
      : mesh_(mesh),
        size_(size),
        shortest_(shortest),
        features_(features),
        at_(features.edges_at_vertices(mesh.vertex_count())) {}

  void run() {
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (valence(v) == 1) cut(v);
  }

 private:
  Index valence(Index v) const {
    const auto row = at_.row(v);
    return static_cast<Index>(
        std::count_if(row.begin(), row.end(), [this](Index i) { return features_.is_feature(i); }));
  }

  void cut(Index v) {
    std::vector<Index> stub;
    double sizes = 0;  // length in mesh sizes
    for (Index count = 1; count < 3;) {
      const Index edge = next_edge(v, stub);
      if (edge == none || features_.kind[edge] != FeatureKind::sharp) return;
      const Index w = features_.edges.other_end(edge, v);
      sizes += 2 * distance(mesh_.points[v], mesh_.points[w]) / (size_[v] + size_[w]);
      if (sizes >= shortest_) return;
      stub.push_back(edge);
      v = w;
      count = valence(v);
      if (count == 1) return;  // a chain by itself
    }
    for (const Index edge : stub) features_.kind[edge] = FeatureKind::smooth;
  }

  Index next_edge(Index v, const std::vector<Index>& stub) const {
    for (const Index i : at_.row(v))
      if (features_.is_feature(i) && (stub.empty() || stub.back() != i)) return i;
    return none;
  }

  const SurfaceMesh& mesh_;
  std::span<const double> size_;
  double shortest_;
  SurfaceFeatures& features_;
  Csr<Index> at_;  // edges that were features at the start
};

/// What is known of a connected heap of features.
struct Heap {
  Vec3 low, high;
  double sizes = 0;  // sum over its edge ends
  Index ends = 0;
  bool hard = false, loose = false, branched = false;
};

// Noise goes around a triangle or around a vertex and its six or so neighbours; a plain loop of
// more edges, however small, is the rim of a hole.
constexpr Index fewest_of_rim = 8;

class HeapFilter {
 public:
  HeapFilter(const SurfaceMesh& mesh, std::span<const double> size, const FeatureOptions& options,
             SurfaceFeatures& features)
      : mesh_(mesh),
        size_(size),
        options_(options),
        features_(features),
        sets_(mesh.vertex_count()),
        heaps_(mesh.points.size()) {}

  void run() {
    std::vector<Index> valence(mesh_.points.size(), 0);
    for_each_feature([&](Index i) {
      const auto& [a, b] = features_.edges.ends[i];
      sets_.unite(a, b);
      ++valence[a];
      ++valence[b];
    });
    for_each_feature([&](Index i) {
      for (const Index v : features_.edges.ends[i]) gather(v, features_.kind[i], valence[v]);
    });
    for_each_feature([&](Index i) {
      if (is_noise(heaps_[sets_.root(features_.edges.ends[i][0])]))
        features_.kind[i] = FeatureKind::smooth;
    });
  }

 private:
  template <class Visit>
  void for_each_feature(Visit&& visit) {
    for (Index i = 0; i < features_.edges.count(); ++i)
      if (features_.is_feature(i)) visit(i);
  }

  void gather(Index v, FeatureKind kind, Index valence) {
    Heap& heap = heaps_[sets_.root(v)];
    const Vec3 p = mesh_.points[v];
    if (heap.ends == 0) heap.low = heap.high = p;
    heap.low = {std::min(heap.low.x, p.x), std::min(heap.low.y, p.y), std::min(heap.low.z, p.z)};
    heap.high = {std::max(heap.high.x, p.x), std::max(heap.high.y, p.y),
                 std::max(heap.high.z, p.z)};
    heap.sizes += size_[v];
    ++heap.ends;
    heap.hard = heap.hard || kind > FeatureKind::sharp;
    heap.loose = heap.loose || valence == 1;
    heap.branched = heap.branched || valence > 2;
  }

  bool is_noise(const Heap& heap) const {
    if (heap.hard) return false;
    if (!heap.loose && !heap.branched && heap.ends >= 2 * fewest_of_rim) return false;
    const double shortest = heap.loose ? options_.shortest : options_.shortest_loop;
    return length(heap.high - heap.low) < shortest * heap.sizes / heap.ends;
  }

  const SurfaceMesh& mesh_;
  std::span<const double> size_;
  const FeatureOptions& options_;
  SurfaceFeatures& features_;
  DisjointSets sets_;
  std::vector<Heap> heaps_;  // #V  at the roots
};

}  // namespace

void drop_short_chains(const SurfaceMesh& mesh, std::span<const double> size,
                       const FeatureOptions& options, SurfaceFeatures& features) {
  StubCutter(mesh, size, options.shortest_stub, features).run();
  HeapFilter(mesh, size, options, features).run();
}

}  // namespace lpq
