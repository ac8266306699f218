// Moves, adds and removes vertices; moves whole outlines.
/** @import { Point } from '../../types' */
/** @import { Tool } from '../../stage/stage.js' */
/** @import { Sketch } from '../sketch.js' */
/** @import { Place } from '../model/drawing.js' */
import * as model from '../model/drawing.js';
import { distance, nearestOnSegment } from '../model/geometry.js';
import { gridSizeOf, nearestVertex } from '../model/snap.js';
import { drawEditing } from '../marks.js';

const reachOf = (/** @type {PointerEvent} */ event) => event.pointerType === 'touch' ? 22 : 10;

/** The edge nearest to a place. @param {import('../../types').Drawing} drawing  @param {Point} at  @param {number} within  @returns {{place: Place, at: Point} | null} */
export function nearestEdge(drawing, at, within) {
  let best = null, least = within;
  for (const { region, loop, points } of model.pathsOf(drawing))
    for (let vertex = 0; vertex < points.length - (region >= 0 ? 0 : 1); ++vertex) {
      const foot = nearestOnSegment(at, points[vertex], points[(vertex + 1) % points.length]);
      const away = distance(at, foot);
      if (away < least) {
        least = away;
        best = { place: { region, loop, vertex }, at: foot };
      }
    }
  return best;
}

/** The neighbours of a vertex: directions start there. @param {import('../../types').Drawing} drawing  @param {Place} place  @returns {Point[]} */
function neighbours(drawing, place) {
  const path = model.pathOf(drawing, place), n = path.length;
  if (n < 2) return [];
  const around = model.isClosed(place) ? [place.vertex - 1 + n, place.vertex + 1] : [place.vertex - 1, place.vertex + 1].filter((i) => i >= 0 && i < n);
  return around.map((i) => path[i % n]);
}

/** @typedef {{gesture: string, label: string, from: Point, base: import('../../types').Drawing, whole: Place | null, places: Place[], start: Point}} Drag */

/** @implements {Tool} */
export class EditTool {
  id = 'edit';
  #sketch;
  /** @type {Drag | null} */
  #drag = null;

  /** @param {Sketch} sketch */
  constructor(sketch) {
    this.#sketch = sketch;
  }

