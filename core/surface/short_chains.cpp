#include "surface/short_chains.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "base/disjoint_sets.h"
#include "geometry/box.h"
#include "surface/sharp_chains.h"

namespace lpq {
namespace {

/// One chain after the other, the shortest first: two that are left at a junction are one longer
/// chain.
class ChainFilter {
 public:
  ChainFilter(const SurfaceMesh& mesh, std::span<const double> size, std::span<const double> angles,
              const FeatureOptions& options, SurfaceFeatures& features)
      : mesh_(mesh),
        size_(size),
        options_(options),
        features_(features),
        chains_(mesh, angles, options.angle, features),
        length_at_first_(features.kind.size(), 0) {}

  void run() {
    std::vector<char> seen(features_.kind.size());
    for (Index i = 0; i < features_.edges.count(); ++i) {
      if (seen[i] || features_.kind[i] != FeatureKind::sharp) continue;
      const SharpChain chain = chains_.through(i);
      const double length = sizes(chain);
      for (const Index edge : chain.edges) {
        seen[edge] = 1;
        length_at_first_[edge] = length;
      }
      queue_.push({length, i});
    }
    while (!queue_.empty()) {
      const auto [length, edge] = queue_.top();
      queue_.pop();
      if (features_.kind[edge] == FeatureKind::sharp) judge(length, edge);
    }
  }

 private:
  void judge(double length, Index edge) {
    SharpChain chain = chains_.through(edge);
    const double now = sizes(chain);
    if (now > length) {
      queue_.push({now, edge});
      return;
    }
    if (length >= options_.shortest_stub || !is_stub(chain)) keep_sound(chain);
    if (chain.edges.empty()) return;
    chains_.remove(chain);
    for (const Index v : {chain.vertices.front(), chain.vertices.back()}) ask(v);
  }

  /// Takes off its edges those that stay. Noise joins up where its side branches are gone: of a
  /// rough chain only what was long enough before.
  void keep_sound(SharpChain& chain) const {
    const bool sound = !chains_.is_rough(chain, false) || chains_.has_flat_side(chain);
    std::erase_if(chain.edges,
                  [&](Index i) { return sound || length_at_first_[i] >= options_.shortest; });
  }

  /// What has become a loose end.
  void ask(Index v) {
    if (chains_.valence(v) != 1) return;
    const Index edge = chains_.feature_at(v);
    if (features_.kind[edge] == FeatureKind::sharp)
      queue_.push({sizes(chains_.through(edge)), edge});
  }

  /// A side branch: from a loose end to where three or more features meet.
  bool is_stub(const SharpChain& chain) const {
    const Index a = chains_.valence(chain.vertices.front());
    const Index b = chains_.valence(chain.vertices.back());
    return std::min(a, b) == 1 && std::max(a, b) > 2;
  }

  /// Length in mesh sizes.
  double sizes(const SharpChain& chain) const {
    double sum = 0;
    for (const Index edge : chain.edges) {
      const auto& [a, b] = features_.edges.ends[edge];
      sum += 2 * distance(mesh_.points[a], mesh_.points[b]) / (size_[a] + size_[b]);
    }
    return sum;
  }

  using Entry = std::pair<double, Index>;  // length in mesh sizes, an edge of the chain

  const SurfaceMesh& mesh_;
  std::span<const double> size_;
  const FeatureOptions& options_;
  SurfaceFeatures& features_;
  SharpChains chains_;
  std::vector<double> length_at_first_;  // #E  in mesh sizes, of the chain that it was on
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

/// What is known of a connected heap of features.
struct Heap {
  Box3 box;
  double sizes = 0;   // sum over its edge ends
  double length = 0;  // twice
  Index ends = 0;
  Index beside_flat = 0;  // edges on chains with a flat side
  Unevenness around;
  bool hard = false, loose = false, branched = false;
};

// Noise goes around a triangle or around a vertex and its six or so neighbours; a plain loop of
// more edges, however small, is the rim of a hole, and so are more edges beside flat sides.
constexpr Index fewest_of_rim = 8;
// Of the bend: how uneven the faces may be in which smaller things stay, such as square holes.
constexpr double uneven = 0.02;

class HeapFilter {
 public:
  HeapFilter(const SurfaceMesh& mesh, std::span<const double> size, std::span<const double> angles,
             const FeatureOptions& options, SurfaceFeatures& features)
      : mesh_(mesh),
        size_(size),
        angles_(angles),
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
      for (const Index v : features_.edges.ends[i]) gather(v, i, valence[v]);
    });
    look_beside(valence);
    look_for_flat_sides();
    for_each_feature([&](Index i) {
      if (is_noise(heap_of(i))) features_.kind[i] = FeatureKind::smooth;
    });
  }

