// See iterates.h.
#include "io/iterates.h"

#include <cstring>

#include "io/json_write.h"
#include "lpcvt/energy.h"

namespace lpq {
namespace {

template <class Bits>
void append_bits(std::string& out, Bits bits) {
  for (std::size_t k = 0; k < sizeof bits; ++k)
    out += static_cast<char>(static_cast<unsigned char>(bits >> (8 * k)));
}

void append(std::string& out, double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  append_bits(out, bits);
}
void append(std::string& out, Vec2 p) {
  append(out, p.x);
  append(out, p.y);
}
void append(std::string& out, Index value) { append_bits(out, static_cast<std::uint32_t>(value)); }

/// Voronoi cells in pieces, as a CellLayer has them.
struct Pieces {
  Csr<Vec2> corners;
  std::vector<Index> site;
};

Pieces pieces_of(const TriMesh& mesh, const UnitFrame& frame) {
  Pieces pieces;
  ClippedVoronoi diagram;
  clip_voronoi(mesh, diagram);
  const auto cells = cell_polygons(mesh, diagram);
  for (std::size_t v = 0; v < cells.size(); ++v)
    for (const std::vector<Vec2>& polygon : cells[v]) {
      for (const Vec2 p : polygon) pieces.corners.values.push_back(frame.to_world(p));
      pieces.corners.end_row();
      pieces.site.push_back(static_cast<Index>(v));
    }
  return pieces;
}

/// Appends iterates one after the other; the workspace is theirs in turn.
class Writer {
 public:
  explicit Writer(const Trace& trace) : trace_(trace), json_(text_) {
    json_.begin_object();
    json_.member("boundaryNodes", trace.start.fixed);
    json_.begin_array("iterates");
  }

  void add(const Iterate& iterate) {
    const TriMesh& mesh = iterate.mesh;
    const Pieces pieces = pieces_of(mesh, trace_.frame);
    describe(iterate, pieces);
    for (const Vec2 p : mesh.points) append(bytes_, trace_.frame.to_world(p));
    append_densities(mesh);
    for (const Vec2 p : pieces.corners.values) append(bytes_, p);
    for (const Tri& t : mesh.triangles)
      for (const Index v : t) append(bytes_, v);
    for (const Index v : pieces.site) append(bytes_, v);
    for (const Index k : pieces.corners.offsets) append(bytes_, k);
    if (bytes_.size() % sizeof(double) != 0) append(bytes_, Index{0});
  }

  void write(FileSink sink) {
    json_.end_array();
    json_.end_object();
    text_ += '\n';
    sink("iterates.json", text_);
    sink("iterates.bin", bytes_);
  }

 private:
  void describe(const Iterate& iterate, const Pieces& pieces) {
    json_.new_line();
    json_.begin_object();
    json_.member("iteration", iterate.iteration);
    json_.member("points", iterate.mesh.points.size());
    json_.member("triangles", iterate.mesh.triangles.size());
    json_.member("pieces", pieces.site.size());
    json_.member("corners", pieces.corners.values.size());
    json_.end_object();
  }

  void append_densities(const TriMesh& mesh) {
    EnergyOptions energy;
    energy.p = trace_.norm;
    workspace_.hints.clear();  // restarts number the vertices anew
    lp_energy(mesh, *trace_.fields, energy, workspace_, {});
    const double area_unit = trace_.frame.scale * trace_.frame.scale;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const double area = workspace_.cell_area[v];
      append(bytes_, area > 0 ? workspace_.cell_energy[v] / area * area_unit : 0);
    }
  }

  const Trace& trace_;
  EnergyWorkspace workspace_;
  std::string text_, bytes_;
  JsonWriter json_;
};

}  // namespace

void write_iterates(const Trace& trace, FileSink sink) {
  if (trace.iterates.empty()) return;
  Writer writer(trace);
  for (const Iterate& iterate : trace.iterates) writer.add(iterate);
  writer.write(sink);
}

}  // namespace lpq
