// JavaScript values to core values and back. Everything crosses by copy, as typed arrays: a view
// into the heap would die with its next growth.
#pragma once

#include <emscripten/val.h>

#include <new>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "domain/domain.h"
#include "geometry/vec3.h"
#include "mesh/output_mesh.h"
#include "mesh/tri_mesh.h"
#include "surface/soup.h"

namespace lpq {

using emscripten::val;

val to_array(std::span<const double> values);   // Float64Array
val to_array(std::span<const Vec2> points);     // Float64Array  x0, y0, x1, ...
val to_array(std::span<const Vec3> points);     // Float64Array  x0, y0, z0, x1, ...
val to_array(std::span<const Index> values);    // Int32Array
val to_indices(std::span<const Index> values);  // Uint32Array, for values that are never none
/// Corners of the faces with that many of them; Uint32Array, `corners` per face.
val to_corners(std::span<const Face> faces, int corners);
val to_corners(std::span<const Tri> triangles);
val to_pairs(std::span<const std::array<Index, 2>> pairs);  // Uint32Array
val to_strings(const std::vector<std::string>& texts);

std::vector<double> doubles_from(const val& array);
std::vector<Vec2> points_from(const val& array);
std::vector<Index> indices_from(const val& array);
std::vector<std::string> strings_from(const val& array);

/// The packed form that js/domain.js makes of whatever the caller gave:
///   regions: string[], loopsPerRegion: Int32Array,
///   sizes: Int32Array     points of each loop, then of each polyline
///   points: Float64Array  of all loops, all polylines, then the single points
///   tags: string[], edgeTags: Int32Array (per loop edge, -1 = untagged; empty = none),
///   polylineTags, pointTags: Int32Array, h: number, sizesAt, guides: as below,
///   seeds: Float64Array
DomainInput domain_from(const val& packed);

/// Float64Array x, y, h, ...
std::vector<DomainInput::SizeAt> sizes_from(const val& array);
/// {points: Float64Array of all guides, sizes: Int32Array of their numbers of points}
std::vector<DomainInput::Guide> guides_from(const val& packed);

/// The packed form that js/surface.js makes: {points: Float64Array x, y, z, ..; triangles:
/// Uint32Array; groups: Int32Array, empty = none; groupNames: string[];
/// bodies: Int32Array, empty = one; bodyNames: string[]; sizes: Float64Array, empty = none}
SurfaceSoup soup_from(const val& packed);

/// The arrays of MeshResult in js/index.d.ts, or those of SurfaceMesh for a mesh in space; `report`
/// is added by the caller.
val to_js(const OutputMesh& mesh);
/// Errors: parse_error for an index that leads nowhere. Lengths that do not fit are named by
/// js/checks.js before.
Result<OutputMesh> mesh_from(const val& mesh);

/// {error: {code, message, where}} as JSON text, which js/errors.js turns into a LpquadError.
val failure(const Error& error);
Error out_of_memory();

/// {text}
val text_result(const std::string& text);

/// Running out of memory ends the call, not the instance: everything it held is freed on the way.
template <class Work>
val guarded(Work&& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return failure(out_of_memory());
  }
}

}  // namespace lpq
