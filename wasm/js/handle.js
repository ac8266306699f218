// What a session owns inside the module, until it is disposed of.
import { checkNames } from './checks.js';
import { disposed, unwrap } from './errors.js';

export class Handle {
  #native;

  constructor(native) { this.#native = native; }

  /** @returns {any} */
  get live() {
    if (this.#native === null) throw disposed();
    return this.#native;
  }

  /** The state with those of the known layers that are wanted. */
  snapshot(layers, known) {
    checkNames(layers, known, 'layer');
    const snapshot = this.live.state();
    for (const name of known)
      if (layers[name]) snapshot[name] = unwrap(this.live[name]());
    return snapshot;
  }

  dispose() {
    this.#native?.delete();
    this.#native = null;
  }
}
