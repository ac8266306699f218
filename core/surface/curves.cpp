#include "surface/curves.h"

#include "surface/corners.h"

namespace lpq {
namespace {

class Tracer {
 public:
  Tracer(const SurfaceMesh& mesh, const SurfaceFeatures& features)
      : mesh_(mesh),
        features_(features),
        at_(features.edges_at_vertices(mesh.vertex_count())),
        done_(features.kind.size()) {}

  SurfaceCurves run() {
    for (const bool from_corners : {true, false})
      for (Index v = 0; v < mesh_.vertex_count(); ++v) {
        if (from_corners && !features_.corner[v]) continue;
        for (const Index edge : at_.row(v))
          if (!done_[edge]) walk(v, edge);
      }
    curves_.at_face = csr_from<Index>(features_.face_count, [&](auto&& emit) {
      for (Index c = 0; c < curves_.count(); ++c) {
        const auto faces = curves_.faces.row(c);
        for (std::size_t k = 0; k < faces.size(); ++k)
          if (k == 0 || faces[k] != faces[k - 1]) emit(faces[k], c);
      }
    });
    return std::move(curves_);
  }

 private:
  void walk(Index v, Index edge) {
    const Index start = v;
    for (const Index face : faces_on_edge(features_, edge)) curves_.faces.values.push_back(face);
    curves_.vertices.values.push_back(v);
    for (;;) {
      done_[edge] = 1;
      curves_.edges.values.push_back(edge);
      v = features_.edges.other_end(edge, v);
      curves_.vertices.values.push_back(v);
      if (features_.corner[v] || v == start) break;
      const auto next = at_.row(v);
      edge = next[0] == edge ? next[1] : next[0];
    }
    curves_.vertices.end_row();
    curves_.edges.end_row();
    curves_.faces.end_row();
    curves_.is_loop.push_back(!features_.corner[start]);
  }

  const SurfaceMesh& mesh_;
  const SurfaceFeatures& features_;
  Csr<Index> at_;           // #V  features at the vertex
  std::vector<char> done_;  // #E
  SurfaceCurves curves_;
};

}  // namespace

SurfaceCurves trace_curves(const SurfaceMesh& mesh, const SurfaceFeatures& features) {
  return Tracer(mesh, features).run();
}

}  // namespace lpq
