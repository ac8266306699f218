// See obj_surface.h.
#include "io/surface/obj_surface.h"

#include "io/surface/soup_builder.h"
#include "io/surface/surface_text.h"

namespace lpq {
namespace {

class ObjSurfaceReader {
 public:
  explicit ObjSurfaceReader(std::string_view text) : lines_(text) {}

  Result<SurfaceSoup> read() {
    while (!lines_.at_end() && !failed_) {
      words_.split(next_logical_line());
      if (words_.size() > 0) read_line();
      if (builder_.too_large()) return too_many_triangles();
    }
    if (failed_) return error_;
    if (!builder_.has_polygon()) return no_face();
    if (short_faces_ > 0) warn_of_short_faces();
    return builder_.take();
  }

 private:
  Error no_face() const {
    std::string text = "The file has no face (no line 'f ...')";
    if (short_faces_ > 0) text = "The file has no face of three corners or more";
    if (free_forms_ > 0) {
      text += ", only free-form curves or surfaces. Export it as triangles";
    } else if (builder_.point_count() > 0) {
      text += ", only points or lines";
    }
    return {ErrorCode::empty, text + ".", {}};
  }

  /// A line and what follows it after a backslash.
  std::string_view next_logical_line() {
    std::string_view line = lines_.next();
    first_ = lines_.error({});
    if (line.empty() || line.back() != '\\') return line;
    joined_.clear();
    while (!line.empty() && line.back() == '\\') {
      joined_ += line.substr(0, line.size() - 1);
      joined_ += ' ';
      line = lines_.next();
    }
    joined_ += line;
    return joined_;
  }

  void fail(std::string message, ErrorCode code = ErrorCode::parse_error) {
    failed_ = true;
    error_ = first_;
    error_.code = code;
    error_.message = std::move(message);
  }

  void read_line() {
    const std::string_view keyword = words_[0];
    if (keyword == "v") {
      read_vertex();
    } else if (keyword == "f") {
      read_face();
    } else if (keyword == "o") {
      name_group(object_);
      builder_.set_body(object_);
    } else if (keyword == "g") {
      name_group(group_);
    } else if (keyword == "usemtl") {
      name_group(material_);
    } else if (keyword == "cstype") {
      ++free_forms_;
    }
  }

  void read_vertex() {
    Vec3 p;
    Error wrong;
    if (!read_point(words_, 1, "A vertex", p, wrong)) return fail(wrong.message, wrong.code);
    builder_.add_point(p);
  }

  void read_face() {
    if (words_.size() < 4) {
      if (short_faces_++ == 0) first_short_ = first_;
      return;
    }
    corners_.clear();
    for (std::size_t k = 1; k < words_.size(); ++k) {
      const std::string_view word = words_[k];
      std::int64_t index = 0;
      if (!parse_integer(word.substr(0, word.find('/')), index))
        return fail("A face corner must be a vertex number.");
      const std::int64_t number = index;
      // 0 is nobody's number.
      index = number > 0 ? number - 1 : number < 0 ? builder_.point_count() + number : -1;
      if (index < 0 || index >= builder_.point_count())
        return fail(unknown_vertex(number, builder_.point_count(), 1).message);
      corners_.push_back(static_cast<Index>(index));
    }
    builder_.add_polygon(corners_);
  }

  void name_group(std::string& part) {
    part = joined_words(words_, 1);
    std::string key, name;
    for (const std::string* one : {&object_, &group_, &material_}) {
      key += *one + '\n';
      if (one->empty() || (one == &object_ && begins_with_object(group_))) continue;
      if (!name.empty()) name += '/';
      name += *one;
    }
    builder_.set_group(key, name);
  }

  /// "bolt" and "bolt face 1" are one name.
  bool begins_with_object(const std::string& name) const {
    const std::size_t length = object_.size();
    return name.compare(0, length, object_) == 0 &&
           (name.size() == length ||
            std::string_view(" _/").find(name[length]) != std::string_view::npos);
  }

  void warn_of_short_faces() {
    first_short_.message = std::to_string(short_faces_) +
                           " faces with fewer than three corners are left out; here is the first.";
    first_short_.code = ErrorCode::ignored;
    builder_.warn(first_short_);
  }

  LineReader lines_;
  std::string joined_;
  Words words_;
  SoupBuilder builder_;
  std::vector<Index> corners_;
  std::string object_, group_, material_;
  std::int64_t short_faces_ = 0, free_forms_ = 0;
  Error first_, first_short_;  // the line being read, the first short face
  bool failed_ = false;
  Error error_;
};

}  // namespace

Result<SurfaceSoup> read_obj_surface(std::string_view text) {
  return ObjSurfaceReader(text).read();
}

}  // namespace lpq
