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

/** @param {Sketch} sketch  @returns {Tool} */
export function editTool(sketch) {
  /** @type {Drag | null} */
  let drag = null;

  /** @param {Place} place  @param {Point} at  @param {boolean} whole  @param {string} label @param {string} gesture */
  function begin(place, at, whole, label, gesture) {
    const base = sketch.drawing;
    const start = /** @type {Point} */ (model.vertexAt(base, place));
    drag = { gesture, label, from: at, base, whole: whole ? place : null, places: model.placesAt(base, start), start };
    sketch.select(place);
  }

  /** @param {Point} at  @param {PointerEvent} event  @param {number} pixel */
  function down(at, event, pixel) {
    const reach = reachOf(event) * pixel;
    const whole = sketch.whole || event.ctrlKey || event.metaKey;
    const vertex = nearestVertex(sketch.drawing, at, reach);
    const edge = vertex ? null : nearestEdge(sketch.drawing, at, 0.7 * reach);
    const place = vertex ?? edge?.place;
    if (!place) {
      sketch.select(null);
      return false;
    }
    const gesture = sketch.newGesture('drag');
    if (edge && !whole) {
      const added = { ...edge.place, vertex: edge.place.vertex + 1 };
      sketch.change('Add a vertex', model.addVertex(sketch.drawing, edge.place, edge.at), gesture);
      begin(added, at, false, 'Add a vertex', gesture);
    } else begin(place, at, whole, whole ? 'Move an outline' : 'Move a vertex', gesture);
    return true;
  }

  /** @param {Drag} now  @param {Point} at  @param {PointerEvent} event  @param {number} pixel */
  function follow(now, at, event, pixel) {
    /** @type {Point} */
    const wanted = [now.start[0] + at[0] - now.from[0], now.start[1] + at[1] - now.from[1]];
    const own = (/** @type {Place} */ p) => now.places.some(({ region }) => region === p.region);
    const anchors = now.whole ? [now.start] : neighbours(now.base, now.places[0]);
    const to = sketch.snap(wanted, event, pixel, { anchors, allowed: (place) => !own(place) });
    const moved = now.whole ? model.shiftPath(now.base, now.whole, to[0] - now.start[0], to[1] - now.start[1])
      : model.movePlaces(now.base, now.places, to);
    sketch.change(now.label, moved, now.gesture);
  }

  /** @param {Point} at  @param {PointerEvent} event  @param {number} pixel */
  function move(at, event, pixel) {
    if (drag) return follow(drag, at, event, pixel);
    const reach = reachOf(event) * pixel;
    const vertex = nearestVertex(sketch.drawing, at, reach);
    const edge = vertex ? null : nearestEdge(sketch.drawing, at, 0.7 * reach);
    if (JSON.stringify(vertex) !== JSON.stringify(sketch.hovered)) {
      sketch.hovered = vertex;
      sketch.stage.invalidate('overlay');
    }
    sketch.stage.overlay.style.cursor = vertex || (edge && sketch.whole) ? 'move' : edge ? 'copy' : 'default';
  }

  function end() {
    if (drag === null) return;
    drag = null;
    sketch.snapped = null;
    sketch.store.settle();
    sketch.changed();
  }

  /** @param {string} key  @param {KeyboardEvent} event */
  function arrow(key, event) {
    const { selected } = sketch;
    const at = selected && model.vertexAt(sketch.drawing, selected);
    if (!selected || !at) return false;
    const step = gridSizeOf(sketch.snapping, sketch.stage.pixel) * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
    const [dx, dy] = /** @type {Record<string, Point>} */ ({ ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] })[key];
    const tidy = (/** @type {number} */ v) => Number(v.toPrecision(14));
    const moved = sketch.whole ? model.shiftPath(sketch.drawing, selected, dx, dy)
      : model.moveVertex(sketch.drawing, selected, [tidy(at[0] + dx), tidy(at[1] + dy)]);
    sketch.nudge(sketch.whole ? 'Move an outline' : 'Move a vertex', moved, `${selected.region} ${selected.loop} ${selected.vertex}`);
    return true;
  }

  /** @param {KeyboardEvent} event */
  function key(event) {
    const name = event.key.length === 1 ? event.key.toUpperCase() : event.key;
    if (event.ctrlKey || event.metaKey || (event.shiftKey && name.length === 1)) return false;
    if (name === 'N' || name === 'P') sketch.selectNext(name === 'N' ? 1 : -1);
    else if (name.startsWith('Arrow')) return arrow(name, event);
    else if (sketch.selected === null) return false;
    else if (name === 'Insert') insertAfter(sketch);
    else if (name === 'Delete' || name === 'Backspace') removeSelected(sketch);
    else if (name === 'Escape') sketch.select(null);
    else return false;
    return true;
  }

  return {
    id: 'edit', down, move, key, up: end,
    cancel: () => {
      if (drag && sketch.store.gesture === drag.gesture) sketch.store.undo();
      end();
    },
    draw: (context, view) => drawEditing(context, view, sketch),
  };
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
