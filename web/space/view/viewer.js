// The view into space: camera, light and named parts; drawn when something changed, not all the time.
/** @import { Object3D } from 'three' */
import {
  AmbientLight, ColorManagement, DirectionalLight, LinearSRGBColorSpace, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { h } from '../../panels/dom.js';

ColorManagement.enabled = false;  // colours are shown as the palette has them

const turn = Math.PI / 24, zoomStep = 1.15, tapReach = 4;

/** null without WebGL. @param {HTMLCanvasElement} canvas */
function rendererFor(canvas) {
  if (!document.createElement('canvas').getContext('webgl2')) return null;
  const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
  renderer.outputColorSpace = LinearSRGBColorSpace;
  renderer.setPixelRatio(Math.min(2, devicePixelRatio));
  return renderer;
}

export class Viewer {
  /** @type {Map<string, Object3D>} */
  #parts = new Map();
  #scheduled = false;
  #box = { middle: [0, 0, 0], radius: 1 };
  /** Nobody has moved the camera since all was looked at: then all stays in view when the view becomes narrower. */
  #fitted = false;
  /** A triangle of the part `pickable` is pointed at; -1: none. @type {(triangle: number) => void} */
  pointed = () => {};
  /** The part whose triangles can be pointed at. */
  pickable = 'target';

  /** @param {HTMLElement} element  holds the canvas */
  constructor(element) {
    this.element = element;
    this.canvas = /** @type {HTMLCanvasElement} */ (element.querySelector('canvas'));
    this.renderer = rendererFor(this.canvas);
    if (this.renderer === null) this.#excuse();
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(35, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.#light();
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener('change', () => this.invalidate());
    this.controls.addEventListener('start', () => { this.#fitted = false; });
    this.#listen();
    this.#watchContext();
    new ResizeObserver(() => this.#resize()).observe(element);
  }

  /** There is nothing to see in space; all else works. */
  #excuse() {
    this.canvas.hidden = true;
    this.#instead('This browser has no WebGL, so the surface cannot be shown in space. '
      + 'It is meshed all the same: charts, figures and files are there.');
  }

  /** @param {string} words  where the picture would be */
  #instead(words) {
    const line = h('p', { className: 'instead', role: 'status' }, words);
    this.element.append(line);
    return line;
  }

  /** The graphics card may drop the picture: after a sleep, or where many pages want it. The browser mostly gives it back. */
  #watchContext() {
    let line = /** @type {HTMLElement | null} */ (null);
    this.canvas.addEventListener('webglcontextlost', () => {
      line ??= this.#instead('The browser has taken the picture away from this page, and may give it back. '
        + 'If it does not, load the page again.');
    });
    this.canvas.addEventListener('webglcontextrestored', () => {
      line?.remove();
      line = null;
      this.invalidate();
    });
  }

  /** A headlight from the upper left, and enough of everything else. */
  #light() {
    const lamp = new DirectionalLight(0xffffff, 1.9);
    lamp.position.set(-0.4, 0.6, 1);
    this.camera.add(lamp);
    this.scene.add(new AmbientLight(0xffffff, 1.5), this.camera);
  }

  #listen() {
    let began = { x: 0, y: 0 };
    this.canvas.addEventListener('pointerdown', ({ clientX: x, clientY: y }) => { began = { x, y }; });
    this.canvas.addEventListener('pointermove', (event) => { if (event.buttons === 0) this.pointed(this.#triangleAt(event)); });
    this.canvas.addEventListener('pointerleave', () => this.pointed(-1));
    this.canvas.addEventListener('pointerup', (event) => {  // a tap points too
      if (Math.hypot(event.clientX - began.x, event.clientY - began.y) < tapReach) this.pointed(this.#triangleAt(event));
    });
    this.canvas.addEventListener('keydown', (event) => this.#key(event));
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const turns = { ArrowLeft: [turn, 0], ArrowRight: [-turn, 0], ArrowUp: [0, turn], ArrowDown: [0, -turn] }[event.key];
    if (turns !== undefined) this.turn(turns[0], turns[1]);
    else if (event.key === '+' || event.key === '=') this.zoom(1 / zoomStep);
    else if (event.key === '-') this.zoom(zoomStep);
    else return;
    event.preventDefault();
  }

  /** Turns the camera about what it looks at. @param {number} right  @param {number} up  in radians */
  turn(right, up) {
    const from = this.camera.position.clone().sub(this.controls.target);
    const flat = Math.hypot(from.x, from.y), far = from.length();
    const azimuth = Math.atan2(from.y, from.x) + right;
    const height = Math.max(-1.55, Math.min(1.55, Math.atan2(from.z, flat) + up));
    from.set(Math.cos(height) * Math.cos(azimuth), Math.cos(height) * Math.sin(azimuth), Math.sin(height)).multiplyScalar(far);
    this.#moveTo(this.controls.target.clone().add(from));
  }

  /** @param {number} factor  more than 1 goes away */
  zoom(factor) {
    const { target } = this.controls;
    this.#moveTo(this.camera.position.clone().sub(target).multiplyScalar(factor).add(target));
  }

  /** @param {Vector3} place */
  #moveTo(place) {
    this.#fitted = false;
    this.camera.position.copy(place);
    this.controls.update();
    this.invalidate();
  }

  /** Looks at all of it. @param {{middle: number[], radius: number}} [box]  of another surface */
  fit(box = this.#box) {
    this.#box = box;
    const { width, height } = this.element.getBoundingClientRect();
    const narrow = Math.min(1, width / Math.max(1, height));
    const far = 1.05 * box.radius / Math.sin(this.camera.fov * Math.PI / 360) / (narrow || 1);
    this.controls.target.fromArray(box.middle);
    this.camera.near = 0.01 * box.radius;
    this.camera.far = 4 * far + 4 * box.radius;
    this.camera.updateProjectionMatrix();
    this.#moveTo(new Vector3(-0.75, -1, 0.75).normalize().multiplyScalar(far).add(this.controls.target));
    this.#fitted = true;
  }

  /** Shows something by name, instead of what had the name. @param {string} name  @param {Object3D | null} object */
  show(name, object) {
    const old = this.#parts.get(name);
    if (old !== undefined) {
      this.scene.remove(old);
      old.traverse((/** @type {any} */ { geometry, material }) => { geometry?.dispose(); material?.map?.dispose(); material?.dispose(); });
    }
    if (object === null) this.#parts.delete(name);
    else this.scene.add(object), this.#parts.set(name, object);
    this.invalidate();
  }

  /** @param {PointerEvent} event */
  #triangleAt(event) {
    const object = this.#parts.get(this.pickable);
    if (object === undefined) return -1;
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const at = new Vector2(2 * (event.clientX - left) / width - 1, 1 - 2 * (event.clientY - top) / height);
    const ray = new Raycaster();
    ray.setFromCamera(at, this.camera);
    return ray.intersectObject(object, true)[0]?.faceIndex ?? -1;
  }

  #resize() {
    const { width, height } = this.element.getBoundingClientRect();
    if (width === 0 || height === 0) return;
    this.renderer?.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.#fitted) this.fit();
    this.#paint();  // at once: a canvas that changed its size is empty
  }

  invalidate() {
    if (this.#scheduled) return;
    this.#scheduled = true;
    requestAnimationFrame(() => this.#paint());
  }

  #paint() {
    this.#scheduled = false;
    this.renderer?.render(this.scene, this.camera);
  }
}
