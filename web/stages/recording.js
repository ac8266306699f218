// A native run's --stages folder as a run that can be stepped: the interface of a WorkerSession over
// values that are there already.
/** @import { Layers, MeshResult, Snapshot, State } from 'lpquad' */
/** @import { Drawing, Point } from '../types' */
import { readIterates } from './iterates.js';
import { BadStages, Fields, readObj } from './parse.js';
import { etasOf, loopsOf, rimOf, tauOf, valencesOf } from './values.js';

/** @typedef {Omit<Snapshot, keyof State>} Shown */
/** @typedef {{state: State, shown: Shown}} Step */
/** @typedef {{drawing: Drawing, norm: number, steps: Step[], result: MeshResult}} Recording */

const needed = ['background.json', 'crosses.json', 'sizes.json', 'seeds.json', 'start.obj', 'triangles.json', 'cells.json',
  'energy.json', 'matching.json', 'matched_triangles.obj'];
const quadFile = /^quads-(\d+)-(.+)\.obj$/;
/** What comes after a file of quads has been written, by the last word of its name. @type {Record<string, State['stage']>} */
const stageAfter = { matched: 'clean', cleaned: 'patch', patched: 'smooth', annealed: 'smooth', grid: 'smooth', smoothed: 'check', kept: 'check' };

/** Whether files look like such a folder. @param {Iterable<string>} names */
export function isStagesFolder(names) {
  const known = [...names].filter((name) => needed.includes(name) || quadFile.test(name));
  return known.length >= 3;
}

/** @param {Map<string, string>} files  by name without folder  @param {ArrayBuffer} [bytes]  of iterates.bin  @returns {Recording}  throws BadStages */
export function readStages(files, bytes) {
  const quadNames = [...files.keys()].filter((name) => quadFile.test(name)).sort((a, b) => Number(quadFile.exec(a)?.[1]) - Number(quadFile.exec(b)?.[1]));
  const missing = [...needed.filter((name) => !files.has(name)), ...(quadNames.length > 0 ? [] : ['quads-1-….obj'])];
  if (missing.length > 0) throw new BadStages(`The folder lacks ${missing.join(', ')}. Choose the whole folder that --stages wrote.`);
  const text = (/** @type {string} */ name) => /** @type {string} */ (files.get(name));
  const json = (/** @type {string} */ name) => new Fields(name, text(name));
  const fields = readFields(json);
  const energy = json('energy.json');
  const start = readObj('start.obj', text('start.obj'));
  const boundaryNodes = start.points.length / 2 - json('seeds.json').list('seeds').length;
  const before = { ...fields, triangles: triangleLayer(start, boundaryNodes) };
  const after = { ...fields, ...readTriangles(json, energy, boundaryNodes) };
  const matching = readMatching(json('matching.json'), readObj('matched_triangles.obj', text('matched_triangles.obj')));
  const quads = quadNames.map((name) => quadLayer(readObj(name, text(name)), boundaryNodes));
  const between = readIterates(files.get('iterates.json'), bytes);
  const stages = quadNames.map((name) => stageAfter[quadFile.exec(name)?.[2] ?? ''] ?? 'check');
  const steps = stepsOf(energy, before, between, after, matching, quads, stages);
  const outline = loopsOf(start.points, rimOf([{ list: start.triangles, corners: 3 }]));
  const report = [...files].find(([name]) => /(^|\.)report\.json$/.test(name))?.[1];
  return { drawing: drawingOf(outline), norm: energy.number('p'), steps, result: resultOf(quads[quads.length - 1], energy, report) };
}

/** @param {Point[][]} loops  @returns {Drawing} */
const drawingOf = (loops) => ({ regions: [{ name: '', loops }], polylines: [], points: [] });

/** @param {(name: string) => Fields} json  @returns {Shown} */
function readFields(json) {
  const [background, crosses, sizes] = ['background.json', 'crosses.json', 'sizes.json'].map(json);
  const points = crosses.tuples('points', 2), count = points.length / 2;
  const singular = crosses.list('singularities');
  if (!singular.every((entry) => ['x', 'y', 'index'].every((name) => Number.isFinite(entry?.[name])))) throw new BadStages('crosses.json has a singularity without x, y and index.');
  return {
    crosses: { points, axes: crosses.tuples('axis', 2, count), singularities: Float64Array.from(singular.flatMap(({ x, y }) => [x, y])),
      indices: Int32Array.from(singular, ({ index }) => index) },
    sizes: { points: sizes.tuples('points', 2), triangles: background.indices('triangles', 3, sizes.list('points').length), sizes: sizes.numbers('h', sizes.list('points').length) },
  };
}

