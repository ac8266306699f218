// Where edges of a drawing meet though they must not: crossings, overlaps and touches, by the same
// rules as the library's (core/domain/meetings.cpp), so that it need not be asked while somebody
// draws. Edges are put into the cells of a grid one after the other and compared with those there.
/** @import { Drawing, Point, Region, Run } from '../types' */
import { orient } from './model/orient.js';

/** @typedef {{region: number, loop: number, edge: number}} EdgeName  region -1: of a polyline */
/** @typedef {'crossing' | 'overlap' | 'touch' | 'corner'} MeetingKind */
/** @typedef {{kind: MeetingKind, one: EdgeName, two: EdgeName, at: Point}} Meeting */
/** @typedef {{xy: Float64Array, region: Int32Array, loop: Int32Array, edge: Int32Array, count: number}} Edges */

// Of drawings that need more than this the library is the judge, in its worker.
const mostEdges = 50000, mostComparisons = 500000;
const mostMeetings = 100;

/** @param {Drawing} drawing  @returns {{points: Point[], closed: boolean, region: number, loop: number}[]} */
function chainsOf({ regions, polylines }) {
  return [
    ...regions.flatMap(({ loops }, region) => loops.map((points, loop) => ({ points, closed: true, region, loop }))),
    ...polylines.map(({ points }, loop) => ({ points, closed: false, region: -1, loop })),
  ];
}

/** @param {Drawing} drawing  @returns {Edges} without those of no length */
function edgesOf(drawing) {
  const chains = chainsOf(drawing);
  const most = chains.reduce((sum, { points }) => sum + points.length, 0);
  const xy = new Float64Array(4 * most);
  const region = new Int32Array(most), loop = new Int32Array(most), edge = new Int32Array(most);
  let count = 0;
  for (const chain of chains) {
    const { points, closed } = chain;
    for (let i = 0; i < points.length - (closed ? 0 : 1); ++i) {
      const [ax, ay] = points[i], [bx, by] = points[i + 1 < points.length ? i + 1 : 0];
      if ((ax === bx && ay === by) || !Number.isFinite(ax + ay + bx + by)) continue;
      xy.set([ax, ay, bx, by], 4 * count);
      region[count] = chain.region;
      loop[count] = chain.loop;
      edge[count++] = i;
    }
  }
  return { xy, region, loop, edge, count };
}

/** Cells of about one edge each; an edge is in every cell that it passes. */
class Grid {
  /** @param {Edges} edges */
  constructor({ xy, count }) {
    this.xy = xy;
    let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
    for (let i = 0; i < 4 * count; i += 2) {
      left = Math.min(left, xy[i]);
      right = Math.max(right, xy[i]);
      bottom = Math.min(bottom, xy[i + 1]);
      top = Math.max(top, xy[i + 1]);
    }
    const width = right - left || 1, height = top - bottom || 1;
    this.left = left;
    this.bottom = bottom;
    this.columns = Math.min(1024, Math.ceil(Math.sqrt(count * width / height)));
    this.rows = Math.min(1024, Math.ceil(Math.sqrt(count * height / width)));
    this.cellWidth = width / this.columns;
    this.cellHeight = height / this.rows;
    this.heads = new Int32Array(this.columns * this.rows).fill(-1);
    /** @type {number[]} */
    this.items = [];
    /** @type {number[]} */
    this.next = [];
    this.seen = new Int32Array(count).fill(-1);
    this.comparisons = 0;
  }

  /** Puts an edge in and tells which were near. @param {number} edge  @param {(other: number) => void} visit */
  add(edge, visit) {
    const { xy, cellHeight, bottom } = this;
    const i = 4 * edge;
    const up = xy[i + 1] <= xy[i + 3];
    const x0 = xy[up ? i : i + 2], y0 = xy[up ? i + 1 : i + 3] - bottom;
    const x1 = xy[up ? i + 2 : i], y1 = xy[up ? i + 3 : i + 1] - bottom;
    const slope = y1 > y0 ? (x1 - x0) / (y1 - y0) : 0;
    const margin = 1e-6 * cellHeight;
    const last = this.#row(y1 + margin);
    for (let row = this.#row(y0 - margin); row <= last; ++row) {
      const low = Math.max(y0, row * cellHeight - margin), high = Math.min(y1, (row + 1) * cellHeight + margin);
      const from = y1 > y0 ? x0 + (low - y0) * slope : x0, to = y1 > y0 ? x0 + (high - y0) * slope : x1;
      this.#addToRow(row, Math.min(from, to), Math.max(from, to), edge, visit);
    }
  }

