// The layers of a run as objects in space. Faces stand back a little from the lines on them.
/** @import { Palette } from '../../types' */
/** @import { SurfaceSnapshot } from 'lpquad' */
/** @import { Shape as MarkShape } from '../../draw/marks.js' */
import {
  BufferAttribute, BufferGeometry, CanvasTexture, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial,
  Points, PointsMaterial,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { cornersOf, markOf } from '../../draw/marks.js';
import { bordersOf, nextCorner } from './borders.js';
import {
  cellColours, chartColour, crossLines, edgesOfQuads, gather, irregularVertices, meshOfCells, parts, perCorner, qualityColours, trianglesOfQuads,
} from './geometry.js';

const phone = matchMedia('(max-width: 760px)');  // marks are smaller there, and lines fainter: they are nearer to each other
const markSize = () => (phone.matches ? 8 : 13);  // pixels
const cutWidth = 1.5, featureWidth = 2.5, pointedWidth = 3;

/** @param {Float32Array} positions  @param {Float32Array} colours  three numbers a corner
 * @param {number} back  how far behind the lines and other faces on them */
function faces(positions, colours, back) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('color', new BufferAttribute(colours, 3));
  geometry.computeVertexNormals();
  const material = new MeshLambertMaterial({ vertexColors: true, flatShading: true, side: DoubleSide,
    polygonOffset: true, polygonOffsetFactor: back, polygonOffsetUnits: back });
  return new Mesh(geometry, material);
}

/** Thin lines, one pixel. @param {Float32Array} positions  @param {string} colour  @param {number} [opacity] */
function thin(positions, colour, opacity = 1) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color: colour, transparent: opacity < 1, opacity }));
}

/** @param {Float32Array} positions  @param {string} colour  @param {number} width  pixels */
function thick(positions, colour, width) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(positions);
  return new LineSegments2(geometry, new LineMaterial({ color: colour, linewidth: width }));
}

/** Draws it a little nearer than it is. @param {import('three').Material} material */
function bringForward(material) {
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace('#include <fog_vertex>', '#include <fog_vertex>\n gl_Position.z -= 0.004 * gl_Position.w;');
  };
}

/** A mark of the plane's drawings as a picture. @param {MarkShape} shape  @param {string} colour  @param {boolean} hollow */
function markPicture(shape, colour, hollow) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.translate(32, 32);
  context.beginPath();
  cornersOf(shape).forEach(([x, y], i) => (i === 0 ? context.moveTo(24 * x, 24 * y) : context.lineTo(24 * x, 24 * y)));
  context.closePath();
  context.lineWidth = 10;
  context.fillStyle = context.strokeStyle = colour;
  if (hollow) context.stroke();
  else context.fill();
  return new CanvasTexture(canvas);
}

/** @param {Float32Array} positions  @param {Palette} palette  @param {number} excess  @param {boolean} hollow */
function marks(positions, palette, excess, hollow) {
  const { shape, colour } = markOf(palette, excess);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  const material = new PointsMaterial({ size: markSize(), sizeAttenuation: false, map: markPicture(shape, colour, hollow),
    transparent: true, alphaTest: 0.1 });
  bringForward(material);  // a mark faces the reader, so that a slanting surface would cut it in two
  return new Points(geometry, material);
}

/** @typedef {import('lpquad').Surface} SurfaceLayer */

/** The triangles; by chart, or all alike. @param {SurfaceLayer} surface  @param {boolean} dark
 * @param {ArrayLike<number>} [charts]
 * @param {(triangle: number) => boolean} [left]  left out: they shrink to nothing, so that the others keep their numbers */
export function surfaceObject({ points, triangles }, dark, charts, left = () => false) {
  const plain = parts(dark ? '#33475c' : '#dbe4ee');
  const colours = Array.from({ length: triangles.length / 3 }, (_, t) => (charts === undefined ? plain : chartColour(charts[t], dark)));
  const corners = Uint32Array.from(triangles, (vertex, i) => (left(Math.floor(i / 3)) ? 0 : vertex));
  return faces(gather(points, corners), perCorner(colours, 3), 2);
}

