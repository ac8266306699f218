// See off_surface.h.
#include "io/surface/off_surface.h"

#include "io/plain_text.h"
#include "io/surface/soup_builder.h"
#include "io/surface/surface_text.h"

namespace lpq {
namespace {

class OffReader {
 public:
  explicit OffReader(std::string_view text) : lines_(text) {}

  Result<SurfaceSoup> read() {
    if (!failed_) read_counts();
    for (std::int64_t i = 0; i < vertex_count_ && !failed_; ++i) read_vertex();
    for (std::int64_t i = 0; i < face_count_ && !failed_; ++i) read_face();
    if (failed_) return error_;
    if (builder_.too_large()) return too_many_triangles();
    if (!builder_.has_polygon()) return Error{ErrorCode::empty, "The file has no face.", {}};
    if (short_faces_ > 0) warn_of_short_faces();
    return builder_.take();
  }

 private:
  void fail(std::string message, ErrorCode code = ErrorCode::parse_error) {
    if (failed_) return;
    failed_ = true;
    if (words_.size() > 0 && lines_.at_end())
      message += " It is the last line: the file may have been cut off.";
    error_ = lines_.error(std::move(message));
    error_.code = code;
  }

  /// The words of the next line that has any; false at the end.
  bool next_words(const char* what) {
    do {
      if (lines_.at_end()) {
        words_.split({});
        fail(std::string("The file ends before its last ") + what + ".");
        return false;
      }
      words_.split(lines_.next());
    } while (words_.size() == 0);
    return true;
  }

  /// [ST][C][N][4][n]OFF, perhaps in small letters or with the first count right behind it.
  void read_counts() {
    if (!next_words("count")) return;
    std::string_view first = words_[0];
    const bool small = first.find("off") != std::string_view::npos;
    const std::size_t off = first.find(small ? "off" : "OFF");
    std::size_t at = 0;
    if (off != std::string_view::npos) {
      const std::string_view prefix = first.substr(0, off);
      if (prefix.find_first_not_of(small ? "stcn" : "STCN") != std::string_view::npos)
        return fail("Only OFF files of points in space can be read.");
      first.remove_prefix(off + 3);
      at = first.empty() ? 1 : 0;
    }
    if (at < words_.size() && same_letters(words_[at], "binary"))
      return fail("Binary OFF files cannot be read; save it as text.");
    if (at == words_.size()) {
      if (!next_words("count")) return;
      at = 0;
      first = words_[0];
    } else if (at == 1) {
      first = words_[1];
    }
    if (words_.size() < at + 2 || !parse_integer(first, vertex_count_) ||
        !parse_integer(words_[at + 1], face_count_))
      fail("An OFF file begins with 'OFF' and the numbers of vertices and faces.");
  }

  void read_vertex() {
    if (!next_words("vertex")) return;
    Vec3 p;
    Error wrong;
    if (!read_point(words_, 0, "A vertex", p, wrong)) return fail(wrong.message, wrong.code);
    builder_.add_point(p);
  }

  void read_face() {
    if (!next_words("face")) return;
    std::int64_t size = 0;
    if (!parse_integer(words_[0], size) || size < 0)
      return fail("A face begins with the number of its corners.");
    corners_.clear();
    add_corners(1, size);
    // Some programs spread a face over lines, and have nothing behind its corners.
    while (!failed_ && static_cast<std::int64_t>(corners_.size()) < size) {
      if (lines_.at_end()) return fail("A face has fewer corners than it says.");
      if (!next_words("face")) return;
      if (static_cast<std::int64_t>(corners_.size() + words_.size()) > size)
        return fail("The face before has fewer corners than it says.");
      add_corners(0, size);
    }
    if (failed_) return;
    if (size >= 3) return builder_.add_polygon(corners_);
    if (short_faces_++ == 0) first_short_ = lines_.error({});
  }

  /// From a word of the line on, until the face has `size`.
  void add_corners(std::size_t word, std::int64_t size) {
    for (; word < words_.size() && static_cast<std::int64_t>(corners_.size()) < size; ++word) {
      std::int64_t index = 0;
      if (!parse_integer(words_[word], index))
        return fail("A face corner must be a vertex number.");
      if (index < 0 || index >= builder_.point_count())
        return fail(unknown_vertex(index, builder_.point_count(), 0).message);
      corners_.push_back(static_cast<Index>(index));
    }
  }

  void warn_of_short_faces() {
    first_short_.message = std::to_string(short_faces_) +
                           " faces with fewer than three corners are left out; here is the first.";
    first_short_.code = ErrorCode::ignored;
    builder_.warn(first_short_);
  }

  LineReader lines_;
  Words words_;
  SoupBuilder builder_;
  std::vector<Index> corners_;
  std::int64_t vertex_count_ = 0, face_count_ = 0, short_faces_ = 0;
  Error first_short_;
  bool failed_ = false;
  Error error_;
};

}  // namespace

Result<SurfaceSoup> read_off_surface(std::string_view text) { return OffReader(text).read(); }

}  // namespace lpq
