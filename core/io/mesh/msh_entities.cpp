// See msh_entities.h.
#include "io/mesh/msh_entities.h"

#include <algorithm>
#include <utility>

namespace lpq {
namespace {

/// The dimension and tag of what the entity is a part of, then the partitions it is in.
bool read_whole(MshRows& rows, MshLabelled<MshHome>& part) {
  std::int64_t dimension = 0, tag = 0, partitions = 0;
  if (!rows.read_int(dimension) || !rows.read_int(tag) || !rows.read_count(partitions))
    return false;
  rows.skip_ints(partitions);
  part.value.is_cut = dimension > part.dimension;
  if (dimension == part.dimension) part.value.entity = tag;
  return true;
}

}  // namespace

bool MshEntities::read_physicals(MshRows& rows, MshLabelled<MshHome>& entity) {
  std::int64_t count = 0, tag = 0;
  if (!rows.read_count(count)) return false;
  for (std::int64_t i = 0; i < count; ++i) {
    if (!rows.read_int(tag)) return false;
    if (i == 0) entity.value.physical = tag;
    if (i > 0) other_groups_.push_back({entity.dimension, tag < 0 ? -tag : tag});
  }
  entity.value.in_others = count > 1;
  return true;
}

/// Tag, of a part its whole, then a point or a box, then the physical tags; in bytes also what
/// bounds it.
MshLabelled<MshHome> MshEntities::read_entity(MshRows& rows, std::int64_t dimension, bool old,
                                              bool is_part) {
  MshLabelled<MshHome> entity{dimension, 0, {}};
  rows.begin_row();
  bool good = rows.read_int(entity.tag);
  entity.value.entity = entity.tag;
  if (is_part) good = good && read_whole(rows, entity);
  rows.skip_reals(dimension == 0 && !old ? 3 : 6);
  std::int64_t bounds = 0;
  if (!good || !read_physicals(rows, entity)) {
    rows.fail("An entity needs a tag, its extent and its physical tags.");
  } else if (rows.is_binary() && dimension > 0 && rows.read_count(bounds)) {
    rows.skip_ints(bounds);
  }
  return entity;
}

void MshEntities::read_list(MshRows& rows, bool old, bool are_parts, List& list) {
  if (!rows.read_integers(0, 4)) return;
  const std::vector<std::int64_t> counts = rows.integers();
  for (std::int64_t dimension = 0; dimension < 4; ++dimension)
    for (std::int64_t left = counts[static_cast<std::size_t>(dimension)]; left > 0; --left) {
      list.push_back(read_entity(rows, dimension, old, are_parts));
      if (rows.failed()) return;
      if (!are_parts && list.back().value.physical == 0) list.pop_back();
    }
  std::stable_sort(list.begin(), list.end());
}

void MshEntities::read(MshRows& rows, bool old) { read_list(rows, old, false, wholes_); }

/// Before the entities are the number of partitions, and where the copies at their borders are.
void MshEntities::read_parts(MshRows& rows, bool old) {
  if (!rows.read_integers(0, 1) || !rows.read_integers(0, 1)) return;
  for (std::int64_t left = rows.integers()[0]; left > 0; --left)
    if (!rows.read_integers(2, 0)) return;
  read_list(rows, old, true, parts_);
}

MshHome MshEntities::home_of(std::int64_t dimension, std::int64_t tag) const {
  const MshHome* part = find_msh_label(parts_, dimension, tag);
  if (part != nullptr && part->is_cut) return *part;
  const MshHome* whole = find_msh_label(wholes_, dimension, part != nullptr ? part->entity : tag);
  if (whole != nullptr) return *whole;
  return part != nullptr ? *part : MshHome{.entity = tag};
}

}  // namespace lpq