/** What is pointed at: all triangles, there whatever is drawn over them, and not seen. @param {SurfaceLayer} surface */
export function targetObject({ points, triangles }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(points), 3));
  geometry.setIndex(new BufferAttribute(Uint32Array.from(triangles), 1));
  const target = new Mesh(geometry, new MeshBasicMaterial({ side: DoubleSide }));
  target.visible = false;
  return target;
}

/** The chart that is pointed at: a tint over whatever is drawn there, and its border.
 * @param {SurfaceLayer} surface  @param {NonNullable<SurfaceSnapshot['charts']>} charts  @param {number} chart  @param {Palette} palette */
export function pointedObject({ points, triangles }, charts, chart, palette) {
  const corners = triangles.filter((_, i) => charts.charts[Math.floor(i / 3)] === chart);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(gather(points, corners), 3));
  const tint = new Mesh(geometry, new MeshBasicMaterial({ color: palette.accent, side: DoubleSide, transparent: true, opacity: 0.3, depthWrite: false }));
  const ends = bordersOf(charts, triangles, chart).flatMap((i) => [triangles[i], triangles[nextCorner(i)]]);
  const border = thick(gather(points, ends), palette.accent, pointedWidth);
  // Quads are chords: where the surface is round they would cover parts of it.
  bringForward(tint.material);
  bringForward(border.material);
  return new Group().add(tint, border);
}

/** @param {SurfaceLayer} surface  @param {NonNullable<SurfaceSnapshot['features']>} features  @param {Palette} palette */
export const featureObject = ({ points }, { edges }, palette) => thick(gather(points, edges), palette.boundary, featureWidth);

/** @param {SurfaceLayer} surface  @param {NonNullable<SurfaceSnapshot['charts']>} charts  @param {Palette} palette */
export const cutObject = ({ points }, { cuts }, palette) => thick(gather(points, cuts), palette.faint, cutWidth);

/** @param {SurfaceLayer} surface  @param {NonNullable<SurfaceSnapshot['crosses']>} crosses  @param {number} size
 * @param {Palette} palette */
export function crossObject(surface, { axes, singularities, indices }, size, palette) {
  const group = new Group().add(thin(crossLines(surface, axes, 0.35 * size), palette.accent));
  for (const sign of [1, -1]) {
    const vertices = singularities.filter((_, i) => Math.sign(indices[i]) === sign);
    if (vertices.length > 0) group.add(marks(gather(surface.points, vertices), palette, -sign, true));
  }
  return group;
}

/** @param {NonNullable<SurfaceSnapshot['cells']>} cells  @param {Palette} palette */
export function cellObject(cells, palette) {
  const { triangles, pieces, edges } = meshOfCells(cells);
  const colours = cellColours(cells, palette.ramps.density).map(parts);
  return new Group().add(faces(gather(cells.points, triangles), perCorner(pieces.map((i) => colours[i]), 3), 1),
    thin(gather(cells.points, edges), palette.faint));
}

/** @param {NonNullable<SurfaceSnapshot['quads']>} quads  @param {Palette} palette  @param {boolean} dark
 * @param {{quality: boolean, lines: boolean, faces: boolean}} how */
export function quadObject({ points, quads, eta }, palette, dark, how) {
  const group = new Group();
  const plain = parts(dark ? '#33475c' : '#e6edf4');
  if (how.faces) {
    const colours = how.quality ? qualityColours(eta, palette.ramps.quality) : Array.from(eta, () => plain);
    group.add(faces(gather(points, trianglesOfQuads(points, quads)), perCorner(colours.slice(0, quads.length / 4), 6), 1));
  }
  if (how.lines) group.add(thin(gather(points, edgesOfQuads(quads)), palette.ink, phone.matches ? 0.45 : 0.75));
  return group;
}

/** @param {NonNullable<SurfaceSnapshot['quads']>} quads  @param {Palette} palette */
export function irregularObject(quads, palette) {
  const group = new Group();
  for (const [excess, vertices] of irregularVertices(quads)) group.add(marks(gather(quads.points, vertices), palette, excess, false));
  return group;
}
