// See multigrid.h. Values that are constant on groups make the coarse systems too stiff;
// corrections are made larger instead [Br95].
#include "numerics/multigrid.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "numerics/sparse.h"

namespace lpq {
namespace {

constexpr Index most_rows = 400;  // that are solved for at once
// Rows left of those there were: with more, grouping has come to an end.
constexpr double most_left = 0.8;
constexpr double correction = 1.8;  // factor, for groups of four in the plane
constexpr double strong = 0.25;     // of a row's largest coupling
constexpr int group_size = 4;
constexpr int most_iterations = 40;

struct Level {
  SparseRows a;
  std::vector<Index> group;  // #rows  row of the next level; none on the last
  std::vector<double> x, b;  // #rows  in the cycle
};

/// Of those rows that satisfy `free`, the one that i hangs on most.
template <class Free>
Index strongest(const SparseRows& a, Index i, double least, Free&& free) {
  Index best = none;
  double most = least;
  for (const auto& [j, value] : a.couplings.row(i))
    if (-value > most && free(j)) most = -value, best = j;
  return best;
}

/// Rows with the ones that they hang on most, as far as these are free; what finds none free joins.
std::vector<Index> groups_of(const SparseRows& a, Index& count) {
  std::vector<Index> group(a.diagonal.size(), none);
  const auto is_free = [&](Index j) { return group[j] == none; };
  const auto any = [](Index) { return true; };
  count = 0;
  for (Index i = 0; i < a.count(); ++i) {
    if (!is_free(i)) continue;
    const Index most = strongest(a, i, 0, any);
    double least = 0;
    for (const auto& [j, value] : a.couplings.row(i))
      if (j == most) least = std::max(least, -strong * value);
    group[i] = count;
    int members = 1;
    for (; members < group_size; ++members) {
      const Index next = strongest(a, i, least, is_free);
      if (next == none) break;
      group[next] = count;
    }
    if (members == 1 && most != none && group[most] != count)
      group[i] = group[most];
    else
      ++count;
  }
  return group;
}

/// P^T A P, with P constant on groups.
SparseRows grouped(const SparseRows& a, const std::vector<Index>& group, Index count) {
  SparseRows result;
  const Csr<Index> members = members_of(group, count);
  std::vector<Index> place(count, none);  // of the coupling to this group, of the row's
  for (Index g = 0; g < count; ++g) {
    double diagonal = 0;
    const auto first = static_cast<Index>(result.couplings.values.size());
    for (const Index i : members.row(g)) {
      diagonal += a.diagonal[i];
      for (const auto& [j, value] : a.couplings.row(i)) {
        const Index h = group[j];
        if (h == g) {
          diagonal += value;
        } else if (place[h] != none && place[h] >= first) {
          result.couplings.values[place[h]].value += value;
        } else {
          place[h] = static_cast<Index>(result.couplings.values.size());
          result.couplings.values.push_back({h, value});
        }
      }
    }
    result.couplings.end_row();
    result.diagonal.push_back(diagonal);
  }
  return result;
}

double row_times(const SparseRows& a, Index i, const std::vector<double>& x) {
  double sum = 0;
  for (const auto& [j, value] : a.couplings.row(i)) sum += value * x[j];
  return sum;
}

double product(const std::vector<double>& p, const std::vector<double>& q) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += p[i] * q[i];
  return sum;
}

class Cycle {
 public:
  explicit Cycle(SparseRows a);
  bool usable() const { return factor_ && factor_->status() == SparseStatus::ok; }
  const SparseRows& matrix() const { return levels_[0].a; }
  /// z: nearly A^-1 r.
  void apply(const std::vector<double>& r, std::vector<double>& z);

 private:
  void run(std::size_t level);
  void relax(Level& level, Index i) const {
    level.x[i] = (level.b[i] - row_times(level.a, i, level.x)) / level.a.diagonal[i];
  }

  std::vector<Level> levels_;
  std::optional<SparseFactor<double>> factor_;  // of the last
};

Cycle::Cycle(SparseRows a) {
  levels_.push_back({std::move(a), {}, {}, {}});
  while (levels_.back().a.count() > most_rows) {
    Level& last = levels_.back();
    Index count = 0;
    last.group = groups_of(last.a, count);
    if (count > most_left * last.a.count()) return;
    SparseRows next = grouped(last.a, last.group, count);
    levels_.push_back({std::move(next), {}, {}, {}});
  }
  for (Level& level : levels_) level.x.resize(level.a.diagonal.size()), level.b = level.x;
  std::vector<Triplet> entries;
  const SparseRows& last = levels_.back().a;
  for (Index i = 0; i < last.count(); ++i) {
    entries.push_back({i, i, last.diagonal[i]});
    for (const auto& [j, value] : last.couplings.row(i))
      if (j < i) entries.push_back({i, j, value});
  }
  factor_.emplace(last.count(), entries);
}

/// x of the level from its b. Forwards before, backwards after, so that all is symmetric.
void Cycle::run(std::size_t level) {
  Level& here = levels_[level];
  if (level + 1 == levels_.size()) return factor_->solve(here.b, here.x);
  Level& next = levels_[level + 1];
  here.x.assign(here.x.size(), 0.0);
  next.b.assign(next.b.size(), 0.0);
  for (Index i = 0; i < here.a.count(); ++i) relax(here, i);
  for (Index i = 0; i < here.a.count(); ++i)
    next.b[here.group[i]] +=
        here.b[i] - here.a.diagonal[i] * here.x[i] - row_times(here.a, i, here.x);
  run(level + 1);
  for (Index i = 0; i < here.a.count(); ++i) here.x[i] += correction * next.x[here.group[i]];
  for (Index i = here.a.count(); i-- > 0;) relax(here, i);
}

void Cycle::apply(const std::vector<double>& r, std::vector<double>& z) {
  levels_[0].b = r;
  run(0);
  z = levels_[0].x;
}

}  // namespace

bool solve_nearly(SparseRows a, std::span<const double> b, double tolerance,
                  std::vector<double>& x) {
  for (const double d : a.diagonal)
    if (!(d > 0)) return false;
  Cycle cycle(std::move(a));
  if (!cycle.usable()) return false;
  const SparseRows& matrix = cycle.matrix();
  x.assign(b.size(), 0.0);
  std::vector<double> r(b.begin(), b.end()), z, p, ap(b.size());
  cycle.apply(r, z);
  double rz = product(r, z);
  if (rz == 0) return true;
  const double small = tolerance * tolerance * rz;
  p = z;
  for (int i = 0; i < most_iterations && rz > 0; ++i) {
    for (Index k = 0; k < matrix.count(); ++k)
      ap[k] = matrix.diagonal[k] * p[k] + row_times(matrix, k, p);
    const double step = rz / product(p, ap);
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += step * p[k], r[k] -= step * ap[k];
    cycle.apply(r, z);
    const double before = std::exchange(rz, product(r, z));
    if (rz >= 0 && rz <= small) return true;
    for (std::size_t k = 0; k < x.size(); ++k) p[k] = z[k] + rz / before * p[k];
  }
  return false;
}

}  // namespace lpq
