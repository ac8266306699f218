// A coarse mesh of a drawing that is still changing: a second worker meshes what is newest, one at a
// time, while the run of the real thing waits.
/** @import { LpquadWorker } from 'lpquad/worker' */
/** @import { Project, Snapshot } from '../types' */
import { withSize } from '../mesh/options.js';
import { areaOf } from '../sketch/model/drawing.js';
import { toCall } from '../state/project.js';

const expected = 400;  // quads: enough to see the flow, few enough to follow a hand
const budget = 40;     // milliseconds after which a mesh that is whole is good enough

/** @type {Project['options']} */
const quick = { method: 'best', effort: 'normal', iterations: 0, smoothing: 0, maxElements: 50000 };

/** The size of the quads, also of a number of them; 0: automatic. @param {Project} project */
export function askedSize({ drawing, options: { size = 0, quads = 0 } }) {
  return quads > 0 ? Math.sqrt(areaOf(drawing) / quads) : size;
}

/** The same project, for about 400 quads and without what takes long. @param {Project} project @returns {Project} */
export function coarse(project) {
  const asked = askedSize(project);
  const size = Math.max(asked, Math.sqrt(areaOf(project.drawing) / expected));
  const finest = Math.min(...project.sizes.map(([, , h]) => h), asked || Infinity);
  const factor = Math.max(1, size / finest);
  return {
    ...project,
    options: { ...withSize(project.options, size), ...quick },
    sizes: project.sizes.map(([x, y, h]) => [x, y, h * factor]),
  };
}

export class Preview {
  /** @type {() => Promise<LpquadWorker>} */
  #createEngine;
  /** @type {Promise<LpquadWorker> | undefined} */
  #engine;
  /** @type {Project | null} */
  #next = null;
  #busy = false;
  #generation = 0;
  /** @type {Set<() => void>} */
  #listeners = new Set();
  /** The newest preview, and of what. @type {{project: Project | null, frame: Snapshot | null}} */
  shown = { project: null, frame: null };

  /** @param {() => Promise<LpquadWorker>} createEngine */
  constructor(createEngine) {
    this.#createEngine = createEngine;
  }

  /** @param {() => void} listener */
  subscribe(listener) {
    this.#listeners.add(listener);
  }

  #show(/** @type {Preview['shown']} */ shown) {
    this.shown = shown;
    for (const listener of this.#listeners) listener();
  }

  /** So that the first drag does not wait for the worker. */
  async warm() {
    this.#engine ??= this.#createEngine();
    await this.#engine.then((engine) => engine.ready()).catch(() => { this.#engine = undefined; });
  }

  /** Meshes this project next; what waited is forgotten. @param {Project} project */
  ask(project) {
    this.#next = project;
    if (!this.#busy) void this.#work();
  }

  /** Nothing is asked for or shown any more. */
  clear() {
    ++this.#generation;
    this.#next = null;
    if (this.shown.frame !== null) this.#show({ project: null, frame: null });
  }

  async #work() {
    this.#busy = true;
    while (this.#next !== null) {
      const [project, generation] = [this.#next, this.#generation];
      this.#next = null;
      // What cannot be meshed has no preview; the run says why.
      const frame = await this.#mesh(coarse(project)).catch(() => null);
      if (frame !== null && generation === this.#generation) this.#show({ project, frame });
    }
    this.#busy = false;
  }

  /** @param {Project} project @returns {Promise<Snapshot | null>} */
  async #mesh(project) {
    await this.warm();
    const engine = await this.#engine;
    if (!engine) return null;
    const { domain, options } = toCall(project);
    const session = await engine.start(/** @type {any} */ (domain), options);
    const begun = performance.now();
    const whole = () => !['seeds', 'optimise', 'match'].includes(session.state.stage);
    while (session.state.stage !== 'done' && !(whole() && performance.now() - begun > budget)) await session.step(1);
    const frame = await session.snapshot({ quads: true });
    await session.dispose();
    return frame;
  }
}
