/// <reference lib="esnext.disposable" />
/**
 * lpquad: quadrilateral meshes of plane domains and of surfaces.
 *
 * Coordinates are pairs or threes of doubles in the caller's unit of length, which is also the unit of
 * every size. Indices count from 0. Shapes in comments: #V points, #Q quads, #T triangles, #E edges.
 */
import type {
  ErrorCode, MeshFormat, DomainFormat, MeshOptions, SurfaceFormat, SurfaceMeshFormat, SurfaceOptions, WriteOptions,
} from './generated.js';
import type {
  ReadSurfaceOptions, Surface, SurfaceCallOptions, SurfaceInput, SurfaceMesh, SurfaceMeshResult, SurfaceSession,
} from './surface.js';

export type {
  ErrorCode, MeshFormat, DomainFormat, MeshOptions, SurfaceFormat, SurfaceMeshFormat, SurfaceOptions, WriteOptions,
};
export type {
  ReadSurfaceOptions, Surface, SurfaceCallOptions, SurfaceInput, SurfaceLayers, SurfaceMesh, SurfaceMeshResult,
  SurfaceProgress, SurfaceReport, SurfaceSession, SurfaceSnapshot, SurfaceStage,
} from './surface.js';

/**
 * Arrays that the library made: over a buffer of their own, which can be transferred. (So written that TypeScript before
 * and since 5.7, which tells buffers apart, takes it.)
 */
export type Float64s = ReturnType<Float64ArrayConstructor['of']>;
export type Uint32s = ReturnType<Uint32ArrayConstructor['of']>;
export type Int32s = ReturnType<Int32ArrayConstructor['of']>;

type GivenList<A> = A extends Float64Array ? Float64Array : A extends Uint32Array ? Uint32Array : A extends Int32Array ? Int32Array : A;
/** What the library made, as you may give it back: over any buffers. */
export type Given<T> = { [K in keyof T]: GivenList<T[K]> };

/** An array or a typed array. */
export type Numbers =
  | readonly number[] | Float64Array | Float32Array | Int32Array | Uint32Array | Int16Array | Uint16Array | Int8Array | Uint8Array
  | Uint8ClampedArray;

/** `[x, y]`, or an array of two numbers whose length TypeScript does not know; any other count is an error of the call. */
export type Point = readonly [number, number] | readonly number[];

/** A closed loop: `[[x, y], …]` or flat `[x0, y0, x1, y1, …]`. The first point may be repeated at the end, and need not. */
export type Loop = ReadonlyArray<Point> | Numbers;

/** Target sizes at points: `[[x, y, h], …]` or flat `[x0, y0, h0, …]`. */
export type Sizes = ReadonlyArray<readonly [number, number, number] | readonly number[]> | Numbers;

/** Strokes of two points or more each, `[[x, y], …]` or flat `[x0, y0, x1, y1, …]`. */
export type Guides = ReadonlyArray<Loop>;

/** What bounds one region: the loop of largest area is its outline, the others are its holes. */
export interface Loops {
  /** In any order and orientation. */
  loops: readonly Loop[];
  /**
   * One text per loop and edge; edge i runs from point i to i + 1. `''` is untagged. A loop without tags has `[]` or is
   * beyond the end; any other count than that of its edges is an error, so that no tag is missed in silence. (Of a file
   * that has too few, readDomain warns, and gives `''` to the edges that are left.)
   */
  tags?: ReadonlyArray<ReadonlyArray<string | null | undefined>>;
}

export interface DomainParts {
  /** Lines inside the domain that become mesh edges. */
  polylines?: ReadonlyArray<{ points: Loop; tag?: string }>;
  /** Points inside the domain that become mesh vertices. */
  points?: ReadonlyArray<Point | { position: Point; tag?: string }>;
  /** Target edge length that comes with the domain; `MeshOptions.size` wins over it. */
  h?: number;
  /** What comes with the domain of sizes, guides and points to start from, as the options of these names, which win. */
  sizes?: Sizes;
  guides?: Guides;
  seedPoints?: Loop;
  /** Comments, ignored. */
  name?: string;
  description?: string;
  source?: unknown;
  licence?: unknown;
  license?: unknown;
  /** Of readDomain, ignored. */
  warnings?: unknown;
}

/** One region, or several that may share edges; shared edges stay conforming. */
export type Domain =
  | (Loops & DomainParts)
  | ({ regions: ReadonlyArray<Loops & { name?: string }> } & DomainParts);

