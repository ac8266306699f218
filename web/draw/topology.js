// What a mesh is made of: edges, each once, and points that are the same.

/**
 * Unique edges [a, b, …], a < b, of polygons: polygon i has the corners offsets[i] … offsets[i + 1] - 1.
 * @param {ArrayLike<number>} corners  vertices  @param {ArrayLike<number>} offsets  @param {number} vertexCount
 */
export function edgesOfRows(corners, offsets, vertexCount) {
  // Half-edges sorted into rows by their lower end; a row has a handful of them.
  const first = new Int32Array(vertexCount + 1);
  const visit = (/** @type {(low: number, high: number) => void} */ see) => {
    for (let f = 0; f + 1 < offsets.length; ++f)
      for (let k = offsets[f], last = offsets[f + 1]; k < last; ++k) {
        const a = corners[k], b = corners[k + 1 < last ? k + 1 : offsets[f]];
        if (a !== b) see(a < b ? a : b, a < b ? b : a);
      }
  };
  visit((low) => ++first[low + 1]);
  for (let v = 0; v < vertexCount; ++v) first[v + 1] += first[v];
  const ends = new Int32Array(first[vertexCount]), filled = new Int32Array(vertexCount);
  let count = 0;
  visit((low, high) => {
    const from = first[low], to = from + filled[low];
    for (let i = from; i < to; ++i) if (ends[i] === high) return;
    ends[to] = high;
    ++filled[low];
    ++count;
  });
  return listed(first, filled, ends, count);
}

/** @param {Int32Array} first  @param {Int32Array} filled  @param {Int32Array} ends  @param {number} count */
function listed(first, filled, ends, count) {
  const edges = new Uint32Array(2 * count);
  let at = 0;
  for (let v = 0; v < filled.length; ++v)
    for (let i = first[v]; i < first[v] + filled[v]; ++i) {
      edges[at++] = v;
      edges[at++] = ends[i];
    }
  return edges;
}

/** The same for faces of `corners` corners each. @param {Uint32Array} faces  @param {number} corners */
export function edgesOf(faces, corners) {
  let last = -1;
  for (let i = 0; i < faces.length; ++i) if (faces[i] > last) last = faces[i];
  return edgesOfRows(faces, strides(faces.length / corners, corners), last + 1);
}

/** 0, step, 2 step, …, count step. @param {number} count  @param {number} step */
export function strides(count, step) {
  const offsets = new Uint32Array(count + 1);
  for (let i = 0; i <= count; ++i) offsets[i] = step * i;
  return offsets;
}

/** For each point the number of the first one at the same place, to the bit. @param {Float64Array} points */
export function welded(points) {
  const count = points.length / 2;
  const words = new Uint32Array(points.buffer, points.byteOffset, 2 * points.length);
  let size = 16;
  while (size < 2 * count) size *= 2;
  const table = new Int32Array(size).fill(-1), ids = new Int32Array(count);
  for (let i = 0; i < count; ++i) {
    let slot = hashed(words, 4 * i) & (size - 1);
    for (; table[slot] >= 0; slot = (slot + 1) & (size - 1)) {
      const other = table[slot];
      if (points[2 * other] === points[2 * i] && points[2 * other + 1] === points[2 * i + 1]) break;
    }
    if (table[slot] < 0) table[slot] = i;
    ids[i] = table[slot];
  }
  return ids;
}

function hashed(/** @type {Uint32Array} */ words, /** @type {number} */ at) {
  let h = Math.imul(words[at] ^ Math.imul(words[at + 1], 0x9e3779b1), 0x85ebca6b);
  h ^= Math.imul(words[at + 2] ^ Math.imul(words[at + 3], 0x9e3779b1), 0xc2b2ae35) + (h >>> 13);
  h = Math.imul(h ^ (h >>> 15), 0x27d4eb2f);
  return h ^ (h >>> 13);
}

/**
 * Median length of about 200 of the edges, in the world.
 * @param {ArrayLike<number>} points  @param {ArrayLike<number>} edges
 */
export function typicalLength(points, edges) {
  const step = 2 * Math.max(1, Math.floor(edges.length / 400)), lengths = [];
  for (let i = 0; i + 1 < edges.length; i += step) {
    const a = 2 * edges[i], b = 2 * edges[i + 1];
    lengths.push(Math.hypot(points[a] - points[b], points[a + 1] - points[b + 1]));
  }
  return lengths.sort((a, b) => a - b)[lengths.length >> 1] ?? 0;
}
