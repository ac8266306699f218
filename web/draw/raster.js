// Polygons and thin lines into the words of an ImageData. Thousands of small polygons are several
// times faster so than as paths, a tiling has no seams, and the work can rest at any moment.
// A pixel belongs to the polygon that holds its centre; lines are smooth.

const many = 256;  // corners of a polygon, more than any quad or cell has
const mostCrossings = 2 ** 21;

export class Raster {
  /** Where the lines of a row are crossed. */
  #crossings = new Float64Array(64);

  /** @param {number} width  @param {number} height  @param {Uint32Array} [pixels] */
  constructor(width, height, pixels = new Uint32Array(width * height)) {
    this.width = width;
    this.height = height;
    this.pixels = pixels;
  }

  clear() { this.pixels.fill(0); }

  /**
   * Even-odd, opaque. Loops joined by a line there and back make a polygon with holes.
   * @param {Float64Array} corners  x, y, … in pixels  @param {number} count  of corners  @param {number} rgba
   */
  fillPolygon(corners, count, rgba) {
    let low = Infinity, high = -Infinity;
    for (let i = 1; i < 2 * count; i += 2) {
      low = Math.min(low, corners[i]);
      high = Math.max(high, corners[i]);
    }
    const first = Math.max(0, Math.ceil(low - 0.5)), last = Math.min(this.height, Math.ceil(high - 0.5));
    if (count > many && this.#fillBySides(corners, count, rgba, first, last)) return;
    if (count > this.#crossings.length) this.#crossings = new Float64Array(2 * count);
    for (let row = first; row < last; ++row) this.#fillRow(row, this.#crossings, 0, this.#cross(corners, count, row + 0.5), rgba);
  }

  /**
   * The same for many corners, unless it takes too much memory: each side is asked for its rows, not each row for its sides.
   * @param {Float64Array} corners  @param {number} count  @param {number} rgba  @param {number} first  row  @param {number} last  row, not in it
   * @returns {boolean}  whether it was done
   */
  #fillBySides(corners, count, rgba, first, last) {
    const each = (/** @type {(row: number, side: number, before: number) => void} */ found) => {
      for (let i = 0, before = count - 1; i < count; before = i++) {
        const y0 = corners[2 * before + 1], y1 = corners[2 * i + 1];
        const end = Math.min(last, Math.ceil(Math.max(y0, y1) - 0.5));
        for (let row = Math.max(first, Math.ceil(Math.min(y0, y1) - 0.5)); row < end; ++row) found(row - first, i, before);
      }
    };
    const ends = new Uint32Array(Math.max(0, last - first));  // of each row's crossings, among all of them
    each((row) => { ++ends[row]; });
    for (let row = 1; row < ends.length; ++row) ends[row] += ends[row - 1];
    const all = ends.at(-1) ?? 0;
    if (all > mostCrossings) return false;
    const crossings = new Float64Array(all), begins = ends.slice();
    each((row, i, before) => {
      crossings[--begins[row]] = crossingOf(corners[2 * before], corners[2 * before + 1], corners[2 * i], corners[2 * i + 1], first + row + 0.5);
    });
    ends.forEach((end, row) => {
      crossings.subarray(begins[row], end).sort();
      this.#fillRow(first + row, crossings, begins[row], end, rgba);
    });
    return true;
  }

  /**
   * Sorted crossings of the polygon with a row; returns how many.
   * @param {Float64Array} corners  @param {number} count  @param {number} y
   */
  #cross(corners, count, y) {
    const crossings = this.#crossings;
    let found = 0;
    for (let i = 0, before = count - 1; i < count; before = i++) {
      const y0 = corners[2 * before + 1], y1 = corners[2 * i + 1];
      if ((y0 <= y) === (y1 <= y)) continue;
      const x = crossingOf(corners[2 * before], y0, corners[2 * i], y1, y);
      let k = found++;
      for (; k > 0 && crossings[k - 1] > x; --k) crossings[k] = crossings[k - 1];
      crossings[k] = x;
    }
    return found;
  }

