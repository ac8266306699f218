// Chains of sharp edges, and whether they stand out from the surface around them.
#pragma once

#include <span>
#include <vector>

#include "surface/features.h"

namespace lpq {

/// From where other than two sharp edges meet to the next such place.
struct SharpChain {
  std::vector<Index> edges;
  std::vector<Index> vertices;  // along it, one more than edges; a closed one ends with its first

  bool is_closed() const { return vertices.front() == vertices.back(); }
};

/// A crease bends much more than the surface beside it. Where that is about as uneven, sharp edges
/// are what noise leaves above the angle.
struct Unevenness {
  double bend = 0, squares = 0;  // sums: degrees on the crease, their squares on edges beside it
  double on = 0, beside = 0;     // numbers of edges

  /// `most`: of the bend of the crease, the mean (root of squares) beside it.
  bool is_beyond(double most) const;
};

class SharpChains {
 public:
  /// `angles` in degrees between the normals at every edge, see edge_angles.
  SharpChains(const SurfaceMesh& mesh, std::span<const double> angles, double sharp_angle,
              SurfaceFeatures& features);

  /// The chain that an edge of kind sharp is on. Where there was a junction at the start the two
  /// that are left are one chain if they go straight on. Cost O(its length).
  SharpChain through(Index edge) const;
  /// Makes its edges smooth.
  void remove(const SharpChain& chain);
  /// Features at the vertex.
  Index valence(Index v) const { return valence_[v]; }
  /// Any feature there, or none.
  Index feature_at(Index v) const;

  /// A chain that may fade is not judged by the edges straight ahead of its ends.
  bool is_rough(const SharpChain& chain, bool may_fade) const;
  /// Whether one side of it is flat as far as one sees from there, as beside the rims of holes
  /// whose walls are coarse facets. Noise is on both sides, or is one vertex that the chain goes
  /// around. Cost O(n log n) for n edges.
  bool has_flat_side(const SharpChain& chain) const;

 private:
  void walk(SharpChain& chain) const;
  bool goes_on(Index edge, Index v, Index next) const;
  bool is_ahead(const SharpChain& chain, std::size_t k, Index edge) const;
  std::vector<Index> triangles_beside(const SharpChain& chain, bool left) const;
  bool is_around_vertex(const SharpChain& chain, bool left) const;
  bool is_flat_from(std::vector<Index> triangles, Unevenness around) const;

  const SurfaceMesh& mesh_;
  const SurfaceEdges& edges_;
  const std::vector<Vec3>& points_;
  std::span<const double> angles_;
  double sharp_angle_;
  SurfaceFeatures& features_;
  Csr<Index> at_;                     // #V  all edges
  std::vector<Index> valence_;        // #V  features now
  std::vector<Index> sharp_valence_;  // #V  of kind sharp
  std::vector<char> was_junction_;    // #V
};

}  // namespace lpq