  /** @param {number} y */
  #row(y) { return Math.max(0, Math.min(this.rows - 1, Math.floor(y / this.cellHeight))); }
  /** @param {number} x */
  #column(x) { return Math.max(0, Math.min(this.columns - 1, Math.floor((x - this.left) / this.cellWidth))); }

  #addToRow(/** @type {number} */ row, /** @type {number} */ from, /** @type {number} */ to, /** @type {number} */ edge,
    /** @type {(other: number) => void} */ visit) {
    const margin = 1e-6 * this.cellWidth;
    const last = this.#column(to + margin);
    for (let column = this.#column(from - margin); column <= last; ++column) {
      const cell = row * this.columns + column;
      for (let k = this.heads[cell]; k >= 0; k = this.next[k]) {
        const other = this.items[k];
        ++this.comparisons;
        if (this.seen[other] === edge) continue;
        this.seen[other] = edge;
        visit(other);
      }
      this.next.push(this.heads[cell]);
      this.items.push(edge);
      this.heads[cell] = this.items.length - 1;
    }
  }
}

/** @param {Float64Array} xy  @param {number} i  @param {number} k  offsets of points */
const same = (xy, i, k) => xy[i] === xy[k] && xy[i + 1] === xy[k + 1];

/** Where c lies against the line from a to b. @param {Float64Array} xy @param {number} a @param {number} b @param {number} c */
const side = (xy, a, b, c) => orient(xy[a], xy[a + 1], xy[b], xy[b + 1], xy[c], xy[c + 1]);

/** Whether c, on the line of a and b, lies between them. @param {Float64Array} xy @param {number} a @param {number} b @param {number} c */
const between = (xy, a, b, c) =>
  Math.min(xy[a], xy[b]) <= xy[c] && xy[c] <= Math.max(xy[a], xy[b])
  && Math.min(xy[a + 1], xy[b + 1]) <= xy[c + 1] && xy[c + 1] <= Math.max(xy[a + 1], xy[b + 1]);

/** Two edges from one point: do they leave it in the same direction? */
function sharesLine(/** @type {Float64Array} */ xy, /** @type {number} */ from, /** @type {number} */ p, /** @type {number} */ q) {
  const dx = (xy[p] - xy[from]) * (xy[q] - xy[from]), dy = (xy[p + 1] - xy[from + 1]) * (xy[q + 1] - xy[from + 1]);
  return dx >= 0 && dy >= 0 && side(xy, from, p, q) === 0;
}

/** @returns {{kind: MeetingKind, at: Point} | null} @param {Edges} edges  @param {number} e  @param {number} f */
function meet({ xy, region }, e, f) {
  const a = 4 * e, b = a + 2, c = 4 * f, d = c + 2;
  const ac = same(xy, a, c), ad = same(xy, a, d), bc = same(xy, b, c), bd = same(xy, b, d);
  const place = (/** @type {number} */ i) => /** @type {Point} */ ([xy[i], xy[i + 1]]);
  if ((ac && bd) || (ad && bc)) {
    const shared = region[e] !== region[f] && region[e] >= 0 && region[f] >= 0;
    return shared ? null : { kind: 'overlap', at: place(a) };
  }
  if (ac || ad || bc || bd) {
    const from = ac || ad ? a : b, p = ac || ad ? b : a, q = ac || bc ? d : c;
    return sharesLine(xy, from, p, q) ? { kind: 'overlap', at: place(from) } : null;
  }
  if (Math.max(xy[a], xy[b]) < Math.min(xy[c], xy[d]) || Math.max(xy[c], xy[d]) < Math.min(xy[a], xy[b])
    || Math.max(xy[a + 1], xy[b + 1]) < Math.min(xy[c + 1], xy[d + 1])
    || Math.max(xy[c + 1], xy[d + 1]) < Math.min(xy[a + 1], xy[b + 1])) return null;
  const oc = side(xy, a, b, c), od = side(xy, a, b, d);
  if ((oc > 0 && od > 0) || (oc < 0 && od < 0)) return null;
  const oa = side(xy, c, d, a), ob = side(xy, c, d, b);
  if ((oa > 0 && ob > 0) || (oa < 0 && ob < 0)) return null;
  if (oc !== 0 && od !== 0 && oa !== 0 && ob !== 0) {
    const t = oa / (oa - ob);
    return { kind: 'crossing', at: [xy[a] + t * (xy[b] - xy[a]), xy[a + 1] + t * (xy[b + 1] - xy[a + 1])] };
  }
  const ends = [oc === 0 && between(xy, a, b, c) ? c : -1, od === 0 && between(xy, a, b, d) ? d : -1,
    oa === 0 && between(xy, c, d, a) ? a : -1, ob === 0 && between(xy, c, d, b) ? b : -1].filter((i) => i >= 0);
  if (ends.length === 0) return null;
  return { kind: oc === 0 && od === 0 ? 'overlap' : 'touch', at: place(ends[0]) };
}

