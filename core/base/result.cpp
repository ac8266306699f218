#include "base/result.h"

namespace lpq {

const char* code_name(ErrorCode code) {
  switch (code) {
    case ErrorCode::parse_error: return "PARSE_ERROR";
    case ErrorCode::bad_option: return "BAD_OPTION";
    case ErrorCode::non_finite: return "NON_FINITE";
    case ErrorCode::empty: return "EMPTY";
    case ErrorCode::too_few_points: return "TOO_FEW_POINTS";
    case ErrorCode::duplicate_point: return "DUPLICATE_POINT";
    case ErrorCode::zero_area: return "ZERO_AREA";
    case ErrorCode::self_intersection: return "SELF_INTERSECTION";
    case ErrorCode::overlapping_edges: return "OVERLAPPING_EDGES";
    case ErrorCode::touching: return "TOUCHING";
    case ErrorCode::hole_outside: return "HOLE_OUTSIDE";
    case ErrorCode::nested_or_duplicate_hole: return "NESTED_OR_DUPLICATE_HOLE";
    case ErrorCode::region_conflict: return "REGION_CONFLICT";
    case ErrorCode::bad_size: return "BAD_SIZE";
    case ErrorCode::odd_boundary: return "ODD_BOUNDARY";
    case ErrorCode::too_narrow: return "TOO_NARROW";
    case ErrorCode::lost_precision: return "LOST_PRECISION";
    case ErrorCode::too_many_elements: return "TOO_MANY_ELEMENTS";
    case ErrorCode::too_large: return "TOO_LARGE";
    case ErrorCode::ignored: return "IGNORED";
    case ErrorCode::adapted: return "ADAPTED";
    case ErrorCode::no_valid_mesh: return "NO_VALID_MESH";
    case ErrorCode::out_of_memory: return "OUT_OF_MEMORY";
    case ErrorCode::cancelled: return "CANCELLED";
    case ErrorCode::io_error: return "IO_ERROR";
  }
  return "UNKNOWN";
}

}  // namespace lpq
