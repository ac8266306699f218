// Surfaces in space have a page of their own: files that hold one are taken there.
/** @import { App } from '../app' */
import { createEngine } from '../run/engine.js';
import { handOver } from './hand_over.js';

const always = /\.(stl|off|ply|step|stp|iges|igs|brep|brp)$/i, perhaps = /\.(obj|msh)$/i, mostBytes = 2 ** 28;

/** @param {File} file */
async function isSurface(file) {
  if (always.test(file.name)) return true;
  if (!perhaps.test(file.name)) return false;
  const engine = await createEngine();
  try {
    return await engine.isSurfaceFile(new Uint8Array(await file.arrayBuffer()), { name: file.name });
  } finally {
    engine.terminate();
  }
}

/** @param {App} app */
export function installOpeningSurfaces({ announce, openers }) {
  openers.push(async ([file]) => {
    if (file === undefined || file.size > mostBytes || !await isSurface(file)) return false;
    announce(`${file.name} is a surface in space`);
    await handOver(file, './space.html');
    return true;
  });
}
