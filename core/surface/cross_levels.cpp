// Large cross systems by levels of pairs: see cross_system.h.

#include "base/csr.h"
#include "surface/cross_system.h"

namespace lpq {
namespace {

using Complex = std::complex<double>;

constexpr Index most_rows = 60000;  // that are solved for at once
// Rows left of those there were; else pairing has come to an end.
constexpr double least_gain = 0.9;
constexpr int sweeps = 6;                          // on each level
constexpr double row_scale = 0.70710678118654752;  // of lengths, when areas become twice as large

struct Coupling {
  Index row = none;
  Complex value;  // of A
};

/// Whole rows of A, without the diagonal.
struct Rows {
  Csr<Coupling> couplings;
  std::vector<double> diagonal;
};

/// Rows that became one: z = turn * (z of the pair).
struct Pairing {
  std::vector<Index> pair;    // #rows
  std::vector<Complex> turn;  // #rows  of unit length
  Index pairs = 0;
};

Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

Rows rows_of(const CrossSystem& system) {
  Rows rows;
  rows.diagonal.assign(system.rows(), 0.0);
  for (const auto& [i, j, value] : system.stiffness)
    if (i == j) rows.diagonal[i] += value.real();
  fill_csr(rows.couplings, system.rows(), [&](auto&& emit) {
    for (const auto& [i, j, value] : system.stiffness) {
      if (i == j) continue;
      emit(i, Coupling{j, value});
      emit(j, Coupling{i, std::conj(value)});
    }
  });
  return rows;
}

/// Each row with the one that it hangs on most, of those that have no partner.
Pairing pair_up(const Rows& rows) {
  Pairing pairing;
  const Index count = rows.couplings.rows();
  pairing.pair.assign(count, none);
  pairing.turn.assign(count, {1, 0});
  for (Index i = 0; i < count; ++i) {
    if (pairing.pair[i] != none) continue;
    const Coupling* best = nullptr;
    for (const Coupling& coupling : rows.couplings.row(i))
      if (pairing.pair[coupling.row] == none &&
          (best == nullptr || squared_norm(coupling.value) > squared_norm(best->value)))
        best = &coupling;
    pairing.pair[i] = pairing.pairs++;
    if (best == nullptr) continue;
    pairing.pair[best->row] = pairing.pair[i];
    // A z is 0 where z = -value * (z of the partner), but for the length.
    const Complex turn = unit_cross(-std::conj(best->value));
    if (squared_norm(turn) > 0) pairing.turn[best->row] = turn;
  }
  return pairing;
}

/// All but the stiffness.
CrossSystem merged_rows(const CrossSystem& system, const Pairing& pairing) {
  CrossSystem pairs;
  pairs.rhs.assign(pairing.pairs, {});
  pairs.mass.assign(pairing.pairs, 0.0);
  pairs.free_component.assign(pairing.pairs, none);
  pairs.free_components = system.free_components;
  for (Index i = 0; i < system.rows(); ++i) {
    const Index p = pairing.pair[i];
    pairs.mass[p] += system.mass[i];
    pairs.rhs[p] += row_scale * product(std::conj(pairing.turn[i]), system.rhs[i]);
    pairs.free_component[p] = system.free_component[i];
  }
  return pairs;
}

/// The system of the pairs: P* A P, where P is what the pairing says. Crosses that are constant on
/// pairs bend at fewer edges, but by more: in the plane too much by the ratio of lengths.
CrossSystem merged(const CrossSystem& system, const Rows& rows, const Pairing& pairing) {
  CrossSystem pairs = merged_rows(system, pairing);
  const Csr<Index> members = members_of(pairing.pair, pairing.pairs);
  std::vector<Index> place(pairing.pairs, none);  // of the coupling to this pair, of the row's
  for (Index p = 0; p < pairing.pairs; ++p) {
    const std::size_t first = pairs.stiffness.size();
    double diagonal = 0;
    for (const Index i : members.row(p)) diagonal += rows.diagonal[i];
    for (const Index i : members.row(p))
      for (const auto& [j, value] : rows.couplings.row(i)) {
        const Index q = pairing.pair[j];
        const Complex turned = product(product(std::conj(pairing.turn[i]), value), pairing.turn[j]);
        if (q == p) diagonal += turned.real();
        if (q >= p) continue;
        if (place[q] == none) {
          place[q] = static_cast<Index>(pairs.stiffness.size());
          pairs.stiffness.push_back({p, q, {}});
        }
        pairs.stiffness[place[q]].value += row_scale * turned;
      }
    for (std::size_t k = first; k < pairs.stiffness.size(); ++k)
      place[pairs.stiffness[k].column] = none;
    pairs.stiffness.push_back({p, p, row_scale * diagonal});
  }
  return pairs;
}

/// Row after row, the cross that bends least beside its neighbours.
void smooth(const CrossSystem& system, const Rows& rows, std::vector<Complex>& x) {
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (Index i = 0; i < system.rows(); ++i) {
      Complex sum = system.rhs[i];
      for (const auto& [j, value] : rows.couplings.row(i)) sum -= product(value, x[j]);
      if (squared_norm(sum) > 0) x[i] = unit_cross(sum);
    }
}

}  // namespace

std::vector<Complex> solve_large_cross_system(const CrossSystem& system) {
  if (system.rows() <= most_rows) return solve_cross_system(system);
  const Rows rows = rows_of(system);
  const Pairing pairing = pair_up(rows);
  if (pairing.pairs > least_gain * system.rows()) return solve_cross_system(system);
  const std::vector<Complex> z = solve_large_cross_system(merged(system, rows, pairing));
  std::vector<Complex> x;
  x.reserve(system.rhs.size());
  for (Index i = 0; i < system.rows(); ++i)
    x.push_back(product(pairing.turn[i], z[pairing.pair[i]]));
  smooth(system, rows, x);
  return x;
}

}  // namespace lpq
