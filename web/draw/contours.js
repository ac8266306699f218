// Bands and lines between whole heights of a function that is linear in every triangle.

/** @typedef {[x: number, y: number, height: number]} Corner */

const trianglesPerRest = 3000;

/**
 * Between k and k + 1 lies band k, 0 to bandCount - 1; lines separate the bands. Rests now and then.
 * @param {ArrayLike<number>} points  @param {Uint32Array} triangles
 * @param {ArrayLike<number>} heights  @param {number} bandCount
 */
export function* contours(points, triangles, heights, bandCount) {
  const out = new Pieces();
  const bandOf = (/** @type {number} */ height) => Math.max(0, Math.min(bandCount - 1, height));
  for (let t = 0; t < triangles.length; t += 3) {
    if (t % (3 * trianglesPerRest) === 0) yield;
    const a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
    const ha = heights[a], hb = heights[b], hc = heights[c];
    const first = bandOf(Math.floor(Math.min(ha, hb, hc)));
    const last = Math.max(first, bandOf(Math.ceil(Math.max(ha, hb, hc)) - 1));
    if (first === last) out.addWhole(points, a, b, c, first);
    else {
      /** @type {(v: number) => Corner} */
      const corner = (v) => [points[2 * v], points[2 * v + 1], heights[v]];
      cut([corner(a), corner(b), corner(c)], first, last, out);
    }
  }
  return out.arrays();
}

/** What was cut so far. */
class Pieces {
  /** @type {number[]} */
  points = [];
  offsets = [0];
  /** @type {number[]} */
  band = [];
  /** @type {number[]} */
  lines = [];

  /** @param {Corner[]} polygon  @param {number} band */
  add(polygon, band) {
    for (const [x, y] of polygon) this.points.push(x, y);
    this.offsets.push(this.points.length / 2);
    this.band.push(band);
  }

  /**
   * @param {ArrayLike<number>} points  @param {number} a  @param {number} b  @param {number} c  @param {number} band
   */
  addWhole(points, a, b, c, band) {
    for (const v of [a, b, c]) this.points.push(points[2 * v], points[2 * v + 1]);
    this.offsets.push(this.points.length / 2);
    this.band.push(band);
  }

  arrays() {
    return {
      bands: {
        points: Float64Array.from(this.points), offsets: Uint32Array.from(this.offsets),
        band: Uint8Array.from(this.band),
      },
      lines: Float64Array.from(this.lines),
    };
  }
}

/**
 * @param {Corner[]} triangle  @param {number} first  @param {number} last  bands it has a part in
 * @param {Pieces} out
 */
function cut(triangle, first, last, out) {
  let rest = triangle;
  for (let k = first; k < last; ++k) {
    const level = k + 1, piece = clip(rest, level, -1);
    const ends = piece.filter(([, , height]) => height === level);
    if (ends.length === 2) out.lines.push(ends[0][0], ends[0][1], ends[1][0], ends[1][1]);
    if (piece.length > 2) out.add(piece, k);
    rest = clip(rest, level, 1);
  }
  if (rest.length > 2) out.add(rest, last);
}

/**
 * The part of a polygon above (side 1) or below (-1) a height.
 * @param {Corner[]} polygon  @param {number} level  @param {1 | -1} side
 */
function clip(polygon, level, side) {
  /** @type {Corner[]} */
  const kept = [];
  polygon.forEach((p, i) => {
    const q = polygon[(i + 1) % polygon.length], a = side * (p[2] - level), b = side * (q[2] - level);
    if (a >= 0) kept.push(p);
    if (a * b >= 0) return;
    const t = a / (a - b);
    kept.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), level]);
  });
  return kept;
}
