// See json_lists.h.
#include "io/domain/json_lists.h"

#include "base/few_warnings.h"

namespace lpq {
namespace {

/// Edges of a loop; its first point may be repeated at its end.
std::size_t edge_count(const Loop& loop) {
  return loop.size() > 1 && loop.front() == loop.back() ? loop.size() - 1 : loop.size();
}

std::string counts_of(std::size_t loop, std::size_t edges, const char* joint, std::size_t tags) {
  return "Loop " + std::to_string(loop) + " has " + std::to_string(edges) + " edges " + joint +
         std::to_string(tags) + (tags == 1 ? " edge tag; " : " edge tags; ");
}

Problem fit_tags(DomainInput::Region& region, Where where, FewWarnings& warnings) {
  for (std::size_t l = 0; l < region.tags.size(); ++l) {
    const std::size_t tags = region.tags[l].size();
    where.loop = static_cast<Index>(l);
    if (l >= region.loops.size()) {
      if (tags == 0) continue;
      return Error{
          ErrorCode::parse_error,
          "There are edge tags for " + std::to_string(region.tags.size()) + " loops, but only " +
              std::to_string(region.loops.size()) +
              "; give a list of tags per loop, with a tag per edge: [[\"a\", \"b\", ...]].",
          where};
    }
    const std::size_t edges = edge_count(region.loops[l]);
    // One tag per point given is right as well.
    if (tags > region.loops[l].size())
      return Error{ErrorCode::parse_error,
                   counts_of(l, edges, "but ", tags) + "give one tag per edge.", where};
    if (tags > 0 && tags < edges) {
      warnings.add({ErrorCode::adapted,
                    counts_of(l, edges, "but only ", tags) + "the edges after these have none.",
                    where});
      region.tags[l].resize(edges);
    }
  }
  if (region.tags.size() > region.loops.size()) region.tags.resize(region.loops.size());
  return std::nullopt;
}

Problem judge_guide(const DomainInput::Guide& guide, Index number) {
  for (const Vec2 p : guide)
    if (!(p == guide.front())) return std::nullopt;
  Where where;
  where.guide = number;
  const std::string name = "guide " + std::to_string(number);
  if (guide.size() > 1)
    return Error{ErrorCode::parse_error,
                 "All points of " + name + " are the same: it has no direction.", where};
  return Error{ErrorCode::parse_error,
               "A guide needs at least two points, but " + name + " has " +
                   std::to_string(guide.size()) + ".",
               where};
}

}  // namespace

Problem fit_lists(DomainInput& domain, std::vector<Warning>& warnings) {
  for (std::size_t g = 0; g < domain.guides.size(); ++g)
    if (auto error = judge_guide(domain.guides[g], static_cast<Index>(g))) return error;
  FewWarnings of_tags;
  for (std::size_t r = 0; r < domain.regions.size(); ++r) {
    Where where;
    where.region = static_cast<Index>(r);
    if (auto error = fit_tags(domain.regions[r], where, of_tags)) return error;
  }
  for (Warning& warning : of_tags.take()) warnings.push_back(std::move(warning));
  return std::nullopt;
}

}  // namespace lpq
