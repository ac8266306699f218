// What the hand is about: the vertex in question, how to snap, what the tools are set to. None of it
// belongs to the project; all changes of the drawing go through here.
/** @import { App } from '../app' */
/** @import { Drawing, Point, Project } from '../types' */
/** @import { Place } from './model/drawing.js' */
/** @import { Snapped, Snapping } from './model/snap.js' */
import { askedSize } from '../run/preview.js';
import { findMeetings, problemsOf } from './crossings.js';
import { diagonalOf, pathOf, pathsOf, regionAt, vertexAt } from './model/drawing.js';
import { snap } from './model/snap.js';

const rest = 400;  // milliseconds after which a row of key presses is over

/** A changed drawing and what goes with it. @param {Project} project  @param {Drawing} drawing  @returns {Partial<Project>} */
export function withDrawing({ seedPoints }, drawing) {
  const inside = seedPoints.filter((p) => regionAt(drawing, p) >= 0);
  return { drawing, preset: '', seedPoints: inside.length === seedPoints.length ? seedPoints : inside };
}

export class Sketch {
  /** The chosen vertex, and the edge after it. @type {Place | null} */
  selected = null;
  /** The tool moves whole outlines. */
  whole = false;
  /** @type {Place | null} */
  hovered = null;
  /** @type {Snapping} */
  snapping = { vertices: true, grid: false, gridSize: 0, angles: false, angleStep: 15 };
  /** What the pointer was snapped to. @type {Snapped | null} */
  snapped = null;
  /** In the world's unit; 0: what fits the drawing. */
  brush = { radius: 0, size: 0, erase: false };
  circleCount = 32;
  eraseGuides = false;
  /** @type {Set<() => void>} */
  #listeners = new Set();
  #gestures = 0;
  #nudging = { key: '', timer: /** @type {ReturnType<typeof setTimeout> | undefined} */ (undefined) };
  /** @type {{drawing: Drawing, meetings: ReturnType<typeof findMeetings>, problems: ReturnType<typeof problemsOf>} | null} */
  #judged = null;

  /** @param {Pick<App, 'store' | 'stage' | 'announce'>} app */
  constructor({ store, stage, announce }) {
    this.store = store;
    this.stage = stage;
    this.announce = announce;
    store.subscribe((project, before) => {
      if (project.drawing !== before.drawing) this.#check();
    });
  }

  get drawing() { return this.store.project.drawing; }

  /** @param {() => void} listener */
  subscribe(listener) { this.#listeners.add(listener); }

  /** Something of the hand's state changed. */
  changed() {
    for (const listener of this.#listeners) listener();
    this.stage.invalidate('overlay');
  }

  /** @param {Partial<Sketch>} part */
  set(part) {
    Object.assign(this, part);
    this.changed();
  }

  /** The selection names a vertex that is there. */
  #check() {
    if (this.selected && !vertexAt(this.drawing, this.selected)) this.selected = null;
    this.hovered = null;
    this.changed();
  }

  /** The brush as it is now. */
  get brushNow() {
    const { radius, size } = this.brush;
    const diagonal = diagonalOf(this.drawing), target = askedSize(this.store.project) || diagonal / 40;
    return { radius: radius || 0.08 * diagonal, size: size || target / 3 };
  }

  /** @param {Drawing} drawing */
  #judge(drawing) {
    if (this.#judged?.drawing !== drawing)
      this.#judged = { drawing, meetings: findMeetings(drawing), problems: problemsOf(drawing) };
    return this.#judged;
  }

  /** @param {Drawing} drawing */
  problemsOf(drawing) { return this.#judge(drawing).problems; }
  get meetings() { return this.#judge(this.drawing).meetings; }

  /** A name for the changes of one drag. @param {string} what */
  newGesture(what) { return `${what} ${++this.#gestures}`; }

  /** @param {string} label  @param {Drawing} drawing  @param {string} [gesture] */
  change(label, drawing, gesture) {
    this.store.change(label, (project) => withDrawing(project, drawing), gesture);
    if (gesture === undefined) this.announce(label);
  }

  /** Changes that follow each other quickly by key are one. @param {string} label  @param {Drawing} drawing  @param {string} key */
  nudge(label, drawing, key) {
    if (this.#nudging.key !== key || this.store.gesture === '') this.#nudging.key = key;
    clearTimeout(this.#nudging.timer);
    this.change(label, drawing, `nudge ${key}`);
    this.#nudging.timer = setTimeout(() => this.store.settle(), rest);
  }

  /** @param {Point} at  @param {{shiftKey?: boolean}} event  @param {number} pixel  @param {{anchors?: Point[], more?: Point[],
   *   allowed?: (place: Place) => boolean}} [how] */
  snap(at, event, pixel, how = {}) {
    const snapped = snap(at, pixel, { drawing: this.drawing, snapping: this.snapping, shift: event.shiftKey ?? false, ...how });
    this.snapped = snapped.to === '' ? null : snapped;
    this.stage.invalidate('overlay');
    return snapped.at;
  }

  /** @param {Place | null} place */
  select(place) {
    this.selected = place;
    this.changed();
  }

  /** The vertex `step` further on, over all outlines. @param {number} step */
  selectNext(step) {
    const places = pathsOf(this.drawing).flatMap(({ region, loop, points }) => points.map((_, vertex) => ({ region, loop, vertex })));
    if (places.length === 0) return;
    const { selected } = this;
    const at = selected ? places.findIndex((p) => p.region === selected.region && p.loop === selected.loop && p.vertex === selected.vertex) : step > 0 ? -1 : 0;
    const place = places[(at + step + places.length) % places.length];
    this.select(place);
    this.announce(this.describe(place));
  }

  /** @param {Place} place */
  describe(place) {
    const [x, y] = vertexAt(this.drawing, place) ?? [0, 0];
    return `${nameOf(this.drawing, place)}, at ${short(x)}, ${short(y)}`;
  }
}

/** Counted from 0, as in the messages of the mesher, the inspector and the files. @param {Drawing} drawing  @param {Place} place */
export function nameOf(drawing, place) {
  const { region, loop, vertex } = place;
  if (region === -2) return `Point ${loop} of 0–${drawing.points.length - 1}`;
  const path = region === -1 ? `polyline ${loop}` : `loop ${loop}`;
  const within = region >= 0 && drawing.regions.length > 1 ? ` of region ${region}` : '';
  return `Vertex ${vertex} of 0–${pathOf(drawing, place).length - 1}, ${path}${within}`;
}

/** As many digits as a person wants to read. @param {number} value */
export const short = (value) => String(Number(value.toPrecision(7)));
