/// <reference lib="esnext.disposable" />
/** Surfaces: what the calls readSurface, meshSurface and startSurface take and give. */
import type { Float64s, Int32s, Mesh, Numbers, Report, ReportedError, Uint32s } from './index.js';
import type { SurfaceFormat, SurfaceOptions } from './generated.js';

/** Triangles in space. */
export interface Surface {
  /** x0, y0, z0, x1, …  3 #V. */
  points: Float64s;
  /** Corners, 3 #T. */
  triangles: Uint32s;
  /** Part of the file (a face of a CAD model, a material) of each triangle, index into `groupNames`, #T. */
  groups?: Int32s;
  /** Names as given; `''` = unnamed. */
  groupNames?: string[];
  /** Target edge length at each point, 0 for none, #V: a vertex property `size` of a PLY file. */
  sizes?: Float64s;
  /** Body of each triangle, index into `bodyNames`, #T; empty = all one. */
  bodies?: Int32s;
  bodyNames?: string[];
  /** Of readSurface: what the file holds beside and was left out. */
  warnings?: ReportedError[];
}

/** What can be meshed: what readSurface gave, or triangles of your own. */
export interface SurfaceInput {
  /** `[[x, y, z], …]` or flat `[x0, y0, z0, x1, …]`. */
  points: ReadonlyArray<readonly [number, number, number] | readonly number[]> | Numbers;
  /** `[[a, b, c], …]` or flat. In any order and orientation; borders and several parts are fine. */
  triangles: ReadonlyArray<readonly [number, number, number] | readonly number[]> | Numbers;
  /** Borders between groups become edges of the mesh (`keepGroups`). */
  groups?: Numbers;
  /** Left out: as many without a name as `groups` says. */
  groupNames?: ReadonlyArray<string>;
  /** Target edge length at each point, 0 for none; wins over the option `size` there. */
  sizes?: Numbers;
  /**
   * Parts that may touch and are meshed each by itself: points of different bodies are never welded, nor is a point that
   * both have one in the mesh.
   */
  bodies?: Numbers;
  /** Left out: as many without a name as `bodies` says. */
  bodyNames?: ReadonlyArray<string>;
  /** Comments, ignored. */
  name?: string;
  description?: string;
  warnings?: unknown;
}

export interface ReadSurfaceOptions {
  /** File name, whose ending tells the format; without, the content does. */
  name?: string;
  format?: SurfaceFormat;
}

/** What comes next. */
export type SurfaceStage = 'features' | 'field' | 'charts' | 'mesh' | 'seams' | 'shape' | 'done';

/**
 * Where a run on a surface is. A tick is a stage, or in `mesh` one step of the planar chain in one chart, in `seams` one
 * window, in `shape` one patch or one descent over all.
 */
export interface SurfaceProgress {
  stage: SurfaceStage;
  tick: number;
  /** Charts meshed so far, of so many; 0 until there are charts. */
  chart: number;
  chartCount: number;
  /** Of the work of the stage, 0 to 1, as far as it is known. */
  share: number;
}

export interface SurfaceCallOptions extends SurfaceOptions {
  /** Called before every tick; returning false ends the run with the error CANCELLED. */
  onProgress?: (progress: SurfaceProgress) => boolean | void;
}

/**
 * A mesh on a surface, in the form of one in the plane. Regions are the faces of the surface, between its features;
 * `regions` names them after their group, or "face 3". Edges are features and borders, curve by curve, with tags
 * "curve 1", …; a face is on their left wherever there is one on a side only.
 */
export interface SurfaceMesh extends Mesh {
  dimension: 3;
  /** x0, y0, z0, x1, …  3 #V. */
  points: Float64s;
  /** Where each vertex lies on the surface as repaired: triangle, #V, and the weights of its corners, 3 #V. */
  placeTriangles: Int32s;
  placeWeights: Float64s;
}

export interface SurfaceMeshResult extends SurfaceMesh {
  /** As repaired: welded, without doubles and triangles without height, oriented. */
  surface: Required<Omit<Surface, 'warnings' | 'sizes'>>;
  report: SurfaceReport;
}

