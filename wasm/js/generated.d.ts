// Made by wasm/types.mjs from the option tables of the core; do not edit.

export interface MeshOptions {
  /**
   * Target edge length; 0 takes the domain's own h (about 1000 quads where it has none), or the boundary's spacing when it is kept.
   * Unit: length.
   * Range: 0 to 1e+300.
   * @default 0
   */
  size?: number;
  /**
   * About how many quads, in place of a size, which is chosen for them; 0 = not asked.
   * A whole number.
   * Range: 0 to 100000000.
   * @default 0
   */
  quads?: number;
  /**
   * The given points are the boundary mesh and come back bit for bit.
   * @default false
   */
  keepBoundary?: boolean;
  /**
   * quad: no triangle at all; one-triangle: just one where a kept boundary has an odd count, placed where it costs least; quad-dominant: a triangle may stay where it is better.
   * @default "quad"
   */
  elements?: 'quad' | 'one-triangle' | 'quad-dominant';
  /**
   * best: the chain of stages that measures best; paper: isotropic start, L_p, Blossom, smoothing.
   * @default "best"
   */
  method?: 'best' | 'paper';
  /**
   * high: irregular vertices are moved about and cancelled for much longer; in the plane four other sizes are tried instead of two.
   * @default "normal"
   */
  effort?: 'normal' | 'high';
  /**
   * Initial points: aligned with the cross field, isotropic, or what the method prefers.
   * @default "automatic"
   */
  seeds?: 'automatic' | 'aligned' | 'isotropic';
  /**
   * Exponent p of the L_p energy.
   * Range: 2 to 20.
   * @default 6
   */
  norm?: number;
  /**
   * L-BFGS iterations; -1 is 80, but none for an aligned start of the best chain.
   * A whole number.
   * Range: -1 to 100000.
   * @default -1
   */
  iterations?: number;
  /**
   * Rounds after these that insert points in gaps, remove some where they crowd, and iterate 30 times; -1 is 10 for an isotropic start of the best chain whose iterations are left to us, else none.
   * A whole number.
   * Range: -1 to 1000.
   * @default -1
   */
  restarts?: number;
  /**
   * Seed of the isotropic start's jitter, and of what high effort draws at random.
   * A whole number.
   * Range: 0 to 9007199254740991.
   * @default 1
   */
  seed?: number;
  /**
   * Largest slope of the size field; 0 is 0.08, or up to 0.3 where 0.08 would cost more than 5000 elements over 0.3.
   * Range: 0 to 10.
   * @default 0
   */
  growth?: number;
  /**
   * Boundary vertices may be dropped when the outline moves by at most this (not with keepBoundary).
   * Unit: length.
   * Range: 0 to 1e+300.
   * @default 0
   */
  simplify?: number;
  /**
   * A kept boundary with an odd count may get one added point (rather than one triangle).
   * @default false
   */
  allowAddedPoint?: boolean;
  /**
   * Repeated consecutive points are an error instead of merged with a warning.
   * @default false
   */
  strict?: boolean;
  /**
   * What keeping to the target size is worth beside right angles; with 0 only the angles count.
   * Range: 0 to 10.
   * @default 0.12
   */
  sizeWeight?: number;
  /**
   * Iterations of the final smoothing; -1 is 100 for the paper's chain, else 300, or 600 with high effort.
   * A whole number.
   * Range: -1 to 10000.
   * @default -1
   */
  smoothing?: number;
  /**
   * Refuse before allocating when more elements than this are expected.
   * A whole number.
   * Range: 1 to 100000000.
   * @default 10000000
   */
  maxElements?: number;
}

export interface SurfaceOptions {
  /**
   * Target edge length; 0 gives about 3000 quads.
   * Unit: length.
   * Range: 0 to 1e+300.
   * @default 0
   */
  size?: number;
  /**
   * About how many quads, in place of a size, which is chosen for them; 0 = not asked.
   * A whole number.
   * Range: 0 to 100000000.
   * @default 0
   */
  quads?: number;
  /**
   * Edges that bend by more are kept as edges of the mesh.
   * Unit: degrees.
   * Range: 0 to 180.
   * @default 40
   */
  featureAngle?: number;
  /**
   * Borders between the groups of the file are kept as edges.
   * @default true
   */
  keepGroups?: boolean;
  /**
   * Smaller quads where the surface would turn by more over one; 0 = not asked.
   * Unit: degrees.
   * Range: 0 to 90.
   * @default 0
   */
  turn?: number;
  /**
   * Largest slope of the size field; 0 is 0.3.
   * Range: 0 to 10.
   * @default 0
   */
  growth?: number;
  /**
   * Points nearer than this share of the diagonal become one.
   * Range: 0 to 0.01.
   * @default 1e-10
   */
  weld?: number;
  /**
   * best: the chain of stages that measures best; paper: isotropic start, L_p, Blossom, smoothing, in every chart, and nothing after.
   * @default "best"
   */
  method?: 'best' | 'paper';
  /**
   * high: irregular vertices are moved about and cancelled for much longer; in the plane four other sizes are tried instead of two.
   * @default "normal"
   */
  effort?: 'normal' | 'high';
  /**
   * Initial points: aligned with the cross field, isotropic, or what the method prefers.
   * @default "automatic"
   */
  seeds?: 'automatic' | 'aligned' | 'isotropic';
  /**
   * Exponent p of the L_p energy.
   * Range: 2 to 20.
   * @default 6
   */
  norm?: number;
  /**
   * L-BFGS iterations; -1 is 80, but none for an aligned start of the best chain.
   * A whole number.
   * Range: -1 to 100000.
   * @default -1
   */
  iterations?: number;
  /**
   * Rounds after these that insert points in gaps, remove some where they crowd, and iterate 30 times; -1 is 10 for an isotropic start of the best chain whose iterations are left to us, else none.
   * A whole number.
   * Range: -1 to 1000.
   * @default -1
   */
  restarts?: number;
  /**
   * Seed of random choices.
   * A whole number.
   * Range: 0 to 9007199254740991.
   * @default 1
   */
  seed?: number;
  /**
   * What keeping to the target size is worth beside right angles; with 0 only the angles count.
   * Range: 0 to 10.
   * @default 0.11
   */
  sizeWeight?: number;
  /**
   * Iterations of the final smoothing; -1 leaves it to the mesher.
   * A whole number.
   * Range: -1 to 10000.
   * @default -1
   */
  smoothing?: number;
  /**
   * Refuse before allocating when more elements than this are expected.
   * A whole number.
   * Range: 1 to 100000000.
   * @default 10000000
   */
  maxElements?: number;
}

