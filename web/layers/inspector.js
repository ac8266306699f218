// What an element is, for whoever points at it: a card beside the pointer, or pinned by a click, a
// tap or a key; the arrow keys walk from neighbour to neighbour.
/** @import { App } from '../app' */
/** @import { Element } from '../draw/hit.js' */
/** @import { Point, Scene, View } from '../types' */
import { describe } from '../draw/describe.js';
import { centred, cornersOfFace, elementAt, faceAt, neighbourOf, rowsOfKind } from '../draw/hit.js';
import { toScreen, toWorld } from '../draw/view.js';
import { h } from '../panels/dom.js';
import { icon } from '../panels/icons.js';

/** @type {Record<string, [number, number]>} */
const directions = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class Inspector {
  /** @type {Element | null} */
  #element = null;
  /** Where the element is that was last found; a pin waits there while no layer shows anything. @type {Point | null} */
  #at = null;
  #pinned = false;
  /** @type {Point | null} */
  #pointer = null;  // in pixels

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.body = h('div', { className: 'card-body' });
    const shut = () => this.show(null);
    this.close = h('button', { type: 'button', 'aria-label': 'Close', title: 'Close (I)', onclick: shut },
      icon('close'));
    this.card = h('div', { className: 'inspection', hidden: true, role: 'group', 'aria-label': 'Element' },
      this.body, this.close);
    app.stage.element.append(this.card);
    app.stage.overlays.push((pen, view) => this.draw(pen, view));
  }

  get pinned() { return this.#pinned; }

  /** @param {Element | null} element  @param {boolean} [pinned] */
  show(element, pinned = false) {
    if (element === null && this.#at === null) return;
    const before = this.#pinned;
    this.#element = element;
    this.#at = element && element.at;
    this.#pinned = element !== null && pinned;
    this.#fill();
    this.app.stage.invalidate('overlay');
    if (this.#pinned !== before) this.app.actions.refresh();
    if (this.#pinned) this.app.announce(this.body.textContent ?? '');
  }

  /** @param {Point} pixels */
  hover(pixels) {
    this.#pointer = pixels;
    if (!this.#pinned) this.show(this.#find(pixels));
  }

  leave() {
    if (!this.#pinned) this.show(null);
  }

  /** A click: pins what is there, or lets go. @param {Point} pixels */
  pin(pixels) {
    const found = this.#find(pixels), now = this.#element;
    const same = this.#pinned && found && now && found.kind === now.kind && found.index === now.index;
    this.show(same ? null : found, true);
  }

  /** What is in the middle of the view, or nothing more. */
  toggle() {
    if (this.#pinned && this.#element) return this.show(null);
    const { view } = this.app.stage, scene = this.app.scene();
    const places = spiral(view);
    const found = firstOf(places, (at) => faceAt(scene, at))
      ?? firstOf(places, (at) => elementAt(scene, at, 1 / view.scale));
    if (!found) return this.app.announce('There is no element in view');
    this.show(centred(scene, found), true);
    this.app.stage.overlay.focus();  // so that the arrow keys come here
  }

  /** @param {string} key  @returns whether the key was for this */
  walk(key) {
    const direction = directions[key];
    if (!direction || !this.#pinned || !this.#element) return false;
    const scene = this.app.scene(), next = neighbourOf(scene, this.#element, ...direction);
    if (next) {
      this.show(next, true);
      this.#reveal(next.at);
    } else this.app.announce('No neighbour there');
    return true;
  }

  /** The frame or the layers changed: what is at the same place now? */
  refresh() {
    if (this.#at === null) return;
    const scene = this.app.scene(), kind = this.#element?.kind ?? 'place';
    const small = kind === 'vertex' || kind === 'edge' || kind === 'singularity';
    this.#element = (small ? null : faceAt(scene, this.#at)) ?? elementAt(scene, this.#at, this.app.stage.pixel);
    this.#at = this.#element?.at ?? (this.#pinned ? this.#at : null);
    this.#fill();
    this.app.stage.invalidate('overlay');
  }

  /** @param {Point} pixels */
  #find(pixels) {
    const { view } = this.app.stage;
    return elementAt(this.app.scene(), toWorld(view, ...pixels), 1 / view.scale);
  }

  #fill() {
    const description = this.#element && describe(this.app.scene(), this.#element);
    this.card.hidden = !description;
    this.close.hidden = !this.#pinned;
    this.card.classList.toggle('pinned', this.#pinned);
    if (!description) return;
    this.body.replaceChildren(h('strong', null, `${description.title} `),
      h('dl', null, ...description.rows.flatMap(([name, value]) =>
        [h('dt', null, `${name} `), h('dd', null, `${value} `)])));
    this.#place();
  }

  /** Beside the element or the pointer, on the side where there is room. */
  #place() {
    const { view } = this.app.stage, element = this.#element;
    if (!element || this.card.hidden) return;
    const [x, y] = this.#pinned || !this.#pointer ? toScreen(view, ...element.at) : this.#pointer;
    const { offsetWidth, offsetHeight } = this.card;
    const left = x + 18 + offsetWidth < view.width ? x + 18 : x - 18 - offsetWidth;
    const top = y + 18 + offsetHeight < view.height ? y + 18 : y - 18 - offsetHeight;
    this.card.style.left = `${Math.max(4, Math.min(view.width - offsetWidth - 4, left))}px`;
    this.card.style.top = `${Math.max(4, Math.min(view.height - offsetHeight - 4, top))}px`;
  }

  /** Brings a point of the world into view. @param {Point} at */
  #reveal(at) {
    const { stage } = this.app, { view } = stage, [x, y] = toScreen(view, ...at);
    if (x > 20 && y > 20 && x < view.width - 20 && y < view.height - 20) return;
    stage.look({ ...view, left: at[0] - view.width / 2 / view.scale, top: at[1] + view.height / 2 / view.scale });
  }

  /** @param {CanvasRenderingContext2D} pen  @param {View} view */
  draw(pen, view) {
    if (this.#element === null || this.card.hidden) return;
    const scene = this.app.scene();
    this.#place();
    pen.save();
    pen.lineJoin = 'round';
    for (const rim of [true, false]) {
      pen.lineWidth = rim ? 6 : 3;
      pen.strokeStyle = rim ? scene.palette.background : scene.palette.accent;
      for (const outline of outlinesOf(scene, this.#element)) {
        trace(pen, view, outline);
        pen.stroke();
      }
    }
    pen.restore();
  }
}

/**
 * What is drawn round an element: polygons, or one point.
 * @param {Scene} scene  @param {Element} element  @returns {Point[][]}
 */
function outlinesOf(scene, element) {
  const { kind, index, at } = element;
  if (kind === 'edge') {
    const loop = scene.drawing.regions[element.region].loops[element.loop];
    return [[loop[index], loop[(index + 1) % loop.length]]];
  }
  if (kind === 'vertex' || kind === 'singularity' || kind === 'place') return [[at]];
  const rows = rowsOfKind(scene, kind);
  if (!rows) return [];
  const mates = kind === 'pair' || kind === 'triangle' ? scene.frame?.matching?.mates : undefined;
  const mate = mates?.length === rows.offsets.length - 1 ? mates[index] : -1;
  return [...mate >= 0 ? [cornersOfFace(rows, mate)] : [], cornersOfFace(rows, index)];
}

/** @param {CanvasRenderingContext2D} pen  @param {View} view  @param {Point[]} outline */
function trace(pen, view, outline) {
  pen.beginPath();
  if (outline.length === 1) pen.arc(...toScreen(view, ...outline[0]), 9, 0, 2 * Math.PI);
  else outline.forEach((point, i) => pen[i === 0 ? 'moveTo' : 'lineTo'](...toScreen(view, ...point)));
  if (outline.length > 2) pen.closePath();
}

/** @template T @param {Point[]} places  @param {(at: Point) => T | null} look */
function firstOf(places, look) {
  for (const at of places) {
    const found = look(at);
    if (found) return found;
  }
  return null;
}

/** Points of the view from the middle outwards, in the world. @param {View} view @returns {Point[]} */
function spiral(view) {
  return Array.from({ length: 400 }, (_, i) => {
    const away = 0.5 * Math.hypot(view.width, view.height) * Math.sqrt(i / 400), angle = 2.4 * i;
    return toWorld(view, view.width / 2 + away * Math.cos(angle), view.height / 2 + away * Math.sin(angle));
  });
}

/** @param {App} app */
export function installInspector(app) {
  const { actions, stage, store, runner } = app;
  const inspector = new Inspector(app);
  actions.add({ id: 'view.inspect', label: 'Inspect an element (arrow keys: its neighbours)', keys: ['I'], icon: 'eye',
    pressed: () => inspector.pinned, run: () => inspector.toggle() });
  const looks = () => stage.tool.inspects ?? ['none', 'edit'].includes(stage.tool.id);
  const place = (/** @type {PointerEvent} */ event) => /** @type {Point} */ ([event.offsetX, event.offsetY]);
  stage.overlay.addEventListener('pointermove', (event) => {
    if (event.pointerType === 'touch') return;
    if (event.buttons === 0 && looks()) inspector.hover(place(event));
    else inspector.leave();
  });
  stage.overlay.addEventListener('pointerleave', () => inspector.leave());
  stage.tapped = (pixels) => { if (looks()) inspector.pin(pixels); };
  addEventListener('keydown', (event) => {
    const free = event.target === document.body || event.target === stage.overlay;
    if (!free || event.ctrlKey || event.metaKey || event.altKey || event.shiftKey || !inspector.walk(event.key)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }, { capture: true });
  const refresh = () => inspector.refresh();
  store.subscribe(refresh);
  runner.subscribe(refresh);
}
