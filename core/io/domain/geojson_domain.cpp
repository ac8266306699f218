// A push reader as in json_domain.cpp. Coordinates may come before the type that says what they
// are, so their brackets are kept as ends of lines and of polygons until the object closes.
#include "io/domain/geojson_domain.h"

#include <algorithm>
#include <utility>

#include "io/json_text.h"

namespace lpq {
namespace {

constexpr std::string_view kinds[] = {
    "Point",        "MultiPoint",         "LineString", "MultiLineString",  "Polygon",
    "MultiPolygon", "GeometryCollection", "Feature",    "FeatureCollection"};
constexpr std::size_t geometry_kinds = 6;
// How deep the brackets of each kind go around a position.
constexpr int brackets[geometry_kinds] = {0, 1, 1, 2, 2, 3};

enum class Role { ignored, object, object_list, properties, coordinates };

/// Nested arrays of positions, flat.
struct Coordinates {
  std::vector<Vec2> points;
  std::vector<std::size_t> line_ends;     // into points
  std::vector<std::size_t> polygon_ends;  // into line_ends
  int height = -1;                        // brackets around a position; -1 = no position
};

struct Object {
  std::string type, name, tag;
  bool has_eta = false, has_region = false;  // among its properties, as faces of a mesh have them
  bool has_coordinates = false;
  Coordinates coordinates;
  std::size_t first_region = 0, first_polyline = 0, first_point = 0;  // what lies in it
};

class Reader final : public JsonReader {
 public:
  explicit Reader(JsonText& text) : text_(text) {}

  Result<DomainFile> read() {
    const bool complete = text_.parse(*this);
    if (!complete) fail(ErrorCode::parse_error, "This is not valid JSON.");
    if (failed_) return error_;
    if (mesh_faces_ > 0 && mesh_faces_ == file_.domain.regions.size()) return error_of_mesh();
    if (open_rings_ > 0)
      file_.warnings.push_back({ErrorCode::adapted,
                                "Rings whose last position is not the first one were closed: " +
                                    std::to_string(open_rings_) + ".",
                                {}});
    return std::move(file_);
  }

  bool null() override { return other_value(); }
  bool boolean(bool) override { return other_value(); }
  bool binary(binary_t&) override { return other_value(); }
  bool string(string_t& value) override;
  bool key(string_t& value) override {
    if (frames_.back().role == Role::properties && value == "region")
      objects_.back().has_region = true;
    frames_.back().key = std::move(value);
    return true;
  }
  bool start_object(std::size_t) override;
  bool end_object() override;
  bool start_array(std::size_t) override;
  bool end_array() override;
  bool parse_error(std::size_t, const std::string&,
                   const nlohmann::detail::exception& problem) override {
    if (problem.id == json_number_overflow)
      return fail(ErrorCode::non_finite, "A number is too large for a double.");
    return fail(ErrorCode::parse_error, text_.at_end() ? "This is not valid JSON: the text ends."
                                                       : "This is not valid JSON.");
  }

 private:
  struct Frame {
    Role role;
    bool is_array;
    std::string key;
    std::size_t numbers = 0;  // of coordinates: numbers read
    int height = -1;          // of coordinates: brackets within
  };

  bool fail(ErrorCode code, std::string message) {
    if (!failed_) error_ = text_.error(code, std::move(message));
    failed_ = true;
    return false;
  }
  bool fail(std::string message) { return fail(ErrorCode::parse_error, std::move(message)); }

  Role next_role() const;
  bool open(Role role, bool is_array);
  bool other_value();
  bool number(double value) override;
  /// Of what write_geojson() makes: triangles and quads, each with its region and eta.
  static Error error_of_mesh() {
    return {
        ErrorCode::parse_error,
        "These are the faces of a mesh as lpquad writes it, not outlines. Give the domain it was "
        "made from, or the mesh as .msh, of which the outline is read.",
        {}};
  }
  bool end_of_coordinates(const Frame& frame);
  bool end_of_object(Object object);
  void count_mesh_faces(std::size_t first_region);
  bool add_geometry(std::size_t kind, Object& object);
  void add_polygons(const Coordinates& c);
  void name_parts(const Object& feature);