/** @param {Pick<import('./parse.js').Faces, 'points' | 'triangles'>} mesh  @param {number} boundaryNodes */
const triangleLayer = ({ points, triangles }, boundaryNodes) => ({ points, triangles, boundaryNodes });

/** @param {(name: string) => Fields} json  @param {Fields} energy  @param {number} boundaryNodes  @returns {Shown} */
function readTriangles(json, energy, boundaryNodes) {
  const mesh = json('triangles.json'), cells = json('cells.json');
  const points = mesh.tuples('points', 2), count = points.length / 2;
  const triangles = triangleLayer({ points, triangles: mesh.indices('triangles', 3, count) }, boundaryNodes);
  const rows = cells.list('cells');
  if (rows.length !== count) throw new BadStages(`cells.json has ${rows.length} cells for ${count} points.`);
  /** @type {number[]} */ const sites = [];
  /** @type {number[]} */ const offsets = [0];
  /** @type {number[]} */ const corners = [];
  rows.forEach((polygons, site) => {
    for (const polygon of polygons) {
      corners.push(...polygon.flat());
      sites.push(site);
      offsets.push(corners.length / 2);
    }
  });
  if (!corners.every(Number.isFinite)) throw new BadStages('cells.json holds something that is no finite number.');
  const [whole, area] = [energy.numbers('cellEnergy', count), energy.numbers('cellArea', count)];
  const density = whole.map((value, v) => (area[v] > 0 ? value / area[v] : 0));
  return { triangles, cells: { points: Float64Array.from(corners), offsets: Int32Array.from(offsets), sites: Int32Array.from(sites), density, energy: energy.number('energy') } };
}

/** @param {Fields} json  @param {Pick<import('./parse.js').Faces, 'points' | 'triangles'>} mesh  @returns {NonNullable<Shown['matching']>} */
function readMatching(json, { points, triangles }) {
  const count = triangles.length / 3;
  const pairs = json.indices('matching', 2, count), graph = json.tuples('edges', 3);
  const cost = new Map();
  for (let k = 0; k < graph.length; k += 3) cost.set(`${Math.min(graph[k], graph[k + 1])} ${Math.max(graph[k], graph[k + 1])}`, graph[k + 2]);
  const mates = new Int32Array(count).fill(-1), extra = new Int32Array(count), costs = new Float64Array(count);
  for (let k = 0; k < pairs.length; k += 2) {
    const [u, v] = [pairs[k], pairs[k + 1]];
    const corners = new Set([...triangles.subarray(3 * u, 3 * u + 3), ...triangles.subarray(3 * v, 3 * v + 3)]);
    for (const [one, other] of [[u, v], [v, u]]) {
      mates[one] = other;
      extra[one] = corners.size === 4 ? 0 : 1;  // neighbours share two of their corners
      costs[one] = cost.get(`${Math.min(u, v)} ${Math.max(u, v)}`) ?? 0;
    }
  }
  return { points, triangles, mates, extra, costs };
}

/** @param {import('./parse.js').Faces} mesh  @param {number} boundaryNodes  @returns {NonNullable<Shown['quads']>} */
function quadLayer({ points, quads, triangles }, boundaryNodes) {
  const faces = [{ list: quads, corners: 4 }, { list: triangles, corners: 3 }];
  return { points, quads, triangles, eta: etasOf(points, quads, triangles.length / 3), ...valencesOf(points, faces), boundaryNodes };
}

/** @typedef {import('./iterates.js').Iterate} Iterate */

/** @param {Fields} energy  @param {Shown} before  @param {Iterate[]} between  @param {Shown} after  @param {NonNullable<Shown['matching']>} matching  @param {NonNullable<Shown['quads']>[]} quads  @param {State['stage'][]} stages  of the quads  @returns {Step[]} */
function stepsOf(energy, before, between, after, matching, quads, stages) {
  const values = energy.numbers('history'), norms = energy.numbers('gradientNormHistory', values.length);
  const iterations = Math.max(0, values.length - 1);
  const tau = (/** @type {Shown} */ { triangles }) => (triangles ? tauOf(triangles.points, triangles.triangles) : 0);
  const place = (/** @type {State['stage']} */ stage, more = {}) => ({ stage, iteration: 0, maxIterations: iterations, energy: 0, gradientNorm: 0, tau: 0, ...more });
  const optimise = (/** @type {number} */ iteration, /** @type {Shown} */ shown) => /** @type {[Omit<State, 'tick'>, Shown]} */ ([place('optimise', { iteration, energy: values[iteration], gradientNorm: norms[iteration], tau: tau(shown) }), shown]);
  /** @type {[Omit<State, 'tick'>, Shown][]} */
  const all = [
    [place('seeds'), { crosses: before.crosses, sizes: before.sizes }],
    [place('optimise', { energy: values[0] ?? energy.number('energy'), gradientNorm: norms[0] ?? 0, tau: tau(before) }), before],
    ...between.filter(({ iteration }) => iteration < iterations).map(({ iteration, triangles, cells }) =>
      optimise(iteration, { ...before, triangles, cells: { ...cells, energy: values[iteration] } })),
    [place('match', { iteration: iterations, energy: energy.number('energy'), gradientNorm: norms.at(-1) ?? 0, tau: tau(after) }), after],
    ...quads.map((layer, k) => /** @type {[Omit<State, 'tick'>, Shown]} */ ([place(stages[k]), { ...after, matching, quads: layer }])),
    [place('done'), { ...after, matching, quads: quads[quads.length - 1] }],
  ];
  return all.map(([state, shown], tick) => ({ state: { ...state, tick }, shown }));
}

