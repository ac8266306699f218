// The same small meshes by every way a consumer has, and the fingerprints sent to the test server.
const loop = [[0, 0], [2, 0], [2, 1], [1.2, 1], [1.1, 0.7], [0.9, 0.7], [0.8, 1], [0, 1]];
export const domain = { loops: [loop] };
export const options = { size: 0.1 };
const file = JSON.stringify(domain);
// Four sides of a box of 1 x 1 x 2, open at the bottom and lid.
export const surfaceFile = `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 2\nv 1 0 2\nv 1 1 2\nv 0 1 2
f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n`;
export const surfaceOptions = { size: 0.25 };

export async function fingerprints(ways) {
  const found = {};
  for (const [name, make] of Object.entries(ways)) {
    const lpquad = await make();
    const mesh = await lpquad.meshDomain(domain, options);
    const read = await lpquad.readDomain(file, { name: 'outline.json' });
    const again = await lpquad.meshDomain(read, options);
    found[name] = `${mesh.report.hash} ${again.report.hash}`;
    if (name !== 'inline') {  // which has no surfaces inside
      const surface = await lpquad.readSurface(surfaceFile, { name: 'part.obj' });
      found[name] += ` ${(await lpquad.meshSurface(surface, surfaceOptions)).report.hash}`;
    }
    lpquad.terminate?.();
  }
  return found;
}

/** In a browser: what the page found, or what went wrong, to the address in its query. */
export async function report(ways) {
  const send = (result) =>
    fetch(new URLSearchParams(location.search).get('to'), { method: 'POST', body: JSON.stringify(result) });
  addEventListener('error', (event) => send({ error: String(event.message) }));
  addEventListener('securitypolicyviolation', (event) => send({ error: `CSP: ${event.violatedDirective}` }));
  try {
    send({ found: await fingerprints(ways) });
  } catch (error) {
    send({ error: `${error.stack ?? error}` });
  }
}
