// The numbers behind the head of a PLY file, as text or bytes.
#pragma once

#include <algorithm>
#include <string_view>

#include "io/surface/ply_header.h"

namespace lpq {

/// Numbers one after the other, whatever they are written as. After the end, or on a word that is
/// no number, `failed` is set and zeros follow.
class PlyNumbers {
 public:
  PlyNumbers(std::string_view bytes, const PlyHeader& header)
      : bytes_(bytes), format_(header.format), start_(header.size), next_(header.size) {}

  bool failed() const { return failed_; }
  bool at_end() const { return next_ >= bytes_.size(); }
  std::size_t byte() const { return start_; }

  /// Texts have an element on a line; some write more there than their header says.
  void end_element() {
    if (format_ == PlyFormat::text)
      next_ = std::min(bytes_.find_first_of("\r\n", next_), bytes_.size());
  }

  double next(PlyType type) {
    if (failed_) return 0;
    return format_ == PlyFormat::text ? next_word() : next_bytes(type);
  }

 private:
  double next_word();
  double next_bytes(PlyType type);

  std::string_view bytes_;
  PlyFormat format_;
  std::size_t start_, next_;
  bool failed_ = false;
};

}  // namespace lpq
