// See marshal.h.
#include "marshal.h"

#include <emscripten/bind.h>

#include <algorithm>

#include "io/error_text.h"

namespace lpq {
namespace {

template <class T>
val copied(std::size_t count, const T* values) {
  return val(emscripten::typed_memory_view(count, values)).template call<val>("slice");
}

/// Reads consecutive pieces of an array.
template <class T>
class Cursor {
 public:
  explicit Cursor(std::vector<T> values) : values_(std::move(values)) {}
  T next() { return at_ < values_.size() ? values_[at_++] : T(); }
  std::vector<T> take(Index count) {
    const std::size_t end = std::min(values_.size(), at_ + static_cast<std::size_t>(count));
    std::vector<T> piece(values_.begin() + static_cast<std::ptrdiff_t>(at_),
                         values_.begin() + static_cast<std::ptrdiff_t>(end));
    at_ = end;
    return piece;
  }
  std::vector<T> rest() { return take(static_cast<Index>(values_.size() - at_)); }

 private:
  std::vector<T> values_;
  std::size_t at_ = 0;
};

std::string name_at(const std::vector<std::string>& names, Index i) {
  return i >= 0 && static_cast<std::size_t>(i) < names.size() ? names[static_cast<std::size_t>(i)]
                                                              : std::string();
}

std::vector<Index> column(const OutputMesh& mesh, Index OutputEdge::*member) {
  std::vector<Index> values;
  for (const OutputEdge& edge : mesh.edges) values.push_back(edge.*member);
  return values;
}

std::vector<Index> regions_of_faces(const OutputMesh& mesh, int corners) {
  std::vector<Index> values;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (corner_count(mesh.faces[f]) == corners) values.push_back(mesh.region[f]);
  return values;
}

void append_faces(OutputMesh& mesh, const val& corners, const val& regions, std::size_t count) {
  const std::vector<Index> nodes = indices_from(corners), region = indices_from(regions);
  for (std::size_t f = 0; f + 1 <= nodes.size() / count; ++f) {
    Face face{none, none, none, none};
    for (std::size_t k = 0; k < count; ++k) face[k] = nodes[f * count + k];
    mesh.faces.push_back(face);
    mesh.region.push_back(f < region.size() ? region[f] : none);
  }
}

Error bad_mesh(const char* array) {
  return {ErrorCode::parse_error,
          std::string("The mesh's array ") + array +
              " refers to something that is not there. Pass a mesh as meshDomain returns it.",
          {}};
}

void set_points(const OutputMesh& mesh, val& js) {
  if (!mesh.in_space()) {
    js.set("points", to_array(mesh.points));
    return;
  }
  std::vector<Vec3> points;
  for (Index v = 0; v < static_cast<Index>(mesh.points.size()); ++v)
    points.push_back(mesh.point(v));
  js.set("dimension", 3);
  js.set("points", to_array(points));
}

std::vector<Vec3> points_in_space_from(const val& array) {
  const std::vector<double> values = doubles_from(array);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3)
    points.push_back({values[i], values[i + 1], values[i + 2]});
  return points;
}

void read_points(const val& js, OutputMesh& mesh) {
  const val dimension = js["dimension"];
  if (!dimension.isNumber() || dimension.as<double>() != 3) {
    mesh.points = points_from(js["points"]);
    return;
  }
  for (const Vec3 p : points_in_space_from(js["points"])) {
    mesh.points.push_back({p.x, p.y});
    mesh.z.push_back(p.z);
  }
}

/// The first array with an index that no writer could follow; nullptr if all is well.
const char* out_of_range(const OutputMesh& mesh) {
  const auto outside = [](Index i, std::size_t count) {
    return i < 0 || static_cast<std::size_t>(i) >= count;
  };
  const auto named = [&](Index i, std::size_t count) { return i != none && outside(i, count); };
  const std::size_t points = mesh.points.size(), tags = mesh.tags.size();
  const std::size_t regions = mesh.regions.size();
  for (const Face& face : mesh.faces)
    for (int k = 0; k < corner_count(face); ++k)
      if (outside(face[k], points)) return "quads or triangles";
  for (const Index region : mesh.region)
    if (outside(region, regions)) return "quadRegions or triangleRegions";
  for (const OutputEdge& e : mesh.edges)
    if (outside(e.a, points) || outside(e.b, points) || named(e.left, regions) ||
        named(e.right, regions) || named(e.tag, tags))
      return "edges";
  for (const OutputPoint& p : mesh.tagged_points)
    if (outside(p.point, points) || outside(p.tag, tags)) return "taggedPoints";
  return outside(mesh.fixed, points + 1) ? "boundaryNodes" : nullptr;
}

}  // namespace

