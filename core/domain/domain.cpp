// The door, in five steps that each have a file: numbers and repeated points (outline), the loops
// of every region by themselves (judge), canonical order (canonical), regions, polylines and points
// against each other (sides), and what rounding has parted (near_misses). Every decision about
// position is an exact sign, but for the last ones.
#include "domain/domain.h"

#include "domain/canonical.h"
#include "domain/judge.h"
#include "domain/near_misses.h"
#include "domain/outline.h"
#include "domain/sides.h"

namespace lpq {

Result<Domain> make_domain(const DomainInput& input, const DomainOptions& options) {
  const Result<Outline> outline = make_outline(input, options);
  if (!outline) return outline.error();
  const Result<LoopRoles> roles = judge_loops(*outline, options.outer_first);
  if (!roles) return roles.error();
  Result<Domain> domain = make_canonical(*outline, *roles);
  if (!domain) return domain;
  if (const Problem problem = settle_sides(*domain)) return *problem;
  if (const Problem problem = judge_near_misses(*domain)) return *problem;
  return domain;
}

}  // namespace lpq