 private:
  template <class Visit>
  void for_each_feature(Visit&& visit) {
    for (Index i = 0; i < features_.edges.count(); ++i)
      if (features_.is_feature(i)) visit(i);
  }

  Heap& heap_of(Index edge) { return heaps_[sets_.root(features_.edges.ends[edge][0])]; }

  void gather(Index v, Index edge, Index valence) {
    Heap& heap = heaps_[sets_.root(v)];
    const Vec3 p = mesh_.points[v];
    extend(heap.box, p);
    heap.sizes += size_[v];
    ++heap.ends;
    const auto& [a, b] = features_.edges.ends[edge];
    heap.length += distance(mesh_.points[a], mesh_.points[b]);
    heap.around.bend += angles_[edge];
    ++heap.around.on;
    heap.hard = heap.hard || features_.kind[edge] > FeatureKind::sharp;
    heap.loose = heap.loose || valence == 1;
    heap.branched = heap.branched || valence > 2;
  }

  void look_beside(const std::vector<Index>& valence) {
    for (Index i = 0; i < features_.edges.count(); ++i)
      for (const Index v : features_.edges.ends[i]) {
        if (valence[v] == 0 || features_.is_feature(i) || angles_[i] > options_.angle) continue;
        Unevenness& around = heaps_[sets_.root(v)].around;
        around.squares += angles_[i] * angles_[i];
        ++around.beside;
      }
  }

  /// Of those that are noise but for that.
  void look_for_flat_sides() {
    const SharpChains chains(mesh_, angles_, options_.angle, features_);
    std::vector<char> seen(features_.kind.size());
    for_each_feature([&](Index i) {
      Heap& heap = heap_of(i);
      if (seen[i] || !is_noise(heap)) return;
      const SharpChain chain = chains.through(i);
      for (const Index edge : chain.edges) seen[edge] = 1;
      if (chains.has_flat_side(chain)) heap.beside_flat += static_cast<Index>(chain.edges.size());
    });
  }

  static bool has_rim(const Heap& heap) {
    if (heap.branched) return heap.beside_flat >= fewest_of_rim;
    if (heap.loose) return false;
    return heap.beside_flat > 0 || heap.ends >= 2 * fewest_of_rim;
  }

  bool is_noise(const Heap& heap) const {
    if (heap.hard || has_rim(heap)) return false;
    const double size = heap.sizes / heap.ends;
    if (heap.loose) return 0.5 * heap.length < options_.shortest * size;
    return heap.around.is_beyond(uneven) && diagonal(heap.box) < options_.shortest_loop * size;
  }

  const SurfaceMesh& mesh_;
  std::span<const double> size_, angles_;
  const FeatureOptions& options_;
  SurfaceFeatures& features_;
  DisjointSets sets_;
  std::vector<Heap> heaps_;  // #V  at the roots
};

}  // namespace

void drop_short_chains(const SurfaceMesh& mesh, std::span<const double> size,
                       std::span<const double> angles, const FeatureOptions& options,
                       SurfaceFeatures& features) {
  ChainFilter(mesh, size, angles, options, features).run();
}

void drop_small_heaps(const SurfaceMesh& mesh, std::span<const double> size,
                      std::span<const double> angles, const FeatureOptions& options,
                      SurfaceFeatures& features) {
  HeapFilter(mesh, size, angles, options, features).run();
}

}  // namespace lpq