/** Corners of one region at the same place. @param {Edges} edges  @param {(e: number, f: number, at: Point) => void} tell */
function sharedCorners({ xy, region, count }, tell) {
  const order = Array.from({ length: count }, (_, i) => i).filter((i) => region[i] >= 0);
  order.sort((e, f) => region[e] - region[f] || xy[4 * e] - xy[4 * f] || xy[4 * e + 1] - xy[4 * f + 1] || e - f);
  for (let k = 1; k < order.length; ++k) {
    const e = order[k - 1], f = order[k];
    if (region[e] === region[f] && same(xy, 4 * e, 4 * f)) tell(e, f, [xy[4 * e], xy[4 * e + 1]]);
  }
}

/** All meetings, at most a hundred. @param {Drawing} drawing  @returns {Meeting[]} */
export function findMeetings(drawing) {
  const edges = edgesOf(drawing);
  /** @type {Meeting[]} */
  const found = [];
  if (edges.count < 2 || edges.count > mostEdges) return found;
  const nameOf = (/** @type {number} */ e) => ({ region: edges.region[e], loop: edges.loop[e], edge: edges.edge[e] });
  const keep = (/** @type {MeetingKind} */ kind, /** @type {number} */ e, /** @type {number} */ f, /** @type {Point} */ at) =>
    void (found.length < mostMeetings && found.push({ kind, one: nameOf(Math.min(e, f)), two: nameOf(Math.max(e, f)), at }));
  const grid = new Grid(edges);
  for (let e = 0; e < edges.count && grid.comparisons < mostComparisons; ++e)
    grid.add(e, (f) => {
      const meeting = meet(edges, e, f);
      if (meeting) keep(meeting.kind, e, f, meeting.at);
    });
  sharedCorners(edges, (e, f, at) => keep('corner', e, f, at));
  return found;
}

const order = ['crossing', 'overlap', 'touch', 'corner'];

/** @param {Meeting} meeting  @returns {string} the library's code for it */
function codeOf({ kind, one, two }) {
  if (kind === 'overlap') return 'OVERLAPPING_EDGES';
  if (kind !== 'crossing') return 'TOUCHING';
  return one.region !== two.region && one.region >= 0 && two.region >= 0 ? 'REGION_CONFLICT' : 'SELF_INTERSECTION';
}

const verbs = { crossing: 'cross', overlap: 'lie on each other', touch: 'touch', corner: 'meet in a corner' };

/** As the library names it. @param {EdgeName} name  @param {Region[]} regions */
function inWords({ region, loop, edge }, regions) {
  if (region < 0) return `edge ${edge} of polyline ${loop}`;
  const { name } = regions[region];
  return `edge ${edge} of loop ${loop}${regions.length < 2 ? '' : ` of region ${region}${name ? ` (${name})` : ''}`}`;
}

/**
 * What keeps a drawing from being meshed, as far as it can be seen at once; worst first, in the form
 * of the library's errors.
 * @param {Drawing} drawing  @returns {NonNullable<Run['error']>[]}
 */
export function problemsOf(drawing) {
  return findMeetings(drawing)
    .sort((a, b) => order.indexOf(a.kind) - order.indexOf(b.kind))
    .map((meeting) => {
      const { kind, one, two, at: [x, y] } = meeting;
      const region = one.region >= 0 ? { region: one.region } : {};
      return {
        code: codeOf(meeting),
        message: `The ${inWords(one, drawing.regions)} and the ${inWords(two, drawing.regions)} ${verbs[kind]}.`,
        where: { ...region, loop: one.loop, edge: one.edge, otherLoop: two.loop, otherEdge: two.edge, x, y },
      };
    });
}
