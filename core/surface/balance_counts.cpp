#include "surface/balance_counts.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>

#include "base/sort_numbers.h"

namespace lpq {
namespace {

// An edge by which opposite sides differ costs a pair of irregular vertices.
constexpr double price_of_edge = 0.3;
// In a narrow ring there is no room for them.
constexpr double price_in_ring = 0.9;
// An odd sum cannot stay: it will be made even at the expense of some curve. At first it may, so
// that two curves get one edge more each rather than one of them two.
constexpr double price_of_odd = 2, price_at_first = 0.2;
constexpr double least_gain = 1e-9;
// Less is not worth other counts in other faces.
constexpr double least_of_shift = 0.03;
constexpr int most_passes = 10;
constexpr double infinite = std::numeric_limits<double>::infinity();

double misfit(const CountWish& wish, Index count) {
  const double off = static_cast<double>(count) - wish.steps;
  return off * off / std::max(wish.steps, 0.5);
}

/// Chains of changes by `unit` edges each that start where a sum is off.
class Balancer {
 public:
  Balancer(const CountSums& sums, std::span<const CountWish> wishes, std::vector<Index>& counts)
      : sums_(sums), wishes_(wishes), counts_(counts), value_(sums.constant) {
    struct Entry {
      Index curve, sum, factor;
    };
    std::vector<Entry> entries;
    for (Index s = 0; s < sums.terms.rows(); ++s)
      for (const CountTerm& term : sums.terms.row(s)) {
        value_[s] += term.factor * counts[term.curve];
        entries.push_back({term.curve, s, term.factor});
      }
    sort_values(entries, [](const Entry& a, const Entry& b) {
      return a.curve != b.curve ? a.curve < b.curve : a.sum < b.sum;
    });
    std::size_t next = 0;
    for (Index c = 0; c < static_cast<Index>(counts.size()); ++c) {
      for (; next < entries.size() && entries[next].curve == c; ++next)
        sums_of_.values.push_back({entries[next].sum, entries[next].factor});
      sums_of_.end_row();
    }
    best_.resize(2 * value_.size());
  }

  void run() {
    run(1, price_at_first);
    run(2, price_of_odd);
    run(1, price_of_odd);
    return_to_wishes();
  }

 private:
  void run(Index unit, double price) {
    unit_ = unit;
    price_of_odd_ = price;
    for (bool changed = true; changed;) {
      changed = false;
      for (Index s = 0; s < static_cast<Index>(value_.size()); ++s)
        while (off(s) >= unit && improve(s)) changed = true;
    }
  }

  /// A chain may have gone the only way there was then, and be in the way of nothing now.
  void return_to_wishes() {
    bool changed = true;
    for (int pass = 0; changed && pass < most_passes; ++pass) {
      changed = false;
      for (Index c = 0; c < static_cast<Index>(counts_.size()); ++c)
        for (const Index unit : {1, 2})
          while (shift(c, unit)) changed = true;
    }
  }

  /// Brings a count nearer to its wish, and by chains those that must follow it. Only if the total
  /// falls.
  bool shift(Index curve, Index unit) {
    const CountWish& wish = wishes_[curve];
    const Index change = counts_[curve] < wish.steps ? unit : -unit;
    if (!is_possible(curve, change)) return false;
    if (!(misfit(wish, counts_[curve] + change) < misfit(wish, counts_[curve]))) return false;
    unit_ = unit;
    held_ = curve;
    done_.clear();
    double total = changed(curve, change);
    done_.push_back({curve, change});
    for (const SumOf& of : sums_of_.row(curve))
      while (off(of.sum) >= unit && improve(of.sum)) total -= gain_;
    held_ = none;
    if (total < -least_of_shift) return true;
    undo(done_);
    return false;
  }

  struct SumOf {
    Index sum, factor;
  };
  struct Change {
    Index curve, by;
  };
  /// A chain has arrived at a sum that must fall (or rise) by the unit, over `curve` from `before`.
  struct Reached {
    double cost = infinite;
    Index curve = none, change = 0, before = none;
    bool settled = false;
  };
  struct Ahead {
    double cost;
    Index state;
    bool operator>(const Ahead& other) const {
      return cost != other.cost ? cost > other.cost : state > other.state;
    }
  };

  Index off(Index s) const { return off(s, value_[s]); }
  Index off(Index s, Index value) const {
    value = std::abs(value);
    return sums_.only_parity[s] ? value % 2 : value;
  }
  double price(Index s, Index value) const {
    const Index by = off(s, value);
    const double each = sums_.only_parity[s]   ? 0
                        : sums_.across_ring[s] ? price_in_ring
                                               : price_of_edge;
    return each * by + price_of_odd_ * (by % 2);
  }

  static Index state_of(Index sum, Index excess) { return 2 * sum + (excess > 0); }