export interface WriteOptions {
  /**
   * Version of .msh files.
   * @default "4.1"
   */
  mshVersion?: '4.1' | '2.2';
  /**
   * Elements of .inp files: plane stress, plane strain, axisymmetric or shell.
   * @default "CPS4"
   */
  inpElement?: 'CPS4' | 'CPE4' | 'CAX4' | 'S4';
}

/**
 * What is wrong:
 * - `PARSE_ERROR`: a file is not what it says it is
 * - `BAD_OPTION`: an option has no such name or is out of range
 * - `NON_FINITE`: a coordinate or size is NaN or infinite
 * - `EMPTY`: no loop at all
 * - `TOO_FEW_POINTS`: a loop with fewer than three distinct points
 * - `DUPLICATE_POINT`: two equal consecutive points (strict mode), or two equal points
 * - `ZERO_AREA`: a loop that encloses nothing
 * - `SELF_INTERSECTION`: two boundary edges cross
 * - `OVERLAPPING_EDGES`: two boundary edges share a piece of line (also spikes)
 * - `TOUCHING`: two boundary edges touch in a single point, or all but
 * - `HOLE_OUTSIDE`: a hole not inside the outer loop
 * - `NESTED_OR_DUPLICATE_HOLE`: a hole inside, or equal to, another hole
 * - `REGION_CONFLICT`: two regions overlap
 * - `BAD_SIZE`: a mesh size that is not positive, or larger than the domain
 * - `ODD_BOUNDARY`: all quads asked for, but 4 Q = 2 E_int + B needs an even B
 * - `TOO_NARROW`: a warning: a long gap whose walls get longer edges
 * - `LOST_PRECISION`: coordinates too coarse (far from the origin) for this mesh size
 * - `TOO_MANY_ELEMENTS`: refused before allocating
 * - `TOO_LARGE`: a file or count beyond the stated limits
 * - `IGNORED`: a warning: something given was left out or has no effect
 * - `ADAPTED`: a warning: something given was changed or read as something else
 * - `NO_VALID_MESH`: no mesh that passes the final check was found
 * - `OUT_OF_MEMORY`: the machine, or WebAssembly's 4 GB, has no more
 * - `CANCELLED`: the caller ended the run
 * - `IO_ERROR`: a file cannot be read or written
 */
export type ErrorCode =
  | 'PARSE_ERROR'
  | 'BAD_OPTION'
  | 'NON_FINITE'
  | 'EMPTY'
  | 'TOO_FEW_POINTS'
  | 'DUPLICATE_POINT'
  | 'ZERO_AREA'
  | 'SELF_INTERSECTION'
  | 'OVERLAPPING_EDGES'
  | 'TOUCHING'
  | 'HOLE_OUTSIDE'
  | 'NESTED_OR_DUPLICATE_HOLE'
  | 'REGION_CONFLICT'
  | 'BAD_SIZE'
  | 'ODD_BOUNDARY'
  | 'TOO_NARROW'
  | 'LOST_PRECISION'
  | 'TOO_MANY_ELEMENTS'
  | 'TOO_LARGE'
  | 'IGNORED'
  | 'ADAPTED'
  | 'NO_VALID_MESH'
  | 'OUT_OF_MEMORY'
  | 'CANCELLED'
  | 'IO_ERROR';

export type MeshFormat = 'obj' | 'msh' | 'vtu' | 'vtk' | 'inp' | 'su2' | 'bdf' | 'ply' | 'geojson' | 'svg' | 'json';

export type DomainFormat = 'json' | 'geojson' | 'svg' | 'poly' | 'msh' | 'dxf';

export type SurfaceFormat = 'obj' | 'off' | 'stl' | 'ply' | 'msh';

export type SurfaceMeshFormat = 'obj' | 'msh' | 'vtu' | 'vtk' | 'inp' | 'bdf' | 'ply' | 'geojson' | 'json';