val to_array(std::span<const double> values) { return copied(values.size(), values.data()); }
val to_array(std::span<const Vec2> points) {
  return copied(2 * points.size(), reinterpret_cast<const double*>(points.data()));
}
val to_array(std::span<const Vec3> points) {
  return copied(3 * points.size(), reinterpret_cast<const double*>(points.data()));
}
val to_array(std::span<const Index> values) { return copied(values.size(), values.data()); }

val to_indices(std::span<const Index> values) {
  return copied(values.size(), reinterpret_cast<const std::uint32_t*>(values.data()));
}

val to_corners(std::span<const Face> faces, int corners) {
  std::vector<Index> nodes;
  for (const Face& face : faces)
    if (corner_count(face) == corners)
      nodes.insert(nodes.end(), face.begin(), face.begin() + corners);
  return to_indices(nodes);
}
val to_corners(std::span<const Tri> triangles) {
  return to_indices({reinterpret_cast<const Index*>(triangles.data()), 3 * triangles.size()});
}

val to_pairs(std::span<const std::array<Index, 2>> pairs) {
  return to_indices({reinterpret_cast<const Index*>(pairs.data()), 2 * pairs.size()});
}

val to_strings(const std::vector<std::string>& texts) {
  val array = val::array();
  for (const std::string& text : texts) array.call<void>("push", text);
  return array;
}

std::vector<double> doubles_from(const val& array) {
  return emscripten::convertJSArrayToNumberVector<double>(array);
}
std::vector<Vec2> points_from(const val& array) {
  const std::vector<double> values = doubles_from(array);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i + 1 < values.size(); i += 2)
    points.push_back({values[i], values[i + 1]});
  return points;
}
std::vector<Index> indices_from(const val& array) {
  return emscripten::convertJSArrayToNumberVector<Index>(array);
}
std::vector<std::string> strings_from(const val& array) {
  return emscripten::vecFromJSArray<std::string>(array);
}

DomainInput domain_from(const val& packed) {
  DomainInput domain;
  Cursor points(points_from(packed["points"]));
  Cursor sizes(indices_from(packed["sizes"])), loops(indices_from(packed["loopsPerRegion"]));
  Cursor edge_tags(indices_from(packed["edgeTags"]));
  const bool tagged = packed["edgeTags"]["length"].as<double>() > 0;
  const std::vector<std::string> tags = strings_from(packed["tags"]);
  for (const std::string& name : strings_from(packed["regions"])) {
    DomainInput::Region region{name, {}, {}};
    for (Index k = loops.next(); k > 0; --k) {
      region.loops.push_back(points.take(sizes.next()));
      if (!tagged) continue;
      region.tags.emplace_back();
      for (const Index tag : edge_tags.take(static_cast<Index>(region.loops.back().size())))
        region.tags.back().push_back(name_at(tags, tag));
    }
    domain.regions.push_back(std::move(region));
  }
  for (const Index tag : indices_from(packed["polylineTags"]))
    domain.polylines.push_back({points.take(sizes.next()), name_at(tags, tag)});
  for (const Index tag : indices_from(packed["pointTags"]))
    domain.points.push_back({points.next(), name_at(tags, tag)});
  domain.h = packed["h"].as<double>();
  domain.sizes = sizes_from(packed["sizesAt"]);
  domain.guides = guides_from(packed["guides"]);
  domain.seeds = points_from(packed["seeds"]);
  return domain;
}

std::vector<DomainInput::SizeAt> sizes_from(const val& array) {
  const std::vector<double> at = doubles_from(array);
  std::vector<DomainInput::SizeAt> sizes;
  for (std::size_t i = 0; i + 2 < at.size(); i += 3)
    sizes.push_back({{at[i], at[i + 1]}, at[i + 2]});
  return sizes;
}