/** @param {NonNullable<Shown['quads']>} layer  @param {Fields} energy  @param {string} [report]  as --report wrote it  @returns {MeshResult} */
function resultOf({ points, quads, triangles, eta, valence, excess, boundaryNodes }, energy, report) {
  const rim = rimOf([{ list: quads, corners: 4 }, { list: triangles, corners: 3 }]);
  const onRim = new Set(rim.flat());
  const inside = [...valence].filter((_, v) => !onRim.has(v) && valence[v] > 0);
  const sorted = eta.slice(0, quads.length / 4).sort();
  const etaHistogram = Array.from({ length: 20 }, (_, k) => sorted.filter((value) => Math.min(19, Math.floor(20 * value)) === k).length);
  const computed = {
    vertices: points.length / 2, quads: quads.length / 4, triangles: triangles.length / 3, boundaryNodes, boundaryEdges: rim.length, hash: '', chain: 'recorded',
    quality: {
      etaMean: sorted.reduce((sum, value) => sum + value, 0) / Math.max(1, sorted.length), etaMin: sorted[0] ?? 0, etaP5: sorted[Math.floor(0.05 * sorted.length)] ?? 0,
      interiorVertices: inside.length, fourValentPercent: 100 * inside.filter((count) => count === 4).length / Math.max(1, inside.length), inverted: 0, nonconvex: 0,
      valenceHistogram: Array.from({ length: 10 }, (_, k) => inside.filter((count) => Math.min(9, count) === k).length), etaHistogram,
    },
    lp: { ran: energy.list('history').length > 0, energy: energy.list('history'), gradientNorm: energy.list('gradientNormHistory') },
    cpuSeconds: {}, warnings: [], options: {}, irregular: excess.filter(Boolean).length,
  };
  return /** @type {any} */ ({
    points, quads, triangles, quadRegions: new Int32Array(quads.length / 4), triangleRegions: new Int32Array(triangles.length / 3),
    edges: Uint32Array.from(rim.flat()), edgeTags: new Int32Array(rim.length).fill(-1), edgeRegions: Int32Array.from(rim.flatMap(() => [0, -1])),
    edgeOrigins: new Int32Array(3 * rim.length), taggedPoints: new Uint32Array(0), pointTags: new Int32Array(0), regions: [''], tags: [], boundaryNodes,
    report: report === undefined ? computed : { ...computed, ...new Fields('report.json', report).value },
  });
}

/** The layers that are drawn, of what a step has. @param {Shown} shown  @param {Layers} layers  @returns {Shown} */
const chosen = (shown, layers) => Object.fromEntries(Object.entries(shown).filter(([name]) => layers[/** @type {keyof Layers} */ (name)]));

/** With the interface of a WorkerSession. */
export class RecordedSession {
  #steps;
  #result;
  #at = 0;

  /** @param {Pick<Recording, 'steps' | 'result'>} recording */
  constructor({ steps, result }) {
    this.#steps = steps;
    this.#result = result;
  }

  get state() { return this.#steps[this.#at].state; }
  /** @param {number} [ticks]  @param {{onProgress?: (state: State) => void}} [calls] */
  async step(ticks = 1, { onProgress = () => {} } = {}) {
    const from = this.#at;
    await this.restore(from + ticks);
    for (const { state } of this.#steps.slice(from + 1, this.#at)) onProgress(state);
    return this.state;
  }
  /** @param {number} tick */
  async restore(tick) {
    this.#at = Math.max(0, Math.min(this.#steps.length - 1, tick));
    return this.state;
  }
  /** @param {Layers} [layers]  @returns {Promise<Snapshot>} */
  async snapshot(layers = {}) { return { ...this.state, ...chosen(this.#steps[this.#at].shown, layers) }; }
  async finish() {
    this.#at = this.#steps.length - 1;
    return this.#result;
  }
  async clone() { return new RecordedSession({ steps: this.#steps, result: this.#result }); }
  async dispose() {}
  async [Symbol.asyncDispose]() {}
}
