// See fine_outline.h.
#include "pipeline/fine_outline.h"

#include <algorithm>
#include <cmath>

#include "base/words.h"
#include "domain/simplify.h"

namespace lpq {
namespace {

constexpr double many = 2;              // times as many quads as the size alone asks for
constexpr double hardly_seen = 0.05;    // of the size: what an outline may move by
constexpr double share_left_out = 0.5;  // of the points

/// A number that a person would type.
double with_one_digit(double x) {
  double unit = 1;
  while (unit > x) unit /= 10;
  while (10 * unit <= x) unit *= 10;
  return std::floor(x / unit) * unit;
}

}  // namespace

std::vector<Warning> tell_fine_outline(const Domain& domain, double size, double quads) {
  const double wanted = domain.area / (size * size);
  if (!(quads > many * wanted)) return {};
  const double moves = with_one_digit(hardly_seen * domain.frame.length_to_world(size));
  const std::vector<char> used =
      simplify_boundary(domain, domain.frame.length_to_frame(moves)).used;
  const auto left_out = std::count(used.begin(), used.end(), char{0});
  if (!(static_cast<double>(left_out) > share_left_out * static_cast<double>(used.size())))
    return {};
  return {{ErrorCode::adapted,
           "About " + short_number(std::round(quads)) + " quads where the size alone would make " +
               short_number(std::round(wanted)) +
               ": points of the outline lie far closer together. The option simplify = " +
               short_number(moves) + " would leave out " + std::to_string(left_out) + " of " +
               std::to_string(used.size()) + " points and move the outline by no more than that.",
           {}}};
}

}  // namespace lpq
