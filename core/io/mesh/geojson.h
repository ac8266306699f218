// GeoJSON (RFC 7946) for maps: QGIS, Leaflet, PostGIS. Coordinates are written as they are; RFC
// 7946 reads them as degrees of longitude and latitude.
#pragma once

#include <string>

#include "mesh/output_mesh.h"

namespace lpq {

/// A FeatureCollection: a Polygon per face, counter-clockwise, with `region` (name or null) and
/// `eta`; a LineString per run of 1D edges with equal tag and regions, with `tag` (name or null),
/// `left` and `right` (names of regions or null); a Point per tagged point, with `tag`.
std::string write_geojson(const OutputMesh& mesh);

}  // namespace lpq
