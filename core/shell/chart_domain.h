// A chart as a planar domain with a given boundary mesh: the nodes of its curves, mapped to the
// plane. A cut runs along it twice, once on each side; what is a feature inside becomes a polyline.
#pragma once

#include <vector>

#include "domain/domain.h"
#include "shell/curve_nodes.h"
#include "surface/charts/charts.h"

namespace lpq {

struct ChartDomain {
  DomainInput input;
  /// Where each node lies in the plane; nodes on cuts several times. Sorted by position.
  struct Place {
    Vec2 position;
    Index node;
  };
  std::vector<Place> places;

  /// Node at exactly this position, none if there is none.
  Index node_at(Vec2 position) const;
};

ChartDomain chart_domain(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                         const SurfaceCurves& curves, const Atlas& atlas, const Chart& chart,
                         const CurveNodes& nodes);

}  // namespace lpq
