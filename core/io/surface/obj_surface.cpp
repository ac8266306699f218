// See obj_surface.h.
#include "io/surface/obj_surface.h"

#include "io/obj_text.h"
#include "io/surface/soup_builder.h"
#include "io/surface/surface_text.h"

namespace lpq {
namespace {

class ObjSurfaceReader {
 public:
  explicit ObjSurfaceReader(std::string_view text) : lines_(text), numbers_(lines_) {}

  Result<SurfaceSoup> read() {
    while (!lines_.at_end() && !failed_) {
      const Words& words = lines_.next();
      if (words.size() > 0) read_line(words);
      if (builder_.too_large()) return too_many_triangles();
    }
    if (failed_) return error_;
    if (!numbers_.all_there(builder_.point_count())) return numbers_.error();
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

  void fail(std::string message, ErrorCode code = ErrorCode::parse_error) {
    failed_ = true;
    error_ = lines_.error(std::move(message));
    error_.code = code;
  }

  void read_line(const Words& words) {
    const std::string_view keyword = words[0];
    if (keyword == "v") {
      read_vertex(words);
    } else if (keyword == "f") {
      read_face(words);
    } else if (keyword == "o") {
      name_group(object_, words);
      builder_.set_body(object_);
    } else if (keyword == "g") {
      name_group(group_, words);
    } else if (keyword == "usemtl") {
      name_group(material_, words);
    } else if (keyword == "cstype") {
      ++free_forms_;
    }
  }

  void read_vertex(const Words& words) {
    Vec3 p;
    Error wrong;
    if (!read_point(words, 1, "A vertex", p, wrong)) return fail(wrong.message, wrong.code);
    builder_.add_point(p);
  }

  void read_face(const Words& words) {
    if (words.size() < 4) {
      if (short_faces_++ == 0) first_short_ = lines_.error({});
      return;
    }
    corners_.clear();
    for (std::size_t k = 1; k < words.size(); ++k) {
      corners_.push_back(numbers_.read(words[k], builder_.point_count()));
      if (corners_.back() != none) continue;
      failed_ = true;
      error_ = numbers_.error();
      return;
    }
    builder_.add_polygon(corners_);
  }

  void name_group(std::string& part, const Words& words) {
    part = joined_words(words, 1);
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

  ObjLines lines_;
  ObjCorners numbers_;
  SoupBuilder builder_;
  std::vector<Index> corners_;
  std::string object_, group_, material_;
  std::int64_t short_faces_ = 0, free_forms_ = 0;
  Error first_short_;
  bool failed_ = false;
  Error error_;
};

}  // namespace

Result<SurfaceSoup> read_obj_surface(std::string_view text) {
  return ObjSurfaceReader(text).read();
}

}  // namespace lpq