/** The options of the mesher (`MeshOptions`), and what of the caller's own goes with them. */
export interface MeshCallOptions extends MeshOptions {
  /** Target sizes at points. */
  sizes?: Sizes;
  /**
   * Strokes whose direction the quads follow nearby. They need not lie inside the domain, and do not become edges of
   * the mesh (`polylines` do). What of them shakes by less than the mesh size is smoothed out.
   */
  guides?: Guides;
  /** Target size anywhere; wins over `sizes` and `size`. Not across workers. */
  sizeAt?: (x: number, y: number) => number;
  /** Direction of the quads anywhere, radians; replaces the cross field, guides included. Not across workers. */
  angleAt?: (x: number, y: number) => number;
  /**
   * Interior points to start from, instead of those that `seeds` chooses; what is not inside is
   * left out. 80 iterations of L_p follow unless `iterations` says otherwise.
   */
  seedPoints?: Loop;
  /** Called between steps; returning false ends the run with the error CANCELLED. */
  onProgress?: (progress: Progress) => boolean | void;
}

export interface Progress {
  /** What comes next. */
  stage: Stage;
  /** Of the L_p optimisation. */
  iteration: number;
  maxIterations: number;
  /** L_p energy, without unit; 0 outside the optimisation. */
  energy: number;
}

export type Stage = 'seeds' | 'optimise' | 'match' | 'clean' | 'patch' | 'smooth' | 'check' | 'compare' | 'done';

export interface Mesh {
  /** x0, y0, x1, y1, …  2 #V. With `keepBoundary` the given points come first, bit for bit. */
  points: Float64s;
  /** Corners, counter-clockwise, 4 #Q. */
  quads: Uint32s;
  /** Region of each quad, index into `regions`, #Q. */
  quadRegions: Int32s;
  /** Left-over triangles (only where they were allowed), 3 #T. */
  triangles: Uint32s;
  /** Region of each triangle, #T. */
  triangleRegions: Int32s;
  /** The 1D mesh: edges a, b of the outline, holes, region borders and polylines, 2 #E. */
  edges: Uint32s;
  /** Tag of each edge, index into `tags`, -1 = untagged, #E. */
  edgeTags: Int32s;
  /** Regions on the left and right of each edge, -1 = outside, 2 #E. */
  edgeRegions: Int32s;
  /** Region, loop and edge of the domain each edge comes from, 3 #E; a polyline has region -1. */
  edgeOrigins: Int32s;
  /** Vertices the caller tagged. */
  taggedPoints: Uint32s;
  /** Tag of each of them, index into `tags`. */
  pointTags: Int32s;
  /** Names as given; `''` = unnamed. */
  regions: string[];
  tags: string[];
  /** Points 0 … boundaryNodes - 1 are those of the 1D mesh. */
  boundaryNodes: number;
}

export interface MeshResult extends Mesh {
  report: Report;
}

export interface Report {
  vertices: number;
  quads: number;
  triangles: number;
  boundaryNodes: number;
  boundaryEdges: number;
  seeds: number;
  /** Seeds that ∫ dA / h² asks for. */
  expectedSeeds: number;
  singularities: number;
  /** Eq. 2 of the paper, before the matching. */
  tau: number;
  matchingCost: number;
  extraEdges: number;
  /** Chains of stages tried until the final check passed. */
  attempts: number;
  chain: string;
  simplifyDeviation: number;
  /** Fingerprint of points and faces, 16 hexadecimal digits: equal meshes, equal hashes. */
  hash: string;
  quality: {
    /** η of section 5 of the paper: 1 is a rectangle, 0 has a corner of 0° or 180°. */
    etaMean: number;
    etaMin: number;
    etaP5: number;
    interiorVertices: number;
    fourValentPercent: number;
    inverted: number;
    nonconvex: number;
    /** Interior vertices by valence; the last entry counts 9 and more. */
    valenceHistogram: number[];
    /** Quads by η in 20 equal bins. */
    etaHistogram: number[];
  };
  /** Edge length over target. */
  size: { p10: number; p50: number; p90: number; min: number; max: number };
  lp: {
    ran: boolean; status?: string; energy?: number[]; gradientNorm?: number[];
    /** Points inserted and removed before each restart (option `restarts`), and whether the round was kept or undone. */
    rounds?: { inserted: number; removed: number; kept: boolean }[];
  };
  options: Required<MeshOptions>;
  cpuSeconds: Record<string, number>;
  warnings: ReportedError[];
  [more: string]: unknown;
}

