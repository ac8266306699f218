// See ply_surface.h.
#include "io/surface/ply_surface.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "io/surface/ply_numbers.h"
#include "io/surface/soup_builder.h"
#include "io/surface/surface_text.h"
#include "io/text_place.h"

namespace lpq {
namespace {

/// As many as will be read; faces may come before them.
std::int64_t vertices_of(const PlyHeader& header) {
  for (const PlyElement& element : header.elements)
    if (element.name == "vertex" && !element.properties.empty()) return element.count;
  return 0;
}

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const PlyHeader& header)
      : bytes_(bytes),
        header_(header),
        numbers_(bytes, header),
        vertex_count_(vertices_of(header)) {}

  Result<SurfaceSoup> read() {
    bool has_vertices = false;
    for (const PlyElement& element : header_.elements) {
      if (failed_) break;
      // Counts of elements without properties are bounded by nothing in the file.
      if (element.properties.empty()) continue;
      if (element.name == "vertex" && !has_vertices) {
        has_vertices = true;
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else if (element.name == "tristrips") {
        read_strips(element);
      } else {
        for (std::int64_t i = 0; i < element.count && !failed_; ++i) pass_over(element);
      }
    }
    if (failed_) return error_;
    if (builder_.too_large()) return too_many_triangles();
    if (!builder_.has_polygon()) return no_face();
    if (short_faces_ > 0)
      builder_.warn(
          {ErrorCode::ignored,
           std::to_string(short_faces_) + " faces with fewer than three corners are left out.",
           {}});
    return builder_.take();
  }

 private:
  Error no_face() const {
    std::string text = "The file has no face";
    if (builder_.point_count() > 0) text += ", only points";
    return {ErrorCode::empty, text + ".", {}};
  }

  void fail(std::string message, ErrorCode code = ErrorCode::parse_error) {
    if (failed_) return;
    failed_ = true;
    error_ = error_at(bytes_, numbers_.byte(), std::move(message), code);
    if (header_.format != PlyFormat::text) error_.where.line = none;
  }

  double next(PlyType type) {
    const double value = numbers_.next(type);
    if (numbers_.failed())
      fail(numbers_.at_end() ? "The file ends before its last element."
                             : "The file has a word where a number was expected.");
    return value;
  }

  /// The length of a list; it cannot be longer than the file.
  std::int64_t next_length(const PlyProperty& property) {
    const double length = next(property.count_type);
    if (!failed_ && !(length >= 0 && length <= static_cast<double>(bytes_.size()) &&
                      length == std::floor(length)))
      fail("A list has an impossible length.");
    return failed_ ? 0 : static_cast<std::int64_t>(length);
  }

  void pass_over(const PlyProperty& property) {
    const std::int64_t length = property.is_list ? next_length(property) : 1;
    for (std::int64_t k = 0; k < length && !failed_; ++k) next(property.type);
  }
  void pass_over(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) pass_over(property);
    numbers_.end_element();
  }

  void read_vertices(const PlyElement& element) {
    const Index at[] = {element.find("x"), element.find("y"), element.find("z")};
    for (const Index i : at)
      if (i == none || element.properties[i].is_list)
        return fail("The header names no x, y and z of vertices, each one number.");
    Index size = element.find("size");
    if (size != none && element.properties[size].is_list) size = none;
    for (std::int64_t v = 0; v < element.count && !failed_; ++v) {
      double x[4] = {};
      for (Index i = 0; i < static_cast<Index>(element.properties.size()); ++i) {
        const PlyProperty& property = element.properties[i];
        const auto axis = static_cast<std::size_t>(std::find(at, at + 3, i) - at);
        if (axis == 3 && i != size) {
          pass_over(property);
          continue;
        }
        x[axis] = next(property.type);
        if (!std::isfinite(x[axis]))
          fail("Vertex " + std::to_string(v) + " has a coordinate or size that is not finite.",
               ErrorCode::non_finite);
      }
      numbers_.end_element();
      if (failed_) return;
      builder_.add_point({x[0], x[1], x[2]});
      if (size != none) builder_.set_size(x[3]);
    }
  }

