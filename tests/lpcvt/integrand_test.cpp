// The integral over one sub-triangle: closed form against Gauss, against the second moment, and its
// derivatives against differences and Euler's identity.
#include "lpcvt/integrand.h"

#include <cmath>

#include "base/rng.h"
#include "catch.h"

namespace lpq {
namespace {

PieceBlock random_block(std::uint64_t seed) {
  PieceBlock block;
  Rng rng(seed);
  for (int i = 0; i < PieceBlock::capacity; ++i) {
    block.ux[i] = rng.between(-1, 1);
    block.uy[i] = rng.between(-1, 1);
    block.vx[i] = rng.between(-1, 1);
    block.vy[i] = rng.between(-1, 1);
  }
  return block;
}

double magnitude(const PieceBlock& block, int i) {
  return std::abs(block.dux[i]) + std::abs(block.duy[i]) + std::abs(block.dvx[i]) +
         std::abs(block.dvy[i]);
}

}  // namespace

TEST_CASE("closed form equals Gauss for every even p") {
  for (int p = 2; p <= 20; p += 2) {
    PieceBlock closed = random_block(3), gauss = random_block(3);
    integrate_closed_form(p, PieceBlock::capacity, closed);
    integrate_gauss(p, triangle_rule(gauss_degree(p)), PieceBlock::capacity, gauss);
    for (int i = 0; i < PieceBlock::capacity; ++i) {
      CHECK(closed.double_area[i] == gauss.double_area[i]);
      const double scale = magnitude(gauss, i);
      CHECK(std::abs(closed.energy[i] - gauss.energy[i]) <= 1e-12 * std::abs(gauss.energy[i]));
      CHECK(std::abs(closed.dux[i] - gauss.dux[i]) <= 1e-12 * scale);
      CHECK(std::abs(closed.duy[i] - gauss.duy[i]) <= 1e-12 * scale);
      CHECK(std::abs(closed.dvx[i] - gauss.dvx[i]) <= 1e-12 * scale);
      CHECK(std::abs(closed.dvy[i] - gauss.dvy[i]) <= 1e-12 * scale);
    }
  }
}

TEST_CASE("p = 2 is the second moment about the site") {
  PieceBlock block = random_block(8);
  integrate_closed_form(2, PieceBlock::capacity, block);
  for (int i = 0; i < PieceBlock::capacity; ++i) {
    const double ux = block.ux[i], uy = block.uy[i], vx = block.vx[i], vy = block.vy[i];
    const double moment =
        0.5 * (ux * vy - uy * vx) / 6 * (ux * ux + uy * uy + vx * vx + vy * vy + ux * vx + uy * vy);
    CHECK(std::abs(block.energy[i] - moment) <= 1e-14);
  }
}

TEST_CASE("an axis-parallel right triangle has a known energy") {
  // Triangle (0, (1,0), (1,1)): int x^p = 1/(p+2), int y^p = 1/((p+1)(p+2)).
  for (int p = 2; p <= 20; p += 2) {
    PieceBlock block;
    block.ux[0] = 1, block.uy[0] = 0, block.vx[0] = 1, block.vy[0] = 1;
    integrate_closed_form(p, 1, block);
    const double exact = 1.0 / (p + 2) + 1.0 / ((p + 1) * (p + 2));
    CHECK(std::abs(block.energy[0] / exact - 1) < 1e-14);
  }
}

TEST_CASE("derivatives obey Euler's identity of degree p + 2, for any real p") {
  for (const double p : {2.0, 2.5, 3.0, 5.0, 6.0, 7.3, 20.0}) {
    PieceBlock block = random_block(11);
    integrate_gauss(p, triangle_rule(gauss_degree(p)), PieceBlock::capacity, block);
    for (int i = 0; i < PieceBlock::capacity; ++i) {
      const double homogeneous = block.dux[i] * block.ux[i] + block.duy[i] * block.uy[i] +
                                 block.dvx[i] * block.vx[i] + block.dvy[i] * block.vy[i];
      CHECK(std::abs(homogeneous - (p + 2) * block.energy[i]) <= 1e-12 * magnitude(block, i));
    }
  }
}

TEST_CASE("for odd and broken p the rule's error is below what the optimiser can see") {
  for (const double p : {2.5, 3.0, 5.0, 7.3}) {
    PieceBlock usual = random_block(5), fine = random_block(5);
    integrate_gauss(p, triangle_rule(gauss_degree(p)), PieceBlock::capacity, usual);
    integrate_gauss(p, triangle_rule(120), PieceBlock::capacity, fine);
    for (int i = 0; i < PieceBlock::capacity; ++i)
      CHECK(std::abs(usual.energy[i] - fine.energy[i]) <= 1e-3 * std::abs(fine.energy[i]));
  }
}

}  // namespace lpq
