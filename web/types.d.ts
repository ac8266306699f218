// The plain values that the parts of the playground pass to each other.
import type { DomainFormat, MeshFormat, MeshOptions, MeshResult, Snapshot, State } from 'lpquad';

export type Point = [number, number];

export interface Region {
  name: string;
  loops: Point[][];
  tags?: string[][];
}

/** What is meshed, in the form the library reads it. Never changed in place. */
export interface Drawing {
  regions: Region[];
  polylines: { points: Point[]; tag: string }[];
  points: { position: Point; tag: string }[];
}

export type LayerName =
  | 'boundary' | 'triangles' | 'cells' | 'density' | 'crosses' | 'sizes' | 'matching' | 'quads'
  | 'quality' | 'valence';

/** Everything that undo restores and a link carries. Plain and immutable. */
export interface Project {
  /** Id of the preset the drawing is of; '' once it was changed or is the user's own. */
  preset: string;
  /** What it is called if it is of no preset: the name of its file; '' = nothing yet. */
  name: string;
  drawing: Drawing;
  /** Only what differs from the defaults. */
  options: MeshOptions;
  /** Painted target sizes [x, y, h]. */
  sizes: [number, number, number][];
  /** Strokes that the crosses follow. */
  guides: Point[][];
  /** Given initial interior points; empty: the method chooses. */
  seedPoints: Point[];
  /** Layers to draw; 'auto' shows what fits the stage. */
  layers: 'auto' | LayerName[];
  /** Id of the comparison shown beside the run; '' = none. */
  comparison: string;
}

export type Phase = 'loading' | 'starting' | 'playing' | 'paused' | 'done' | 'failed' | 'cancelled';

/** What is known of a run; a new object at every change. */
export interface Run {
  phase: Phase;
  /** The project this run is of; anything else on the screen is out of date. */
  project: Project | null;
  /** Where the run is; null before the first state. */
  state: State | null;
  /** What is drawn; says itself at which state it was taken. */
  frame: Snapshot | null;
  /** The project that `frame` is of: an older one's is kept until there is a new picture. */
  frameOf: Project | null;
  /** States seen so far, by tick; not every tick need be there. */
  history: State[];
  result: MeshResult | null;
  error: { code: string; message: string; where: import('lpquad').Where } | null;
}

export type Freshness = 'current' | 'preview' | 'old';

/** World to screen: x' = scale (x - left), y' = scale (top - y); y points up in the world. */
export interface View {
  scale: number;
  left: number;
  top: number;
  /** In CSS pixels. */
  width: number;
  height: number;
}

/** Colours by role; two tables, light and dark. */
export interface Palette {
  background: string;
  ink: string;
  faint: string;
  boundary: string;
  accent: string;
  error: string;
  /** Within a region, below everything. */
  region: string;
  ramps: { density: Ramp; quality: Ramp; sizes: Ramp; costs: Ramp };
  /** By faces too few or too many, -2 to 2. */
  valence: Record<number, string>;
}

/** Colours in the order of the values, each darker than the one before, or each lighter. */
export type Ramp = [number, number, number][];

/** What the draw functions see. */
export interface Scene {
  drawing: Drawing;
  frame: Snapshot | null;
  /** Whether the mesh is the drawing's: a preview is coarse, an old one was of another drawing. */
  freshness: Freshness;
  result: MeshResult | null;
  layers: ReadonlySet<LayerName>;
  palette: Palette;
  /** The p of the energy. */
  norm: number;
}

/** The part of CanvasRenderingContext2D that drawing uses; a recorder or SVG writer has it too. */
export type Pen = Pick<CanvasRenderingContext2D,
  'beginPath' | 'moveTo' | 'lineTo' | 'closePath' | 'arc' | 'fill' | 'stroke' | 'save' | 'restore'
  | 'setLineDash' | 'fillStyle' | 'strokeStyle' | 'lineWidth' | 'globalAlpha' | 'lineJoin' | 'lineCap'
  | 'fillText' | 'font' | 'textAlign' | 'textBaseline'> & Partial<Bulk>;

/** What a pen may offer for thousands of polygons and lines: no paths, colours as in ImageData. */
export interface Bulk {
  /** The first `count` pairs of `corners`, even-odd. */
  fillPolygon(corners: Float64Array, count: number, rgba: number): void;
  strokeLine(x0: number, y0: number, x1: number, y1: number, width: number, rgba: number): void;
}

/** Draws one layer; `yield` is where a long drawing may rest for a moment. */
export type DrawLayer = (pen: Pen, scene: Scene, view: View) => void | Iterable<void>;

export type { DomainFormat, MeshFormat, MeshOptions, MeshResult, Snapshot, State };
