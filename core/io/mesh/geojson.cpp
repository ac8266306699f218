// See geojson.h.
#include "io/mesh/geojson.h"

#include "io/json_write.h"
#include "io/mesh/output_parts.h"

namespace lpq {
namespace {

class GeoJsonWriter {
 public:
  explicit GeoJsonWriter(const OutputMesh& mesh) : mesh_(mesh), json_(out_) {}

  std::string write() {
    json_.begin_object();
    json_.member("type", "FeatureCollection");
    json_.begin_array("features");
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) face(f);
    for (std::size_t e = 0; e < mesh_.edges.size();) e = run(e);
    for (const OutputPoint& point : mesh_.tagged_points) {
      open("Point");
      position(point.point);
      properties();
      name("tag", mesh_.tags, point.tag);
      close();
    }
    json_.end_array();
    json_.end_object();
    out_ += '\n';
    return std::move(out_);
  }

 private:
  /// Up to the value of "coordinates".
  void open(const char* type) {
    json_.new_line();
    json_.begin_object();
    json_.member("type", "Feature");
    json_.begin_object("geometry");
    json_.member("type", type);
    json_.key("coordinates");
  }
  void properties() {
    json_.end_object();
    json_.begin_object("properties");
  }
  void close() {
    json_.end_object();
    json_.end_object();
  }
  void position(Index v) {
    const Vec3 p = mesh_.point(v);
    if (mesh_.in_space()) return json_.tuple(p.x, p.y, p.z);
    json_.tuple(p.x, p.y);
  }
  void name(const char* key, const std::vector<std::string>& names, Index i) {
    json_.key(key);
    if (i == none || names[static_cast<std::size_t>(i)].empty()) return json_.null();
    json_.value(names[static_cast<std::size_t>(i)]);
  }

  void face(std::size_t f) {
    const Face& corners = mesh_.faces[f];
    open("Polygon");
    json_.begin_array();
    json_.begin_array();
    for (int k = 0; k < corner_count(corners); ++k) position(corners[k]);
    position(corners[0]);
    json_.end_array();
    json_.end_array();
    properties();
    name("region", mesh_.regions, mesh_.region[f]);
    json_.member("eta", output_eta(mesh_, corners));
    close();
  }

  /// Writes the edges from `first` on that continue one another; returns the next one.
  std::size_t run(std::size_t first) {
    const OutputEdge& edge = mesh_.edges[first];
    open("LineString");
    json_.begin_array();
    position(edge.a);
    position(edge.b);
    std::size_t next = first + 1;
    for (; next < mesh_.edges.size(); ++next) {
      const OutputEdge& other = mesh_.edges[next];
      if (other.a != mesh_.edges[next - 1].b || other.tag != edge.tag || other.left != edge.left ||
          other.right != edge.right) {
        break;
      }
      position(other.b);
    }
    json_.end_array();
    properties();
    name("tag", mesh_.tags, edge.tag);
    name("left", mesh_.regions, edge.left);
    name("right", mesh_.regions, edge.right);
    close();
    return next;
  }

  const OutputMesh& mesh_;
  std::string out_;
  JsonWriter json_;
};

}  // namespace

std::string write_geojson(const OutputMesh& mesh) { return GeoJsonWriter(mesh).write(); }

}  // namespace lpq
