#include "surface/face_borders.h"

#include <algorithm>
#include <numeric>

#include "numerics/elementary.h"
#include "surface/border_turns.h"
#include "surface/fans.h"

namespace lpq {
namespace {

class BorderWalker {
 public:
  BorderWalker(const SurfaceMesh& mesh, const SurfaceFeatures& features,
               const SurfaceCurves& curves, std::span<const double> steps)
      : mesh_(mesh),
        features_(features),
        curve_of_(features.kind.size(), none),
        size_(steps.size(), 1),
        done_(mesh.twins.size(), 0) {
    for (Index c = 0; c < curves.count(); ++c) {
      double length = 0;
      for (const Index edge : curves.edges.row(c)) {
        curve_of_[edge] = c;
        length += distance(mesh.points[features.edges.ends[edge][0]],
                           mesh.points[features.edges.ends[edge][1]]);
      }
      if (length > 0 && steps[c] > 0) size_[c] = length / steps[c];
    }
  }

  /// In order of their first half-edge, those that start at a corner before those without one.
  std::vector<FaceBorder> run() {
    std::vector<FaceBorder> borders;
    for (const bool from_corners : {true, false})
      for (Index e = 0; e < static_cast<Index>(mesh_.twins.size()); ++e)
        if (!done_[e] && features_.half_edge_is_feature(e) &&
            features_.corner[mesh_.origin(e)] == from_corners)
          borders.push_back(walk(e));
    return borders;
  }

 private:
  FaceBorder walk(Index e) {
    const Index face = features_.face[triangle_of(e)];
    std::vector<BorderStep> steps;
    while (!done_[e]) {
      done_[e] = 1;
      BorderStep step;
      step.curve = curve_of_[features_.edges.edge_of[e]];
      step.edge = mesh_.points[mesh_.target(e)] - mesh_.points[mesh_.origin(e)];
      step.length = length(step.edge) / size_[step.curve];
      step.ends_curve = features_.corner[mesh_.target(e)];
      double inside = 0;
      e = next_on_border(e, inside);
      step.turn = pi - inside;
      steps.push_back(step);
    }
    double angle = 0;
    for (const BorderStep& step : steps) angle += step.turn;
    FaceBorder border = border_of(std::move(steps));
    border.face = face;
    border.angle = angle;
    return border;
  }

  /// Goes round the target of e, adding up the angles of the face there.
  Index next_on_border(Index e, double& angle) const {
    for (e = next_in_triangle(e);; e = next_in_triangle(mesh_.twins[e])) {
      angle += corner_angle(mesh_, e);
      if (features_.half_edge_is_feature(e)) return e;
    }
  }

  const SurfaceMesh& mesh_;
  const SurfaceFeatures& features_;
  std::vector<Index> curve_of_;  // #E
  std::vector<double> size_;     // #C  mean mesh size
  std::vector<char> done_;       // #half-edges
};

}  // namespace

Index direction_after(Index right_angles) {
  return (right_angles % right_angles_round + right_angles_round) % right_angles_round;
}

Index BorderSide::main_direction() const {
  return static_cast<Index>(std::max_element(length.begin(), length.end()) - length.begin());
}

double BorderSide::whole() const { return std::accumulate(length.begin(), length.end(), 0.0); }

std::vector<FaceBorder> face_borders(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                                     const SurfaceCurves& curves, std::span<const double> steps) {
  return BorderWalker(mesh, features, curves, steps).run();
}

}  // namespace lpq