  JsonText& text_;
  std::vector<Frame> frames_;
  std::vector<Object> objects_;  // those being read, one within the other
  double xy_[2] = {0, 0};
  Index open_rings_ = 0;
  std::size_t mesh_faces_ = 0;
  DomainFile file_;
  bool failed_ = false;
  Error error_;
};

Role Reader::next_role() const {
  if (frames_.empty()) return Role::object;
  const Frame& frame = frames_.back();
  switch (frame.role) {
    case Role::object:
      if (frame.key == "features" || frame.key == "geometries") return Role::object_list;
      if (frame.key == "geometry") return Role::object;
      if (frame.key == "coordinates") return Role::coordinates;
      return frame.key == "properties" ? Role::properties : Role::ignored;
    case Role::object_list: return Role::object;
    case Role::coordinates: return Role::coordinates;
    default: return Role::ignored;
  }
}

bool Reader::open(Role role, bool is_array) {
  if (frames_.size() >= json_max_depth) return fail("The text is nested too deeply.");
  frames_.push_back({role, is_array, {}});
  return true;
}

bool Reader::start_object(std::size_t) {
  const Role role = next_role();
  if (role == Role::coordinates) return fail("Coordinates should be arrays of numbers.");
  if (role == Role::object_list) return fail("An array of objects was expected.");
  if (role == Role::object) {
    objects_.emplace_back();
    objects_.back().first_region = file_.domain.regions.size();
    objects_.back().first_polyline = file_.domain.polylines.size();
    objects_.back().first_point = file_.domain.points.size();
  }
  return open(role, false);
}

bool Reader::start_array(std::size_t) {
  const Role role = next_role();
  if (role == Role::object) return fail("A GeoJSON object was expected, but this is an array.");
  if (role == Role::coordinates && frames_.back().role == Role::object) {
    objects_.back().has_coordinates = true;
    objects_.back().coordinates = {};
  }
  if (role == Role::coordinates && frames_.back().numbers > 0)
    return fail("Numbers and arrays are mixed in coordinates.");
  return open(role, true);
}

/// null is fine for an absent geometry, properties or coordinates.
bool Reader::other_value() {
  const bool in_coordinates = !frames_.empty() && frames_.back().role == Role::coordinates;
  if (frames_.empty() || in_coordinates) return fail("A number or an array was expected.");
  return true;
}

bool Reader::number(double value) {
  if (frames_.empty()) return other_value();
  Frame& frame = frames_.back();
  if (frame.role == Role::properties && frame.key == "eta") objects_.back().has_eta = true;
  if (frame.role != Role::coordinates) return true;
  if (frame.height >= 0) return fail("Numbers and arrays are mixed in coordinates.");
  if (frame.numbers < 2) xy_[frame.numbers] = value;  // more are heights
  ++frame.numbers;
  return true;
}

bool Reader::string(string_t& value) {
  if (frames_.empty()) return other_value();
  const Frame& frame = frames_.back();
  if (frame.role == Role::coordinates) {
    if (value.empty() && text_.is_bare_literal())
      return fail(ErrorCode::non_finite, "A coordinate is NaN or infinite.");
    return fail("A coordinate should be a number, but it is a string.");
  }
  if (frame.role == Role::object && frame.key == "type") objects_.back().type = std::move(value);
  if (frame.role == Role::properties && frame.key == "name")
    objects_.back().name = std::move(value);
  if (frame.role == Role::properties && frame.key == "tag") objects_.back().tag = std::move(value);
  return true;
}

bool Reader::end_object() {
  const Role role = frames_.back().role;
  frames_.pop_back();
  if (role != Role::object) return true;
  Object object = std::move(objects_.back());
  objects_.pop_back();
  return end_of_object(std::move(object));
}

bool Reader::end_array() {
  const Frame frame = std::move(frames_.back());
  frames_.pop_back();
  return frame.role != Role::coordinates || end_of_coordinates(frame);
}

bool Reader::end_of_coordinates(const Frame& frame) {
  Coordinates& c = objects_.back().coordinates;
  int height = frame.height < 0 ? -1 : frame.height + 1;
  if (frame.numbers > 0) {
    if (frame.numbers < 2) return fail("A position needs two numbers.");
    c.points.push_back({xy_[0], xy_[1]});
    height = 0;
  }
  if (height < 0) return true;  // an empty array holds nothing
  if (height == 1) c.line_ends.push_back(c.points.size());
  if (height == 2) c.polygon_ends.push_back(c.line_ends.size());
  if (height > 3) return fail("Coordinates are nested too deeply.");
  Frame& parent = frames_.back();
  if (parent.role != Role::coordinates) {
    c.height = height;
    return true;
  }
  if (parent.height >= 0 && parent.height != height)
    return fail("Coordinates are nested unevenly.");
  parent.height = height;
  return true;
}

bool Reader::end_of_object(Object object) {
  const auto kind = static_cast<std::size_t>(
      std::find(std::begin(kinds), std::end(kinds), object.type) - std::begin(kinds));
  if (object.type.empty()) return fail("A GeoJSON object has no \"type\".");
  if (kind == std::size(kinds))
    return fail(object.type.substr(0, 40).append(" is not a type of GeoJSON."));
  if (kind < geometry_kinds && !add_geometry(kind, object)) return false;
  if (object.type == "Feature") name_parts(object);
  if (object.has_eta && object.has_region) count_mesh_faces(object.first_region);
  return true;
}

void Reader::count_mesh_faces(std::size_t first_region) {
  for (std::size_t i = first_region; i < file_.domain.regions.size(); ++i) {
    const std::vector<Loop>& loops = file_.domain.regions[i].loops;
    const std::size_t positions = loops.size() == 1 ? loops[0].size() : 0;
    if (positions == 4 || positions == 5) ++mesh_faces_;
  }
}

bool Reader::add_geometry(std::size_t kind, Object& object) {
  Coordinates& c = object.coordinates;
  if (!object.has_coordinates) return fail("A " + object.type + " has no \"coordinates\".");
  if (c.height < 0) return true;
  if (c.height != brackets[kind])
    return fail("The coordinates of a " + object.type + " are nested " +
                std::to_string(c.height + 1) + " deep; they should be nested " +
                std::to_string(brackets[kind] + 1) + " deep.");
  if (kind <= 1) {
    for (const Vec2 p : c.points) file_.domain.points.push_back({p, {}});
  } else if (kind <= 3) {
    std::size_t begin = 0;
    for (const std::size_t end : c.line_ends) {
      const auto at = c.points.begin();
      file_.domain.polylines.push_back(
          {{at + static_cast<std::ptrdiff_t>(begin), at + static_cast<std::ptrdiff_t>(end)}, {}});
      begin = end;
    }
  } else {
    add_polygons(c);
  }
  return true;
}

void Reader::add_polygons(const Coordinates& c) {
  std::size_t ring = 0, begin = 0;
  for (const std::size_t rings_end : c.polygon_ends) {
    file_.domain.regions.emplace_back();
    for (; ring < rings_end; ++ring) {
      const std::size_t end = c.line_ends[ring];
      const auto at = c.points.begin();
      file_.domain.regions.back().loops.emplace_back(at + static_cast<std::ptrdiff_t>(begin),
                                                     at + static_cast<std::ptrdiff_t>(end));
      if (!(c.points[begin] == c.points[end - 1])) ++open_rings_;
      begin = end;
    }
  }
}

void Reader::name_parts(const Object& feature) {
  DomainInput& domain = file_.domain;
  const std::string& tag = feature.tag.empty() ? feature.name : feature.tag;
  for (std::size_t i = feature.first_region; i < domain.regions.size(); ++i)
    domain.regions[i].name = feature.name;
  for (std::size_t i = feature.first_polyline; i < domain.polylines.size(); ++i)
    domain.polylines[i].tag = tag;
  for (std::size_t i = feature.first_point; i < domain.points.size(); ++i)
    domain.points[i].tag = tag;
}

}  // namespace

Result<DomainFile> read_geojson_domain(std::string_view text) {
  if (text.size() > json_max_text)
    return Error{ErrorCode::too_large, "The JSON text is larger than 1 GiB.", {}};
  JsonText json(text);
  return Reader(json).read();
}

bool looks_like_geojson(std::string_view text) {
  std::size_t depth = 0;
  std::string_view last, before;  // strings of the outermost object
  bool colon = false;             // between them
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '{' || c == '[') ++depth;
    if ((c == '}' || c == ']') && depth > 0) --depth;
    if (depth == 1 && c != '"' && c != ' ' && c != '\t' && c != '\r' && c != '\n') colon = c == ':';
    if (c != '"') continue;
    const std::size_t start = ++i;
    while (i < text.size() && text[i] != '"') i += text[i] == '\\' ? 2 : 1;
    if (depth != 1 || i > text.size()) continue;
    before = std::exchange(last, text.substr(start, i - start));
    const bool is_kind = std::find(std::begin(kinds), std::end(kinds), last) != std::end(kinds);
    if (colon && before == "type" && is_kind) return true;
    colon = false;
  }
  return false;
}

}  // namespace lpq