  bool improve(Index s) {
    const Index start = state_of(s, value_[s]);
    const double gain =
        price(s, value_[s]) - price(s, value_[s] > 0 ? value_[s] - unit_ : value_[s] + unit_);
    find_chains(start, gain + (price_in_ring + price_of_odd_) * unit_);
    const bool found = end_.curve != none && apply();
    for (const Index state : touched_) best_[state] = {};
    touched_.clear();
    return found;
  }

  void find_chains(Index start, double limit) {
    end_ = {};
    std::priority_queue<Ahead, std::vector<Ahead>, std::greater<>> ahead;
    reach(start, {0, none, 0, none}, ahead);
    while (!ahead.empty()) {
      const auto [cost, state] = ahead.top();
      ahead.pop();
      // An end may earn back what its own sum cost.
      if (cost - (price_in_ring + price_of_odd_) * unit_ >= end_.cost || cost > limit) return;
      if (best_[state].settled) continue;
      best_[state].settled = true;
      leave(state, ahead);
    }
  }

  /// Every change that takes the unit off the state's sum.
  template <class Queue>
  void leave(Index state, Queue& ahead) {
    const bool any = sums_.only_parity[state / 2];
    const Index wanted = state % 2 == 1 ? -unit_ : unit_;
    for (const CountTerm& term : sums_.terms.row(state / 2)) {
      if (std::abs(term.factor) != 1) continue;
      cross_curve(state, term.curve, term.factor * wanted, ahead);
      if (any) cross_curve(state, term.curve, -term.factor * wanted, ahead);
    }
  }

  template <class Queue>
  void reach(Index state, const Reached& reached, Queue& ahead) {
    if (!(reached.cost < best_[state].cost)) return;
    best_[state] = reached;
    touched_.push_back(state);
    ahead.push({reached.cost, state});
  }

  template <class Queue>
  void cross_curve(Index state, Index curve, Index change, Queue& ahead) {
    if (curve == held_ || !is_possible(curve, change)) return;
    const CountWish& wish = wishes_[curve];
    const double more = misfit(wish, counts_[curve] + change) - misfit(wish, counts_[curve]);
    Reached reached{best_[state].cost + std::max(0.0, more), curve, change, state};
    const SumOf* other = nullptr;
    for (const SumOf& of : sums_of_.row(curve)) {
      if (of.sum == state / 2) continue;
      if (other != nullptr) return;  // where three faces meet
      other = &of;
    }
    if (other != nullptr) {
      const Index value = value_[other->sum] + other->factor * change;
      const Index was = off(other->sum);
      if (std::abs(other->factor) != 1) return;
      if (off(other->sum, value) > was) {
        reach(state_of(other->sum, other->factor * change), reached, ahead);
        return;
      }
      reached.cost += price(other->sum, value) - price(other->sum, value_[other->sum]);
    }
    if (reached.cost < end_.cost) end_ = reached;
  }

  /// Keeps the chain if it lowers the total indeed: it may have used a curve twice.
  bool apply() {
    double total = 0;
    bool possible = true;
    std::vector<Change> chain;
    for (Reached at = end_; at.curve != none; at = best_[at.before]) {
      total += changed(at.curve, at.change);
      possible = possible && counts_[at.curve] >= wishes_[at.curve].fewest;
      chain.push_back({at.curve, at.change});
    }
    if (possible && total < -least_gain) {
      gain_ = -total;
      done_.insert(done_.end(), chain.begin(), chain.end());
      return true;
    }
    undo(chain);
    return false;
  }

  void undo(std::span<const Change> changes) {
    for (const Change& change : changes) changed(change.curve, -change.by);
  }

  bool is_possible(Index curve, Index change) const {
    const CountWish& wish = wishes_[curve];
    return counts_[curve] + change >= wish.fewest && change % wish.step == 0;
  }

  double changed(Index curve, Index change) {
    const CountWish& wish = wishes_[curve];
    double total = misfit(wish, counts_[curve] + change) - misfit(wish, counts_[curve]);
    counts_[curve] += change;
    for (const auto& [sum, factor] : sums_of_.row(curve)) {
      total -= price(sum, value_[sum]);
      value_[sum] += factor * change;
      total += price(sum, value_[sum]);
    }
    return total;
  }

  const CountSums& sums_;
  std::span<const CountWish> wishes_;
  std::vector<Index>& counts_;
  std::vector<Index> value_;    // #sums
  Csr<SumOf> sums_of_;          // #curves
  std::vector<Reached> best_;   // 2 #sums
  std::vector<Index> touched_;  // states
  std::vector<Change> done_;    // of chains that were kept
  double gain_ = 0;             // of the last of them
  Index held_ = none;           // the curve whose count chains leave
  Reached end_;
  Index unit_ = 1;
  double price_of_odd_ = price_of_odd;
};

}  // namespace

void balance_counts(const CountSums& sums, std::span<const CountWish> wishes,
                    std::vector<Index>& counts) {
  Balancer(sums, wishes, counts).run();
}

}  // namespace lpq
