// See off_surface.h.
#include "io/surface/off_surface.h"

#include "io/plain_text.h"
#include "io/surface/soup_builder.h"
#include "io/surface/surface_text.h"

namespace lpq {
namespace {

class OffReader {
 public:
  /// Whether a line is a vertex, or vertices are any three numbers.
  enum class Layout { lines, words };

  OffReader(std::string_view text, Layout layout) : lines_(text), layout_(layout) {}

  Result<SurfaceSoup> read() {
    read_counts();
    // How many numbers a vertex has is known for sure where it has nothing but its place.
    if (layout_ == Layout::words && has_prefix_) fail("Every vertex needs a line of its own.");
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

  /// The next word, of this line or one of the next; false at the end.
  bool next_word(const char* what) {
    if (++at_ < words_.size()) return true;
    at_ = 0;
    return next_words(what);
  }

  /// [ST][C][N][4][n]OFF, perhaps in small letters or with the first count right behind it.
  void read_counts() {
    if (!next_words("count")) return;
    std::string_view first = words_[0];
    const bool small = first.find("off") != std::string_view::npos;
    const std::size_t off = first.find(small ? "off" : "OFF");
    at_ = 0;
    if (off != std::string_view::npos) {
      const std::string_view prefix = first.substr(0, off);
      if (prefix.find_first_not_of(small ? "stcn4" : "STCN4") != std::string_view::npos)
        return fail("Only OFF files of points in space can be read.");
      has_prefix_ = !prefix.empty();
      has_weights_ = prefix.find('4') != std::string_view::npos;
      first.remove_prefix(off + 3);
      at_ = first.empty() ? 1 : 0;
    }
    if (at_ < words_.size() && same_letters(words_[at_], "binary"))
      return fail("Binary OFF files cannot be read; save it as text.");
    if (at_ == words_.size()) {
      if (!next_words("count")) return;
      at_ = 0;
    }
    if (first.empty()) first = words_[at_];
    if (!parse_integer(first, vertex_count_) || !read_other_counts())
      fail("An OFF file begins with 'OFF' and the numbers of vertices and faces.");
  }

  /// Of faces and, where lines do not matter, edges, which some programs leave out.
  bool read_other_counts() {
    if (layout_ == Layout::lines)
      return at_ + 1 < words_.size() && parse_integer(words_[at_ + 1], face_count_);
    std::int64_t edges = 0;
    return next_word("count") && parse_integer(words_[at_], face_count_) && next_word("count") &&
           parse_integer(words_[at_], edges);
  }

  void read_vertex() {
    Vec3 p;
    Error wrong;
    if (layout_ == Layout::lines) {
      if (!next_words("vertex")) return;
      if (!read_point(words_, 0, "A vertex", p, wrong)) return fail(wrong.message, wrong.code);
      if (has_weights_) divide_by_weight(p);
    } else {
      for (double* const x : {&p.x, &p.y, &p.z})
        if (!next_word("vertex") || !parse_number(words_[at_], *x))
          return fail("A vertex needs three finite numbers: x y z.");
    }
    builder_.add_point(p);
  }

  /// Of 4OFF, whose points are x/w, y/w and z/w.
  void divide_by_weight(Vec3& p) {
    double w = 0;
    if (words_.size() > 3 && parse_number(words_[3], w) && w != 0) {
      p = {p.x / w, p.y / w, p.z / w};
      if (is_finite(p)) return;
    }
    fail("A vertex of a 4OFF file needs four finite numbers, the last one not 0.");
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
  Layout layout_;
  Words words_;
  std::size_t at_ = 0;  // of the word read last, where lines do not matter
  bool has_prefix_ = false, has_weights_ = false;
  SoupBuilder builder_;
  std::vector<Index> corners_;
  std::int64_t vertex_count_ = 0, face_count_ = 0, short_faces_ = 0;
  Error first_short_;
  bool failed_ = false;
  Error error_;
};

}  // namespace

Result<SurfaceSoup> read_off_surface(std::string_view text) {
  auto by_lines = OffReader(text, OffReader::Layout::lines).read();
  if (by_lines) return by_lines;
  auto by_words = OffReader(text, OffReader::Layout::words).read();
  return by_words ? by_words : by_lines;
}

}  // namespace lpq
