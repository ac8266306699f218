// Marks for vertices where too few or too many quads meet, told apart by shape as well as colour.
/** @import { Palette, Pen } from '../types' */
import { packedOf } from './palette.js';

/** @typedef {'diamond' | 'triangle' | 'pentagon' | 'star'} Shape */

/** @type {Record<number, {shape: Shape, text: string, key: string}>} */
const byExcess = {
  [-2]: { shape: 'diamond', text: 'two or more quads too few', key: '2 or more too few' },
  [-1]: { shape: 'triangle', text: 'one quad too few', key: '1 quad too few' },
  1: { shape: 'pentagon', text: 'one quad too many', key: '1 quad too many' },
  2: { shape: 'star', text: 'two or more quads too many', key: '2 or more too many' },
};

/** @param {Palette} palette  @param {number} excess  quads too many */
export function markOf(palette, excess) {
  const kind = Math.max(-2, Math.min(2, excess));
  return { ...byExcess[kind], colour: palette.valence[kind] };
}

/** @param {Shape} shape  @returns {[number, number][]} */
function cornersFor(shape) {
  if (shape === 'diamond') return [[0, -1.15], [0.7, 0], [0, 1.15], [-0.7, 0]];
  const count = { triangle: 3, pentagon: 5, star: 12 }[shape];
  return Array.from({ length: count }, (_, i) => {
    const angle = 2 * Math.PI * i / count - Math.PI / 2;
    const reach = shape === 'star' ? (i % 2 === 0 ? 1.25 : 0.72) : shape === 'triangle' ? 1.3 : 1.1;
    return [reach * Math.cos(angle), reach * Math.sin(angle)];
  });
}

const corners = {
  diamond: cornersFor('diamond'), triangle: cornersFor('triangle'),
  pentagon: cornersFor('pentagon'), star: cornersFor('star'),
};

/** Corners round (0, 0) within radius 1 or a little more, y down. @param {Shape} shape */
export const cornersOf = (shape) => corners[shape];

/**
 * With a rim that keeps it apart from what is below.
 * @param {Pen} pen  @param {Shape} shape  @param {number} x  @param {number} y  @param {number} radius
 * @param {string} colour  @param {string} rim
 */
export function drawMark(pen, shape, x, y, radius, colour, rim) {
  pen.fillStyle = colour;
  pen.strokeStyle = rim;
  pen.lineWidth = 1;
  traceMark(pen, shape, x, y, radius);
  pen.fill();
  pen.stroke();
}

/**
 * The same by the thousand, as far as the pen can.
 * @param {Pen} pen  @param {Shape} shape  @param {number} x  @param {number} y  @param {number} radius
 * @param {string} colour  @param {string} rim
 */
export function drawMarkInBulk(pen, shape, x, y, radius, colour, rim) {
  if (!pen.fillPolygon) return drawMark(pen, shape, x, y, radius, colour, rim);
  fillShape(pen, cornersOf(shape), x, y, radius + 1, packedOf(rim));
  fillShape(pen, cornersOf(shape), x, y, radius, packedOf(colour));
}

const placed = new Float64Array(24);  // a star's

/**
 * @param {Pen} pen  @param {[number, number][]} shape  @param {number} x  @param {number} y  @param {number} reach
 * @param {number} rgba
 */
function fillShape(pen, shape, x, y, reach, rgba) {
  shape.forEach(([cx, cy], i) => {
    placed[2 * i] = x + reach * cx;
    placed[2 * i + 1] = y + reach * cy;
  });
  pen.fillPolygon?.(placed, shape.length, rgba);
}

/** @param {Pen} pen  @param {Shape} shape  @param {number} x  @param {number} y  @param {number} radius */
export function traceMark(pen, shape, x, y, radius) {
  pen.beginPath();
  cornersOf(shape).forEach(([cx, cy], i) => pen[i === 0 ? 'moveTo' : 'lineTo'](x + radius * cx, y + radius * cy));
  pen.closePath();
}

/**
 * A short text in a mark.
 * @param {Pen} pen  @param {string} text  @param {number} x  @param {number} y  @param {string} colour
 */
export function writeIn(pen, text, x, y, colour) {
  pen.fillStyle = colour;
  pen.font = '600 11px system-ui, sans-serif';
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  pen.fillText(text, x, y + 1);
}
