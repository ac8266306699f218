// The entities of MSH 4.0 and 4.1: elements belong to one of them, and by it to physical groups.
// In a partitioned mesh that is a part of an entity of the model, or the cut between parts.
#pragma once

#include <cstdint>
#include <vector>

#include "io/mesh/msh_parse.h"
#include "io/mesh/msh_rows.h"

namespace lpq {

/// What an element has of the entity it belongs to.
struct MshHome {
  std::int64_t entity = 0;    // its tag; of a part, that of the whole
  std::int64_t physical = 0;  // the first tag, negative for reversed; 0 without one
  bool in_others = false;     // there are more
  bool is_cut = false;        // no entity of the model, but a border between parts
};

class MshEntities {
 public:
  /// $Entities and $PartitionedEntities. In 4.0 (`old`) points have a box, too.
  void read(MshRows& rows, bool old);
  void read_parts(MshRows& rows, bool old);

  /// A part has the groups of its whole, if that has any: Gmsh may name parts by themselves.
  MshHome home_of(std::int64_t dimension, std::int64_t tag) const;
  /// Groups that an entity is in beside its first, as often as there are such.
  const std::vector<MshGroup>& other_groups() const { return other_groups_; }

 private:
  using List = std::vector<MshLabelled<MshHome>>;
  void read_list(MshRows& rows, bool old, bool are_parts, List& list);
  MshLabelled<MshHome> read_entity(MshRows& rows, std::int64_t dimension, bool old, bool is_part);
  bool read_physicals(MshRows& rows, MshLabelled<MshHome>& entity);

  List wholes_, parts_;  // sorted; of wholes those with groups
  std::vector<MshGroup> other_groups_;
};

}  // namespace lpq
