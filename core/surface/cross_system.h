// The linear systems behind a surface's cross field, and their solution.
#pragma once

#include <complex>
#include <vector>

#include "base/index.h"
#include "numerics/sparse.h"

namespace lpq {

/// Unknown crosses, z = e^{4 i theta} each in a frame of its own: z* A z - 2 Re(rhs* z) is how much
/// they bend.
struct CrossSystem {
  std::vector<ComplexTriplet> stiffness;  // A, lower triangle
  std::vector<std::complex<double>> rhs;  // #rows  from crosses that are given
  std::vector<double> mass;               // #rows  area as a share of all
  std::vector<Index> free_component;      // #rows  none where the component has a given cross
  Index free_components = 0;

  Index rows() const { return static_cast<Index>(rhs.size()); }
};

/// By sparse factors: the minimum, or the smallest eigenvector of each free component; then
/// diffusion. Values of unit length, or 0 where A is not positive definite.
std::vector<std::complex<double>> solve_cross_system(const CrossSystem& system);

/// The same for systems of any size, in time proportional to it: of more than 60,000 rows,
/// neighbours are paired until few enough are left [JTPS15], the pairs solved for, and their
/// crosses turned into the frames of the rows and smoothed there. A holds nothing but bends.
std::vector<std::complex<double>> solve_large_cross_system(const CrossSystem& system);

inline double squared_norm(std::complex<double> z) {
  return z.real() * z.real() + z.imag() * z.imag();
}
/// z / |z|, 0 where that has no direction.
std::complex<double> unit_cross(std::complex<double> z);

}  // namespace lpq