  /** @param {number} row  @param {Float64Array} crossings  sorted  @param {number} begin  @param {number} end  @param {number} rgba */
  #fillRow(row, crossings, begin, end, rgba) {
    const start = row * this.width;
    for (let k = begin; k + 1 < end; k += 2) {
      const from = Math.max(0, Math.ceil(crossings[k] - 0.5));
      const to = Math.min(this.width, Math.ceil(crossings[k + 1] - 0.5));
      for (let i = start + from; i < start + to; ++i) this.pixels[i] = rgba;
    }
  }

  /**
   * @param {number} x0  @param {number} y0  @param {number} x1  @param {number} y1  @param {number} width
   * @param {number} rgba
   */
  strokeLine(x0, y0, x1, y1, width, rgba) {
    const { width: across, height: down } = this;
    if (Math.abs(x1 - x0) >= Math.abs(y1 - y0)) {
      if (x0 <= x1) this.#march(x0, y0, x1, y1, width, rgba, across, down, 1, across);
      else this.#march(x1, y1, x0, y0, width, rgba, across, down, 1, across);
    } else if (y0 <= y1) this.#march(y0, x0, y1, x1, width, rgba, down, across, across, 1);
    else this.#march(y1, x1, y0, x0, width, rgba, down, across, across, 1);
  }

  /**
   * A line along its longer direction `a`, a0 <= a1: at every pixel centre, what it covers across.
   * @param {number} a0  @param {number} b0  @param {number} a1  @param {number} b1  @param {number} width
   * @param {number} rgba  @param {number} along  pixels  @param {number} across
   * @param {number} stepAlong  between pixels in memory  @param {number} stepAcross
   */
  #march(a0, b0, a1, b1, width, rgba, along, across, stepAlong, stepAcross) {
    const slope = a1 > a0 ? (b1 - b0) / (a1 - a0) : 0;
    const half = 0.5 * width * Math.sqrt(1 + slope * slope);
    const end = Math.min(along, Math.ceil(a1 - 0.5));
    for (let a = Math.max(0, Math.ceil(a0 - 0.5)); a < end; ++a) {
      const middle = b0 + (a + 0.5 - a0) * slope;
      const low = middle - half, high = middle + half;
      const stop = Math.min(across, Math.ceil(high));
      for (let b = Math.max(0, Math.floor(low)); b < stop; ++b)
        this.#blend(a * stepAlong + b * stepAcross, Math.min(high, b + 1) - Math.max(low, b), rgba);
    }
  }

  /** Over what is there. @param {number} at  @param {number} cover  0 to 1  @param {number} rgba */
  #blend(at, cover, rgba) {
    const under = this.pixels[at], underAlpha = under >>> 24;
    if (underAlpha === 0) {
      this.pixels[at] = ((Math.round(255 * cover) << 24) | (rgba & 0xffffff)) >>> 0;
      return;
    }
    const rest = underAlpha / 255 * (1 - cover), alpha = cover + rest;
    if (alpha <= 0) return;
    const share = cover / alpha;
    const r = under & 255, g = (under >> 8) & 255, b = (under >> 16) & 255;
    this.pixels[at] = ((Math.round(255 * alpha) << 24)
      | ((b + share * (((rgba >> 16) & 255) - b)) << 16)
      | ((g + share * (((rgba >> 8) & 255) - g)) << 8)
      | (r + share * ((rgba & 255) - r))) >>> 0;
  }
}

/**
 * The same for a line and its reverse: neighbours leave no gap.
 * @param {number} x0  @param {number} y0  @param {number} x1  @param {number} y1  @param {number} y
 */
function crossingOf(x0, y0, x1, y1, y) {
  return y0 < y1 ? x0 + (y - y0) / (y1 - y0) * (x1 - x0) : x1 + (y - y1) / (y0 - y1) * (x0 - x1);
}
