// Surfaces in space have a page of their own: files that hold one are taken there.
/** @import { App } from '../app' */
import { handOver } from './hand_over.js';
import { besideThePage } from './reading.js';

const always = /\.(stl|off|ply|step|stp|iges|igs|brep|brp)$/i, perhaps = /\.(obj|msh)$/i, mostBytes = 2 ** 28;

/** @param {File} file  @param {AbortSignal} signal */
async function isSurface(file, signal) {
  if (always.test(file.name)) return true;
  if (!perhaps.test(file.name)) return false;
  return besideThePage(signal, async (engine) => engine.isSurfaceFile(new Uint8Array(await file.arrayBuffer()), { name: file.name }));
}

/** @param {App} app */
export function installOpeningSurfaces({ announce, openers }) {
  openers.push(async ([file], signal) => {
    if (file === undefined || file.size > mostBytes || !await isSurface(file, signal)) return false;
    announce(`${file.name} is a surface in space`);
    await handOver(file, './space.html', signal);
    return true;
  });
}