export interface ReportedError {
  code: ErrorCode;
  message: string;
  where: Where;
}

/** The place of an error in the input; absent members do not apply. */
export interface Where {
  region?: number;
  loop?: number;
  edge?: number;
  otherLoop?: number;
  otherEdge?: number;
  /** Of `guides`; `edge` is then one of its points. */
  guide?: number;
  /** Coordinates in the caller's units. */
  x?: number;
  y?: number;
  /** In a file: 1-based line, 0-based byte. */
  line?: number;
  byte?: number;
}

/**
 * What every call of this library throws (or rejects with) when it is not the library's fault. Any other error is one:
 * a mistake in the library, which the worker reports as an `Error` with the same name and message.
 */
export class LpquadError extends Error {
  constructor(code: string, message: string, where?: Where, options?: ErrorOptions);
  name: 'LpquadError';
  /** `BAD_WASM`: what was loaded is not the library; `WORKER_LOST`: see lpquad/worker. */
  code: ErrorCode | 'BAD_WASM' | 'WORKER_LOST';
  where: Where;
}

/** Where a run is. A tick is one iteration of the L_p stage, a few patches, some iterations of the smoothing, a whole stage, or a whole mesh to compare with. */
export interface State extends Progress {
  tick: number;
  /** Of the L_p energy, without unit; 0 outside the optimisation. */
  gradientNorm: number;
  /** Eq. 2 of the paper, of the current triangulation: 1 for right-angled triangles. */
  tau: number;
}

/** Names of the layers to take; see Snapshot. */
export interface Layers {
  triangles?: boolean;
  cells?: boolean;
  crosses?: boolean;
  sizes?: boolean;
  matching?: boolean;
  quads?: boolean;
}

export interface Snapshot extends State {
  /** The current triangulation: before the matching, what L_p moves. */
  triangles?: { points: Float64s; triangles: Uint32s; boundaryNodes: number };
  /**
   * Clipped Voronoi cells: polygon i has the points offsets[i] … offsets[i + 1] - 1 and belongs to
   * vertex sites[i] of the triangulation; `density` is energy per area of each vertex's cell.
   */
  cells?: { points: Float64s; offsets: Int32s; sites: Int32s; density: Float64s; energy: number };
  /** One arm (cos θ, sin θ) of the cross at each point; singularities by quarters of a turn. */
  crosses?: { points: Float64s; axes: Float64s; singularities: Float64s; indices: Int32s };
  /** Target size at the points of a background triangulation. */
  sizes?: { points: Float64s; triangles: Uint32s; sizes: Float64s };
  /**
   * The triangles that were matched, the partner of each (-1: none), whether an extra edge joins
   * the two, and the price of the choice: 10⁴ (1 - η), and more for sides off the crosses, flat quads, valences and
   * extra edges.
   */
  matching?: { points: Float64s; triangles: Uint32s; mates: Int32s; extra: Int32s; costs: Float64s };
  /** η per face (quads first as listed, then triangles), valence per vertex and its excess. */
  quads?: {
    points: Float64s; quads: Uint32s; triangles: Uint32s; eta: Float64s;
    valence: Int32s; excess: Int32s; boundaryNodes: number;
  };
}

/** A run that can be stepped, looked into, taken back and copied. Dispose of it when done. */
export interface Session {
  readonly state: State;
  /** Up to `ticks` (1) ticks forwards. */
  step(ticks?: number): State;
  /** To the state after `tick` ticks, forwards or backwards: exactly the same points. */
  restore(tick: number): State;
  snapshot(layers?: Layers): Snapshot;
  /** Runs to the end. */
  finish(): MeshResult;
  clone(): Session;
  dispose(): void;
  [Symbol.dispose](): void;
}

export interface OptionInfo {
  name: string;
  type: 'number' | 'integer' | 'boolean' | 'choice';
  default: number | boolean | string;
  min?: number;
  max?: number;
  choices?: string[];
  /** `'length'`: the caller's unit of length. */
  unit: string;
  help: string;
}