  Index list_of_corners(const PlyElement& element) {
    Index corners = element.find("vertex_indices");
    if (corners == none) corners = element.find("vertex_index");
    if (element.count > 0 && (corners == none || !element.properties[corners].is_list))
      fail("Faces need a list of vertex_indices.");
    return corners;
  }

  void read_faces(const PlyElement& element) {
    const Index corners = list_of_corners(element);
    if (failed_) return;
    Index group = none;
    for (const char* name : {"material_index", "group", "region"})
      if (const Index found = element.find(name); found != none) group = found;
    if (group != none &&
        (element.properties[group].is_list || element.properties[group].type >= PlyType::float32))
      group = none;
    for (std::int64_t f = 0; f < element.count && !failed_; ++f) read_face(element, corners, group);
  }

  void read_face(const PlyElement& element, Index corners, Index group) {
    corners_.clear();
    for (Index i = 0; i < static_cast<Index>(element.properties.size()) && !failed_; ++i) {
      const PlyProperty& property = element.properties[i];
      if (i == corners) {
        read_corners(property);
      } else if (i == group) {
        set_group(next(property.type));
      } else {
        pass_over(property);
      }
    }
    numbers_.end_element();
    if (failed_) return;
    if (corners_.size() < 3) {
      ++short_faces_;
    } else {
      builder_.add_polygon(corners_);
    }
  }

  void read_corners(const PlyProperty& property) {
    const std::int64_t length = next_length(property);
    for (std::int64_t k = 0; k < length && !failed_; ++k)
      corners_.push_back(corner_of(next(property.type)));
  }

  Index corner_of(double index) {
    if (failed_) return none;
    const auto known = static_cast<double>(
        std::min<std::int64_t>(vertex_count_, std::numeric_limits<Index>::max()));
    if (index >= 0 && index < known && index == std::floor(index)) return static_cast<Index>(index);
    fail(index == std::floor(index) && std::abs(index) < 1e15
             ? unknown_vertex(static_cast<std::int64_t>(index), vertex_count_, 0).message
             : "A face corner must be a vertex number.");
    return none;
  }

  void read_strips(const PlyElement& element) {
    const Index corners = list_of_corners(element);
    if (failed_) return;
    for (std::int64_t i = 0; i < element.count && !failed_; ++i) {
      for (Index k = 0; k < static_cast<Index>(element.properties.size()) && !failed_; ++k) {
        const PlyProperty& property = element.properties[k];
        k == corners ? read_strip(property) : pass_over(property);
      }
      numbers_.end_element();
    }
  }

  /// Every vertex makes a triangle with the two before it, in turn one way round and the other;
  /// -1 begins anew. Strips turn corners by triangles with a vertex twice.
  void read_strip(const PlyProperty& property) {
    const std::int64_t length = next_length(property);
    corners_.clear();
    bool turned = false;
    for (std::int64_t k = 0; k < length && !failed_; ++k) {
      const double index = next(property.type);
      if (index == -1) {
        corners_.clear();
        turned = false;
        continue;
      }
      corners_.push_back(corner_of(index));
      if (failed_ || corners_.size() < 3) continue;
      auto [a, b, c] = std::array{corners_[0], corners_[1], corners_[2]};
      corners_.erase(corners_.begin());
      if (turned) std::swap(a, b);
      turned = !turned;
      if (a != b && b != c && c != a) builder_.add_polygon(std::array{a, b, c});
    }
  }

  void set_group(double number) {
    if (failed_ || number == group_) return;
    group_ = number;
    std::string name;
    append_number(name, number);
    builder_.set_group(name, name);
  }

  std::string_view bytes_;
  const PlyHeader& header_;
  PlyNumbers numbers_;
  std::int64_t vertex_count_;
  SoupBuilder builder_;
  std::vector<Index> corners_;
  double group_ = std::nan("");
  std::int64_t short_faces_ = 0;
  bool failed_ = false;
  Error error_;
};

}  // namespace

Result<SurfaceSoup> read_ply_surface(std::string_view bytes) {
  const auto header = read_ply_header(bytes);
  if (!header) return header.error();
  return PlyReader(bytes, *header).read();
}

}  // namespace lpq
