// Counts of edges changed a little, so that opposite sides of faces have the same.
#pragma once

#include <span>
#include <vector>

#include "surface/side_balance.h"

namespace lpq {

/// What is asked of a curve's count. `step` is 2 where it must stay even.
struct CountWish {
  double steps = 0;  // int ds/h
  Index fewest = 1, step = 1;
};

/// Lowers sum (n - steps)^2 / steps over curves plus a price for every edge by which a sum is off,
/// along chains of curves: what one face needs less its neighbour behind that curve gets to bear,
/// up to where the chain ends [HWB23 solve the same exactly, by flows]. Local; each chain
/// lowers the total. In the end every curve may go back towards its steps, where chains can make up
/// for it. Deterministic.
void balance_counts(const CountSums& sums, std::span<const CountWish> wishes,
                    std::vector<Index>& counts);

}  // namespace lpq
