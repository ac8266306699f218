// Every error of the library in words that need no manual.

/** @type {Record<string, string>} */
const titles = {
  PARSE_ERROR: 'This file cannot be read.',
  BAD_OPTION: 'An option has a value that the mesher does not take.',
  NON_FINITE: 'A coordinate or size is not a number.',
  EMPTY: 'There is nothing to mesh yet.',
  TOO_FEW_POINTS: 'An outline has fewer than three different corners.',
  DUPLICATE_POINT: 'Two points are at the same place.',
  ZERO_AREA: 'An outline encloses nothing.',
  SELF_INTERSECTION: 'Two edges cross.',
  OVERLAPPING_EDGES: 'Two edges lie on each other.',
  TOUCHING: 'Two outlines touch where they should stay apart.',
  HOLE_OUTSIDE: 'A hole or an inner line lies outside.',
  NESTED_OR_DUPLICATE_HOLE: 'A hole lies within another hole.',
  REGION_CONFLICT: 'Two regions overlap.',
  BAD_SIZE: 'The mesh size does not fit this domain.',
  ODD_BOUNDARY: 'The boundary has an odd number of edges.',
  TOO_NARROW: 'A gap is too narrow to be meshed.',
  LOST_PRECISION: 'The coordinates are too coarse for this mesh size.',
  TOO_MANY_ELEMENTS: 'This mesh would have too many elements.',
  TOO_LARGE: 'This is larger than what can be handled.',
  IGNORED: 'Something was left out, or has no effect.',
  ADAPTED: 'Something was changed, or read as something else.',
  NO_VALID_MESH: 'No good mesh was found for this domain.',
  OUT_OF_MEMORY: 'There is not enough memory for this mesh.',
  CANCELLED: 'You stopped this run.',
  IO_ERROR: 'A file could not be read.',
  NOT_LOADED: 'The mesher could not be loaded.',
  BAD_WASM: 'The mesher could not be loaded.',
  WORKER_LOST: 'The mesher stopped unexpectedly.',
};

/** @param {string} code */
export const titleOf = (code) => titles[code] ?? 'Something went wrong in the mesher.';