std::vector<DomainInput::Guide> guides_from(const val& packed) {
  Cursor points(points_from(packed["points"]));
  std::vector<DomainInput::Guide> guides;
  for (const Index count : indices_from(packed["sizes"])) guides.push_back(points.take(count));
  return guides;
}

SurfaceSoup soup_from(const val& packed) {
  SurfaceSoup soup;
  soup.points = points_in_space_from(packed["points"]);
  const std::vector<Index> corners = indices_from(packed["triangles"]);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    soup.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  soup.group = indices_from(packed["groups"]);
  soup.group_names = strings_from(packed["groupNames"]);
  soup.sizes = doubles_from(packed["sizes"]);
  soup.body = indices_from(packed["bodies"]);
  soup.body_names = strings_from(packed["bodyNames"]);
  return soup;
}

val to_js(const OutputMesh& mesh) {
  std::vector<Index> ends, sides, origin, points, tags;
  for (const OutputEdge& e : mesh.edges) {
    ends.insert(ends.end(), {e.a, e.b});
    sides.insert(sides.end(), {e.left, e.right});
    origin.insert(origin.end(), {e.region, e.loop, e.edge});
  }
  for (const OutputPoint& p : mesh.tagged_points) {
    points.push_back(p.point);
    tags.push_back(p.tag);
  }
  val js = val::object();
  set_points(mesh, js);
  js.set("quads", to_corners(mesh.faces, 4));
  js.set("quadRegions", to_array(regions_of_faces(mesh, 4)));
  js.set("triangles", to_corners(mesh.faces, 3));
  js.set("triangleRegions", to_array(regions_of_faces(mesh, 3)));
  js.set("edges", to_indices(ends));
  js.set("edgeTags", to_array(column(mesh, &OutputEdge::tag)));
  js.set("edgeRegions", to_array(sides));
  js.set("edgeOrigins", to_array(origin));
  js.set("taggedPoints", to_indices(points));
  js.set("pointTags", to_array(tags));
  js.set("regions", to_strings(mesh.regions));
  js.set("tags", to_strings(mesh.tags));
  js.set("boundaryNodes", mesh.fixed);
  return js;
}

Result<OutputMesh> mesh_from(const val& js) {
  OutputMesh mesh;
  read_points(js, mesh);
  append_faces(mesh, js["quads"], js["quadRegions"], 4);
  append_faces(mesh, js["triangles"], js["triangleRegions"], 3);
  Cursor ends(indices_from(js["edges"])), sides(indices_from(js["edgeRegions"]));
  Cursor origins(indices_from(js["edgeOrigins"]));
  for (const Index tag : indices_from(js["edgeTags"])) {
    const std::vector<Index> end = ends.take(2), side = sides.take(2), origin = origins.take(3);
    if (end.size() < 2 || side.size() < 2 || origin.size() < 3) return bad_mesh("edges");
    mesh.edges.push_back({end[0], end[1], side[0], side[1], tag, origin[0], origin[1], origin[2]});
  }
  const std::vector<Index> points = indices_from(js["taggedPoints"]);
  const std::vector<Index> tags = indices_from(js["pointTags"]);
  if (points.size() != tags.size()) return bad_mesh("taggedPoints");
  for (std::size_t i = 0; i < points.size(); ++i)
    mesh.tagged_points.push_back({points[i], tags[i]});
  mesh.regions = strings_from(js["regions"]);
  mesh.tags = strings_from(js["tags"]);
  mesh.fixed = js["boundaryNodes"].as<Index>();
  if (const char* name = out_of_range(mesh)) return bad_mesh(name);
  return mesh;
}

val failure(const Error& error) {
  val result = val::object();
  result.set("error", write_error_json(error));
  return result;
}

Error out_of_memory() {
  return {
      ErrorCode::out_of_memory, "There is not enough memory for this mesh. Use a larger size.", {}};
}

val text_result(const std::string& text) {
  val result = val::object();
  result.set("text", text);
  return result;
}

}  // namespace lpq
