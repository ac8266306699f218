// The two fields that steer the mesh, on one background triangulation: the cross field as
// z = e^{4 i theta} (paper section 4) and the size field h. Sampled everywhere by linear
// interpolation, with the gradients that the energy needs.
#pragma once

#include <vector>

#include "delaunay/locate.h"
#include "geometry/vec.h"
#include "mesh/tri_mesh.h"

namespace lpq {

struct FieldSample {
  Vec2 axis{1, 0};  // (cos theta, sin theta), unit; one of the four arms
  double h = 1;     // target edge length, unit frame
  Vec2 grad_theta;  // d theta / d x, capped at 1/h near singularities
  Vec2 grad_log_h;  // d log h / d x
};

/// Where lengths in the plane are not those that count: angles and sizes are measured of
/// stretched() differences, with mu linear in each triangle.
struct StretchSample {
  Vec2 mu, dx, dy;  // and its derivatives
};

struct Singularity {
  Vec2 position;
  int index = 0;  // in quarters: +1 = valence-3 vertex, -1 = valence-5 vertex
};

/// A vector as the symmetric matrix of determinant 1 that |mu| < 1 stands for makes it:
/// (v + mu conj v) / sqrt(1 - |mu|^2), longer by sqrt((1 + |mu|) / (1 - |mu|)) along one direction
/// and shorter by as much across. -mu undoes it.
inline Vec2 stretched(Vec2 v, Vec2 mu) {
  return (1 / std::sqrt(1 - squared_length(mu))) * (v + complex_product(mu, conjugate(v)));
}

/// Limit of |mu|. Up to sigma_1 / sigma_2 = 1 + sqrt 2 the Delaunay triangles of a square lattice,
/// stretched whichever way, are halves of its cells: |mu| = sqrt 2 - 1.
inline constexpr double most_stretch = 0.41;
/// What a vector may be before such a stretch, of length 1 after it, rounded up:
/// sqrt((1 + most_stretch) / (1 - most_stretch)).
inline constexpr double longest_unstretched = 1.55;
static_assert(longest_unstretched * longest_unstretched * (1 - most_stretch) > 1 + most_stretch);

struct Fields {
  TriMesh background;
  std::vector<Vec2> z;     // #V background  unit e^{4 i theta} (zero only where undefined)
  std::vector<double> h;   // #V background  target size, > 0
  std::vector<Vec2> pull;  // #V background  z where quads are to follow it, else 0; or empty
  /// #V background, or empty: Beltrami coefficient mu of the map from this plane to where the mesh
  /// is for, at most most_stretch; crosses and sizes are those after stretched(., mu).
  std::vector<Vec2> stretch;
  std::vector<Singularity> singularities;
  /// h is small at isolated points and grows steeply around them: what judges the mesh by averages
  /// is to look at every face there.
  bool has_spots = false;
  Locator locator;  // over `background`

  Fields() = default;
  Fields(const Fields& other);
  Fields(Fields&& other) noexcept;
  Fields& operator=(Fields other) noexcept;
  /// Prepares sampling; call after filling or changing background, z or h. Copies and moves need
  /// no call.
  void attach();

  /// `hint` remembers the triangle between calls for nearby points; a point outside the domain
  /// gets the values of the nearest triangle. Walks over few triangles when the hint is near.
  FieldSample sample(Vec2 p, Index& hint) const;
  /// Size only (cheaper).
  double size(Vec2 p, Index& hint) const;
  /// Of values at the vertices of the background; 0 if they are empty.
  Vec2 interpolate(const std::vector<Vec2>& values, Vec2 p, Index& hint) const;
  /// The interpolated pull: direction z, length 0 to 1.
  Vec2 pull_at(Vec2 p, Index& hint) const { return interpolate(pull, p, hint); }
  /// The interpolated stretch; 0 where fields have none.
  Vec2 stretch_at(Vec2 p, Index& hint) const { return interpolate(stretch, p, hint); }
  /// A vector at p stretched, and one of which it is the stretched one.
  Vec2 stretched_at(Vec2 p, Vec2 v, Index& hint) const {
    return stretch.empty() ? v : stretched(v, stretch_at(p, hint));
  }
  Vec2 unstretched_at(Vec2 p, Vec2 v, Index& hint) const {
    return stretch.empty() ? v : stretched(v, -stretch_at(p, hint));
  }
  /// What a vector of length 1 after the stretch may be in the plane.
  double longest_step() const { return stretch.empty() ? 1 : longest_unstretched; }
  StretchSample sample_stretch(Vec2 p, Index& hint) const;
  /// |grad h|, constant in each triangle of the background.
  double slope(Vec2 p, Index& hint) const;
  /// Triangle that contains p, reached from triangle `from` without crossing a wall; none when a
  /// wall is in the way. Never searches: the test "can y be seen from x" of the point packings.
  Index walk(Vec2 p, Index from) const;

 private:
  // Linear interpolation prepared per triangle, so that a sample is one cache-friendly read.
  struct Cell {
    Vec2 origin;              // corner 0
    Vec2 lambda_1, lambda_2;  // gradients of the barycentric coordinates of corners 1, 2
    Vec2 z, z_dx, z_dy;       // value at the origin and derivatives
    double h = 0;
    Vec2 h_gradient;
  };
  const Cell& cell_at(Vec2& p, Index& hint) const;
  Index step(Vec2 p, Index t) const;
  std::vector<Cell> cells_;  // #T background
};

/// Principal square root of a unit complex number: half its angle.
Vec2 unit_root(Vec2 z);
/// Unit (cos theta, sin theta) with theta in [-pi/4, pi/4] of z = e^{4 i theta}: two complex square
/// roots, no trigonometry. (1, 0) for z = 0.
Vec2 axis_of(Vec2 z);
/// e^{4 i theta} of a direction (any length > 0).
Vec2 cross_of(Vec2 direction);

/// Integral of dA / h^2 over the domain: the number of unit cells that fit.
double cell_capacity(const Fields& fields);

}  // namespace lpq
