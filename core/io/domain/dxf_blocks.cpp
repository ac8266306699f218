// See dxf_blocks.h.
#include "io/domain/dxf_blocks.h"

#include <algorithm>

#include "io/escape.h"

namespace lpq {
namespace {

Error error_of(ErrorCode code, std::string message, const DxfItem& item) {
  Error error{code, std::move(message), {}};
  error.where.set_line(item.line, item.byte);
  return error;
}

std::string quoted(std::string_view name) { return "\"" + std::string(name.substr(0, 40)) + "\""; }

class Placer {
 public:
  Placer(const DxfSections& sections, DxfLetters letters, Drawing& drawing)
      : sections_(sections), letters_(letters), drawing_(drawing) {}

  Result<DxfPieces> place() {
    add_items(sections_.drawing, {{}, false, "0", false});
    if (failed_) return error_;
    return std::move(found_);
  }

 private:
  /// Where a block is put.
  struct Place {
    Affine map;
    bool moved;              // by the map
    std::string_view layer;  // of its INSERT
    bool on_paper;
  };

  void fail(Error error) {
    if (!failed_) error_ = std::move(error);
    failed_ = true;
  }
  DxfLayer layer_named(std::string_view name) const {
    const auto found = sections_.layers.find(dxf_key(name));
    return found == sections_.layers.end() ? DxfLayer() : found->second;
  }

  void add_items(const DxfBlock& block, const Place& place);
  void add_curve(const DxfItem& item, Place place);
  void add_insert(const DxfItem& item, const Place& place);
  const DxfBlock* block_of(const DxfItem& item);
  void add_copies(const DxfItem& item, const DxfBlock& block, const Place& place);

  const DxfSections& sections_;
  DxfLetters letters_;
  Drawing& drawing_;
  DxfPieces found_;
  std::vector<const DxfBlock*> around_;  // the blocks that are being placed, outermost first
  Index copied_ = 0;
  bool failed_ = false;
  Error error_;
};

void Placer::add_items(const DxfBlock& block, const Place& place) {
  for (const DxfItem& item : block.items) {
    if (place.moved && ++copied_ > most_copies)
      return fail(error_of(ErrorCode::too_large,
                           "The blocks of this drawing, all copies together, have more than " +
                               std::to_string(most_copies) + " entities.",
                           item));
    Place own = place;
    if (!item.layer.empty() && item.layer != "0") own.layer = item.layer;
    own.on_paper = place.on_paper || item.on_paper;
    const DxfLayer layer = layer_named(own.layer);
    // A layer that is off hides what is on it, one that is frozen also the blocks inserted on it.
    if (item.invisible || layer.frozen || (layer.off && !item.insert)) {
      found_.hidden.add(item.type);
    } else if (item.curve) {
      add_curve(item, own);
    } else if (item.insert) {
      add_insert(item, own);
    } else {
      found_.left_out.add(item.type);
    }
    if (failed_) return;
  }
}

void Placer::add_curve(const DxfItem& item, Place place) {
  found_.heights += item.curve->has_height ? 1 : 0;
  found_.interpolated += item.curve->interpolated ? 1 : 0;
  if (place.layer == "0") place.layer = {};
  if (letters_ != DxfLetters::utf8 && !is_utf8(place.layer)) found_.foreign_names = true;
  const Index source = drawing_.add_source(dxf_name(place.layer, letters_), item.line, item.byte);
  found_.pieces.push_back({&*item.curve, place.moved, place.map, source, place.on_paper});
}

/// The block that an INSERT asks for; null, and a word about it, where it cannot be shown.
const DxfBlock* Placer::block_of(const DxfItem& item) {
  const std::string key = dxf_key(item.insert->block);
  const auto found = sections_.blocks.find(key);
  // Before there were HATCH entities, a hatch was a block of that name: lines, but no outlines.
  const bool is_hatch = key.substr(0, 2) == "*x";
  const char* reason = nullptr;
  if (found == sections_.blocks.end()) {
    reason = "INSERT without its block";
  } else if (found->second.external) {
    reason = "INSERT of another file";
  } else if (is_hatch) {
    reason = "INSERT of a hatch";
  }
  if (reason == nullptr) return &found->second;
  found_.left_out.add(reason);
  return nullptr;
}

void Placer::add_insert(const DxfItem& item, const Place& place) {
  const DxfBlock* block = block_of(item);
  if (block == nullptr) return;
  if (block->error) return fail(*block->error);
  if (std::find(around_.begin(), around_.end(), block) != around_.end())
    return fail(error_of(ErrorCode::parse_error,
                         "The block " + quoted(block->name) + " contains itself.", item));
  if (around_.size() == deepest_block)
    return fail(error_of(ErrorCode::too_large,
                         "The block " + quoted(block->name) + " is inserted more than " +
                             std::to_string(deepest_block) + " blocks deep.",
                         item));
  found_.heights += item.insert->has_height ? 1 : 0;
  around_.push_back(block);
  add_copies(item, *block, place);
  around_.pop_back();
}

void Placer::add_copies(const DxfItem& item, const DxfBlock& block, const Place& place) {
  const DxfInsert& insert = *item.insert;
  if (block.items.empty()) return;
  const Affine to_base{1, 0, 0, 1, -block.base.x, -block.base.y};
  for (Index row = 0; row < insert.rows; ++row) {
    for (Index column = 0; column < insert.columns && !failed_; ++column) {
      const Vec2 shift = static_cast<double>(column) * insert.column_step +
                         static_cast<double>(row) * insert.row_step;
      const Affine shifted = Affine{1, 0, 0, 1, shift.x, shift.y} * insert.map;
      add_items(block, {place.map * shifted * to_base, true, place.layer, place.on_paper});
    }
  }
}

}  // namespace

Result<DxfPieces> place_dxf_blocks(const DxfSections& sections, DxfLetters letters,
                                   Drawing& drawing) {
  return Placer(sections, letters, drawing).place();
}

}  // namespace lpq