  /** The vertex under the pointer, else the edge. @param {Point} at  @param {PointerEvent} event  @param {number} pixel */
  #under(at, event, pixel) {
    const reach = reachOf(event) * pixel, { drawing } = this.#sketch;
    const vertex = nearestVertex(drawing, at, reach);
    return { vertex, edge: vertex ? null : nearestEdge(drawing, at, 0.7 * reach) };
  }

  /** @param {Point} at  @param {PointerEvent} event  @param {number} pixel */
  down(at, event, pixel) {
    const sketch = this.#sketch;
    const whole = sketch.whole || event.ctrlKey || event.metaKey;
    const { vertex, edge } = this.#under(at, event, pixel);
    const place = vertex ?? edge?.place;
    if (!place) {
      sketch.select(null);
      return false;
    }
    const gesture = sketch.newGesture('drag');
    if (edge && !whole) {
      const added = { ...edge.place, vertex: edge.place.vertex + 1 };
      sketch.change('Add a vertex', model.addVertex(sketch.drawing, edge.place, edge.at), gesture);
      this.#begin(added, at, false, 'Add a vertex', gesture);
    } else this.#begin(place, at, whole, whole ? 'Move an outline' : 'Move a vertex', gesture);
    return true;
  }

  /** @param {Place} place  @param {Point} at  @param {boolean} whole  @param {string} label @param {string} gesture */
  #begin(place, at, whole, label, gesture) {
    const base = this.#sketch.drawing;
    const start = /** @type {Point} */ (model.vertexAt(base, place));
    this.#drag = { gesture, label, from: at, base, whole: whole ? place : null, places: model.placesAt(base, start), start };
    this.#sketch.select(place);
  }

  /** @param {Point} at  @param {PointerEvent} event  @param {number} pixel */
  move(at, event, pixel) {
    if (this.#drag) return this.#follow(this.#drag, at, event, pixel);
    const sketch = this.#sketch;
    const { vertex, edge } = this.#under(at, event, pixel);
    if (JSON.stringify(vertex) !== JSON.stringify(sketch.hovered)) {
      sketch.hovered = vertex;
      sketch.stage.invalidate('overlay');
    }
    sketch.stage.overlay.style.cursor = vertex || (edge && sketch.whole) ? 'move' : edge ? 'copy' : 'default';
  }

  /** @param {Drag} now  @param {Point} at  @param {PointerEvent} event  @param {number} pixel */
  #follow(now, at, event, pixel) {
    const sketch = this.#sketch;
    /** @type {Point} */
    const wanted = [now.start[0] + at[0] - now.from[0], now.start[1] + at[1] - now.from[1]];
    const own = (/** @type {Place} */ p) => now.places.some(({ region }) => region === p.region);
    const anchors = now.whole ? [now.start] : neighbours(now.base, now.places[0]);
    const to = sketch.snap(wanted, event, pixel, { anchors, allowed: (place) => !own(place) });
    const moved = now.whole ? model.shiftPath(now.base, now.whole, to[0] - now.start[0], to[1] - now.start[1])
      : model.movePlaces(now.base, now.places, to);
    sketch.change(now.label, moved, now.gesture);
  }

  up() {
    if (this.#drag === null) return;
    this.#drag = null;
    this.#sketch.snapped = null;
    this.#sketch.store.settle();
    this.#sketch.changed();
  }

  cancel() {
    const { store } = this.#sketch;
    if (this.#drag && store.gesture === this.#drag.gesture) store.undo();
    this.up();
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const sketch = this.#sketch;
    const name = event.key.length === 1 ? event.key.toUpperCase() : event.key;
    if (event.ctrlKey || event.metaKey || (event.shiftKey && name.length === 1)) return false;
    if (name === 'N' || name === 'P') sketch.selectNext(name === 'N' ? 1 : -1);
    else if (name.startsWith('Arrow')) return moveByKey(sketch, name, event);
    else if (sketch.selected === null) return false;
    else if (name === 'Insert') insertAfter(sketch);
    else if (name === 'Delete' || name === 'Backspace') removeSelected(sketch);
    else if (name === 'Escape') sketch.select(null);
    else return false;
    return true;
  }

  /** @param {CanvasRenderingContext2D} context  @param {import('../../types').View} view */
  draw(context, view) {
    drawEditing(context, view, this.#sketch);
  }
}

/** By an arrow key, whether there is something to move. @param {Sketch} sketch  @param {string} key  @param {KeyboardEvent} event */
function moveByKey(sketch, key, event) {
  const { selected, drawing, whole } = sketch;
  const at = selected && model.vertexAt(drawing, selected);
  if (!selected || !at) return false;
  const step = gridSizeOf(sketch.snapping, sketch.stage.pixel) * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
  const [dx, dy] = /** @type {Record<string, Point>} */ ({ ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] })[key];
  const tidy = (/** @type {number} */ v) => Number(v.toPrecision(14));
  const moved = whole ? model.shiftPath(drawing, selected, dx, dy)
    : model.moveVertex(drawing, selected, [tidy(at[0] + dx), tidy(at[1] + dy)]);
  sketch.nudge(whole ? 'Move an outline' : 'Move a vertex', moved, `${selected.region} ${selected.loop} ${selected.vertex}`);
  return true;
}

/** A vertex in the middle of the edge after the chosen one. @param {Sketch} sketch */
export function insertAfter(sketch) {
  const { selected, drawing } = sketch;
  if (!selected) return;
  const last = !model.isClosed(selected) && selected.vertex === model.pathOf(drawing, selected).length - 1;
  const edge = last ? { ...selected, vertex: selected.vertex - 1 } : selected;
  if (edge.vertex < 0) return;
  sketch.change('Add a vertex', model.addVertex(drawing, edge, model.middleOf(drawing, edge)));
  sketch.select({ ...edge, vertex: edge.vertex + 1 });
}

/** @param {Sketch} sketch */
export function removeSelected(sketch) {
  const { selected, drawing, whole } = sketch;
  if (!selected) return;
  const before = model.pathOf(drawing, selected).length;
  sketch.change(whole ? 'Remove an outline' : 'Remove a vertex', whole ? model.removePath(drawing, selected) : model.removeVertex(drawing, selected));
  const left = model.pathOf(sketch.drawing, selected).length;
  sketch.select(left === before - 1 ? { ...selected, vertex: Math.max(0, selected.vertex - 1) } : null);
}
