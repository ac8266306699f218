// What is on the page outlives it, as on the page for the plane: the address bar follows a preset, the browser's
// storage keeps either for the next visit; the triangles of a file go to its database.
/** @import { SpaceApp, Work } from '../types' */
/** @import { Surface } from 'lpquad' */
import { answer, openStore } from '../../state/database.js';
import { whenRested } from '../../state/rest.js';
import { keep, kept } from '../../state/storage.js';
import { faultOf, fromFragment, problemOf, toFragment } from './link.js';
import { workOf } from './work.js';

const stored = 'surface';

/** @typedef {{work: Work, notice: string}} Opened */

/** What the page shows first: what its address says, else what was there last. @returns {Promise<Opened>} */
export async function openFirst() {
  if (location.hash.length > 1 && problemOf(location.hash) === '') return { work: fromFragment(location.hash), notice: '' };
  const last = await lastWork();
  return { ...last, notice: problemOf(location.hash) || last.notice };
}

/** @returns {Promise<Opened>} */
async function lastWork() {
  const text = kept(stored) ?? '';
  if (!text.startsWith('{')) return { work: fromFragment(problemOf(text) === '' ? text : ''), notice: '' };
  try {
    const { id, name, options, layers } = JSON.parse(text);
    const surface = await keptSurface(id);
    if (surface !== null)
      return { work: { name, preset: undefined, surface, options: faultOf(options) ? workOf(name, surface).options : options, layers }, notice: '' };
    return { work: fromFragment(''), notice: `${name} was here last, and this browser did not keep it. Open it again.` };
  } catch {
    return { work: fromFragment(''), notice: '' };  // of an older page, or damaged: as on the first visit
  }
}

const database = () => openStore('lpquad-space', 'surfaces');

/** @param {string} id  @returns {Promise<Surface | null>} */
async function keptSurface(id) {
  const last = await answer((await database()).get('last'));
  return last?.id === id ? last.surface : null;
}

/** Resolves when it is safe. @param {string} id  @param {Surface} surface  @returns {Promise<void>} */
async function keepSurface(id, surface) {
  const store = await database();
  return new Promise((resolve, reject) => {
    store.put({ id, surface }, 'last');
    store.transaction.oncomplete = () => resolve();
    store.transaction.onabort = store.transaction.onerror = () => reject(store.transaction.error);
  });
}

/** @param {Pick<SpaceApp, 'store' | 'notify'>} app */
export function installKeeping({ store, notify }) {
  /** @type {WeakMap<Surface, string>} */
  const ids = new WeakMap();
  let last = store.project.preset === undefined ? store.project.surface : null;
  if (last !== null) ids.set(last, JSON.parse(kept(stored) ?? '{}').id);

  const save = () => {
    const { name, preset, surface, options, layers } = store.project;
    keep(stored, preset !== undefined ? toFragment(store.project) : JSON.stringify({ id: ids.get(surface), name, options, layers }));
  };
  const keepFile = () => {
    const { name, preset, surface } = store.project;
    if (preset !== undefined || surface === last) return;
    last = surface;
    const id = ids.get(surface) ?? crypto.getRandomValues(new Uint32Array(2)).join('-');
    ids.set(surface, id);
    keepSurface(id, surface).catch(() => notify(`This browser does not keep ${name}: when you leave the page it has to be opened again.`));
  };
  const soon = whenRested(() => {
    save();
    history.replaceState(null, '', toFragment(store.project) || location.pathname + location.search);
  });
  store.subscribe(() => {
    keepFile();
    soon();
  });
  addEventListener('pagehide', save);
  document.addEventListener('visibilitychange', () => { if (document.hidden) save(); });
}
