import type { Float64s, Given, Int32s, Uint32s } from './index.js';
import type { Surface } from './surface.js';

/** An instance of occt-import-js, as far as it is used here. */
export interface OcctInstance {
  ReadStepFile(content: Uint8Array, params: object | null): any;
  ReadIgesFile(content: Uint8Array, params: object | null): any;
  ReadBrepFile(content: Uint8Array, params: object | null): any;
}

export type CadFormat = 'step' | 'iges' | 'brep';

export interface CadOptions {
  /** File name; its ending says the format. */
  name?: string;
  format?: CadFormat;
  /** Side of the quads that the surface is for: the triangles become fine enough for it. */
  size?: number;
  /** How many quads the surface is for, where no size is given. */
  quads?: number;
  /** Lengths of the result for STEP and IGES; BREP files have no unit. @default 'millimeter' */
  unit?: 'millimeter' | 'centimeter' | 'meter' | 'inch' | 'foot';
  /** Largest distance of a chord from the shape, as a length. @default size / 200, or 0.0002 of the box's mean side without a size, less for more than 3000 quads */
  linearDeflection?: number;
  /** Largest turn over a chord, in radians. @default 0.2 */
  angularDeflection?: number;
  /**
   * occt-import-js, where it is not to be found as an installed package: its function (called without
   * arguments of yours), an instance, or a promise of either.
   */
  occt?: OcctInstance | ((module?: object) => Promise<OcctInstance>) | Promise<unknown>;
}

/** Triangles of all bodies, face by face; a Surface for meshSurface. */
export interface CadSurface {
  /** x, y, z per point. Points on edges are there once per face; meshing welds them within each body. */
  points: Float64s;
  /** Three points per triangle. */
  triangles: Uint32s;
  /** Face of the B-rep per triangle, an index into groupNames. */
  groups: Int32s;
  /** "face 3", after the name of the body where it has one: "bolt 2 face 3". */
  groupNames: string[];
  /**
   * Body per triangle, an index into bodyNames: each is meshed by itself, where it touches others too. What is not closed
   * is one body together, as sheets that may want to be joined.
   */
  bodies: Int32s;
  /** "bolt", "bolt 2", … */
  bodyNames: string[];
  warnings: never[];
}

export const cadFormats: readonly CadFormat[];

/** STEP, IGES or BREP by the ending of its name? */
export function isCadFile(name: string): boolean;

/**
 * Reads a STEP, IGES or BREP file with the package occt-import-js (LGPL-2.1), which is not part of
 * lpquad: `npm install occt-import-js`. Throws LpquadError: IO_ERROR without the package,
 * BAD_OPTION for an unknown format, PARSE_ERROR for a broken file, EMPTY without faces, which an
 * assembly has none of if its parts are in other files. What a compound lists again is read once.
 */
export function readCad(source: Uint8Array | ArrayBuffer | string, options?: CadOptions): Promise<CadSurface>;

/**
 * Triangles as an OBJ file that readSurface reads back, every digit kept: lines `o` for bodies where there are several, `g` for
 * groups. Names lose what such a line cannot hold (#, \, line breaks); those that then are equal get numbers.
 */
export function surfaceAsObj(surface: Given<Surface>): string;