export interface SurfaceReport {
  vertices: number;
  quads: number;
  triangles: number;
  /** Of the surface, between features. */
  faces: number;
  curves: number;
  corners: number;
  /** Edges of the surface that are features or borders. */
  featureEdges: number;
  charts: number;
  singularities: number;
  /** Times that the charts were meshed: 1, and one more whenever sizes were made smaller where there was no mesh or too coarse a one. */
  rounds: number;
  windowsOpened: number;
  windowsAccepted: number;
  /** Changes of connectivity while the shape was optimised. */
  shapeRefills: number;
  /** Vertices put on tips of the surface that quads would cut off. */
  tipsReached: number;
  /** Corners between creases of noise that moved on along one of them, by less than a quarter of the size. */
  cornersMoved: number;
  targetSize: number;
  /** Fingerprint of points and faces, 16 hexadecimal digits: equal meshes, equal hashes. */
  hash: string;
  /** Measured in space; `nonconvex` quads are said in `warnings`. */
  quality: Report['quality'];
  size: Report['size'];
  /** Of the mesh (vertices, middles of edges and faces) from the surface, and of the surface (vertices, and places a quarter of a side apart) from the mesh. */
  distance: Record<'toSurface' | 'fromSurface', { max: number; mean: number }>;
  /** The mesh of each body; `[]` where the surface does not tell bodies. A closed one has no border edge. */
  bodies: { name: string; vertices: number; quads: number; triangles: number; parts: number; borderEdges: number }[];
  /** What was done to the triangles as given: counts by kind. */
  repairs: Record<string, number>;
  options: Required<SurfaceOptions>;
  cpuSeconds: Record<string, number>;
  warnings: ReportedError[];
  [more: string]: unknown;
}

/** Names of the layers to take; see SurfaceSnapshot. */
export interface SurfaceLayers {
  surface?: boolean;
  features?: boolean;
  sizes?: boolean;
  crosses?: boolean;
  charts?: boolean;
  cells?: boolean;
  quads?: boolean;
}

/** Layers but `surface`, `cells` and `quads` are empty until their stage is over, and stay from then on. Vertices and triangles are those of `surface`. */
export interface SurfaceSnapshot extends SurfaceProgress {
  /** The surface as repaired. */
  surface?: SurfaceMeshResult['surface'];
  /**
   * Edges a, b that the mesh follows, 2 #E, and why: 1 sharp, 2 marked, 3 border of a group, 4 border or sheets that meet.
   * Corners are vertices; `faces` has the face of each triangle.
   */
  features?: { edges: Uint32s; kinds: Int32s; corners: Uint32s; faces: Int32s };
  /** Target edge length at each vertex. */
  sizes?: { sizes: Float64s };
  /**
   * One arm of the cross in the plane of each triangle, a unit vector, 3 #T; the others are quarter turns about the
   * normal. Singularities are vertices; indices by quarters of a turn, +1 where three quads meet, -1 where five do.
   */
  crosses?: { axes: Float64s; singularities: Uint32s; indices: Int32s };
  /**
   * The chart of each triangle, #T, and the corners of each in its chart's own plane, u, v, 6 #T, in about the lengths of
   * the surface. `cuts` are the borders of charts that are no features, 2 per edge.
   */
  charts?: { charts: Int32s; uv: Float64s; cuts: Uint32s };
  /**
   * The clipped Voronoi cells in the chart that is being meshed, `chart`, -1 between charts: pieces as polygons, offsets by
   * point, #pieces + 1, in the chart's own plane (u, v) and on the surface (x, y, z), and the vertex of the triangulation
   * each belongs to; energy density per vertex.
   */
  cells?: { chart: number; uv: Float64s; points: Float64s; offsets: Int32s; sites: Int32s; density: Float64s };
  /**
   * The quads of the charts meshed so far, then of all. Per face (quads first, then triangles) its region and η, per
   * vertex its valence and what it may do: 0 free, 1 on a feature or border, 2 a corner; `edges` as in the result.
   */
  quads?: {
    points: Float64s; quads: Uint32s; triangles: Uint32s; regions: Int32s; eta: Float64s;
    valence: Int32s; pinned: Int32s; edges: Uint32s;
  };
}

/** A run on a surface that can be stepped and looked into. Dispose of it when done. */
export interface SurfaceSession {
  readonly state: SurfaceProgress;
  /** Up to `ticks` (1) ticks. */
  step(ticks?: number): SurfaceProgress;
  snapshot(layers?: SurfaceLayers): SurfaceSnapshot;
  /** Runs to the end. */
  finish(onProgress?: SurfaceCallOptions['onProgress']): SurfaceMeshResult;
  dispose(): void;
  [Symbol.dispose](): void;
}