/** What the library says about itself. */
export interface Description {
  version: string;
  /** Which WebAssembly runs: with SIMD, without, or the caller's own. All give the same bytes. */
  build: 'simd' | 'plain' | 'custom';
  options: OptionInfo[];
  surfaceOptions: OptionInfo[];
  writeOptions: OptionInfo[];
  errorCodes: ErrorCode[];
  meshFormats: MeshFormat[];
  domainFormats: DomainFormat[];
  surfaceFormats: SurfaceFormat[];
  /** The mesh formats that hold meshes on surfaces. */
  surfaceMeshFormats: SurfaceMeshFormat[];
}

export interface ReadOptions {
  /** File name, whose ending tells the format. */
  name?: string;
  format?: DomainFormat;
}

/** A domain as read from a file; goes into meshDomain as it is. */
export type ReadDomain = {
  regions: Array<{ name: string; loops: Array<Array<[number, number]>>; tags?: string[][] }>;
  polylines: Array<{ points: Array<[number, number]>; tag: string }>;
  points: Array<{ position: [number, number]; tag: string }>;
  h?: number;
  sizes?: Array<[number, number, number]>;
  guides?: Array<Array<[number, number]>>;
  seedPoints?: Array<[number, number]>;
  /** Gaps closed and parts left out. */
  warnings: ReportedError[];
};

export interface Lpquad extends Description {
  /**
   * Meshes a domain. Cost, measured in Node on one core: about 0.15 ms per quad.
   * @throws {LpquadError} codes as in `errorCodes`; the instance stays usable.
   */
  meshDomain(domain: Domain, options?: MeshCallOptions): MeshResult;
  /** The same in steps. `memory: false` forgets the past: less memory, no way back, and no layer `matching`. */
  start(domain: Domain, options?: Omit<MeshCallOptions, 'onProgress'> & { memory?: boolean }): Session;
  /** A domain from the text or bytes of a file. The code for it is loaded on first use. */
  readDomain(source: string | Uint8Array | ArrayBuffer, options?: ReadOptions): Promise<ReadDomain>;
  /**
   * Triangles from the text or bytes of a file, as they are there: meshSurface repairs them. Polygons are divided,
   * and what is left out is said in `warnings`. The code for it is loaded on first use.
   */
  readSurface(source: string | Uint8Array | ArrayBuffer, options?: ReadSurfaceOptions): Promise<Surface>;
  /**
   * Whether a file holds a surface rather than a domain in the plane: by its name's ending; of .msh files, by whether
   * their faces leave the plane z = 0; without a telling name, by the content.
   */
  isSurfaceFile(source: string | Uint8Array | ArrayBuffer, options?: { name?: string }): Promise<boolean>;
  /**
   * Meshes a surface with quads alone. Cost, measured in Node on one core: 0.7 to 3 ms per quad, most on scans and other
   * surfaces without plain faces. The code is loaded on first use.
   * @throws {LpquadError} codes as in `errorCodes`; the instance stays usable.
   */
  meshSurface(surface: SurfaceInput, options?: SurfaceCallOptions): Promise<SurfaceMeshResult>;
  /** The same in steps. */
  startSurface(surface: SurfaceInput, options?: SurfaceOptions): Promise<SurfaceSession>;
  /**
   * A mesh as the text of a file; a mesh on a surface in one of `surfaceMeshFormats`.
   * @throws {LpquadError} PARSE_ERROR for arrays whose lengths do not fit together, named with both lengths, and for
   * indices that are no whole numbers or lead nowhere; NON_FINITE for points that are not finite.
   */
  writeMesh(mesh: Given<SurfaceMesh>, format: SurfaceMeshFormat, options?: WriteOptions): string;
  writeMesh(mesh: Given<Mesh> & { dimension?: 2 }, format: MeshFormat, options?: WriteOptions): string;
}

/** Where the WebAssembly comes from, if not from the file beside the module. */
export interface WasmSource {
  wasmUrl?: string | URL;
  wasmBinary?: ArrayBuffer | Uint8Array;
  /** A `WebAssembly.Module`; not named so, since projects for Node alone may not declare it. */
  wasmModule?: object;
  /** Of lpquad-readers.wasm, which readDomain and readSurface load. */
  readersUrl?: string | URL;
  /** Of lpquad-surface.wasm, which meshSurface and startSurface load. */
  surfaceUrl?: string | URL;
}

/** Loads the library; the same instance for the same source, however often it is called. */
export function createLpquad(source?: WasmSource): Promise<Lpquad>;
