// Domains from GeoJSON (RFC 7946). A Polygon is a region, a MultiPolygon one region for each of
// its parts, a LineString a polyline and a Point a mesh vertex inside (also their Multi kinds), at
// any depth of Feature, FeatureCollection and GeometryCollection. The property "name" of a Feature
// becomes the name of its regions, "tag" (else "name") the tag of its lines and points.
// Coordinates are taken as plain numbers: longitude and latitude in degrees are meshed as if they
// were lengths, so project them first where angles and sizes matter. Heights are ignored.
#pragma once

#include <string_view>

#include "base/result.h"
#include "io/domain/domain_file.h"

namespace lpq {

/// Errors: parse_error and non_finite with line and byte; too_large beyond 1 GiB.
Result<DomainFile> read_geojson_domain(std::string_view text);

/// True if the outermost object has a member "type" that names a kind of GeoJSON object.
bool looks_like_geojson(std::string_view text);

}  // namespace lpq
