// Never run: what must compile, and what must not. Checked by tsc, strict, for Node and bundlers.
import { createLpquad, LpquadError } from 'lpquad';
import type {
  Domain, ErrorCode, Lpquad, Mesh, MeshFormat, MeshOptions, MeshResult, Snapshot, Surface, SurfaceMeshResult, SurfaceSession,
} from 'lpquad';
import { isCadFile, readCad, surfaceAsObj } from 'lpquad/cad';
import type { CadSurface } from 'lpquad/cad';
import { createLpquad as createInline } from 'lpquad/inline';
import { createLpquad as createInlineSurface } from 'lpquad/inline-surface';
import { createLpquadWorker } from 'lpquad/worker';

declare const bytes: ArrayBuffer;
declare const compiled: object;

export async function direct(): Promise<void> {
  const lpquad: Lpquad = await createLpquad();
  await createLpquad({ wasmUrl: '/lpquad.wasm' });
  await createLpquad({ wasmUrl: new URL('https://example.org/lpquad.wasm'), readersUrl: '/readers.wasm' });
  await createLpquad({ wasmBinary: bytes });
  await createLpquad({ wasmModule: compiled });
  // @ts-expect-error no such source
  await createLpquad({ wasmURL: '/lpquad.wasm' });

  const domain: Domain = {
    loops: [[[0, 0], [1, 0], [1, 1]], [0.1, 0.1, 0.2, 0.1, 0.2, 0.2], Float64Array.of(0, 0)],
    tags: [['inlet', null, undefined]],
    polylines: [{ points: [[0, 0], [1, 1]], tag: 'crack' }],
    points: [[0.5, 0.5], { position: [0.1, 0.2], tag: 'sensor' }],
    h: 0.1, sizes: [[0.5, 0.5, 0.01]], guides: [[[0, 0], [1, 1]], Float64Array.of(0, 0, 1, 1)], seedPoints: [[0.5, 0.5]],
  };
  const regions: Domain = { regions: [{ name: 'steel', loops: [[0, 0, 1, 0, 1, 1]] }] };
  const mesh: MeshResult = lpquad.meshDomain(domain, {
    size: 0.1, keepBoundary: true, elements: 'quad-dominant', method: 'paper', seeds: 'aligned', norm: 4,
    iterations: 10, restarts: 2, seed: 3, sizes: [[0.5, 0.5, 0.01]], guides: [[0, 0, 1, 1]], sizeAt: (x: number, y: number) => x + y,
    angleAt: () => 0, onProgress: ({ stage, iteration, energy }) => stage !== 'clean' && iteration + energy < 9,
  });
  lpquad.meshDomain(regions);
  // @ts-expect-error no loops
  lpquad.meshDomain({ h: 1 });
  // Arrays whose lengths are not known: of a variable, of JSON.
  const outline = [[0, 0], [1, 0], [1, 1]], spots = [[0.5, 0.5, 0.1]];
  const parsed: { loops: number[][][] } = JSON.parse('{ "loops": [] }');
  const frozen: readonly (readonly number[])[] = outline;
  lpquad.meshDomain({ loops: [outline, frozen], points: outline, polylines: [{ points: outline }], sizes: spots, guides: [outline] },
    { sizes: spots, guides: [frozen], seedPoints: outline });
  lpquad.meshDomain({ regions: [parsed, { loops: [outline] }], points: [{ position: outline[0]! }] });
  // @ts-expect-error coordinates are numbers
  lpquad.meshDomain({ loops: [[['0', '0'], ['1', '0'], ['1', '1']]] });
  // @ts-expect-error a point is an array
  lpquad.meshDomain({ loops: [[{ x: 0, y: 0 }, { x: 1, y: 0 }, { x: 1, y: 1 }]] });
  // @ts-expect-error no such option
  lpquad.meshDomain(domain, { siz: 0.1 });
  // @ts-expect-error no such choice
  lpquad.meshDomain(domain, { method: 'fast' });
  // @ts-expect-error sizes are numbers
  lpquad.meshDomain(domain, { size: '0.1' });

  const points: Float64Array = mesh.points;
  const quads: Uint32Array = mesh.quads;
  const regionOfQuad: string | undefined = mesh.regions[mesh.quadRegions[0]!];
  const numbers: number[] = [mesh.report.quality.etaMin, mesh.report.options.size, points.length, quads.length];
  const format: MeshFormat = 'msh';
  const text: string = lpquad.writeMesh(mesh, format, { mshVersion: '2.2' }) + regionOfQuad + numbers.join();
  // @ts-expect-error no such format
  lpquad.writeMesh(mesh, 'stl');
  const part: Mesh = mesh;
  lpquad.writeMesh(part, 'inp', { inpElement: 'S4' });
  lpquad.meshDomain(await lpquad.readDomain(text, { format: 'svg' }));
  lpquad.meshDomain(await lpquad.readDomain(bytes, { name: 'plan.dxf' }), lpquadOptions(lpquad));

  const session = lpquad.start(domain, { size: 0.1, memory: false });
  // @ts-expect-error a session has no onProgress
  lpquad.start(domain, { onProgress: () => true });
  const snapshot: Snapshot = session.snapshot({ triangles: true, cells: true });
  // @ts-expect-error the layer may not have been asked for
  snapshot.cells.points.length;
  const energy: number | undefined = snapshot.cells?.energy;
  session.step(3);
  session.restore(energy ?? 0).stage satisfies string;
  session.clone().finish().quads satisfies Uint32Array;
  session.dispose();
  session[Symbol.dispose]();
  // @ts-expect-error the state is read only
  session.state = session.step();
}

function lpquadOptions(lpquad: Lpquad): MeshOptions {
  return Object.fromEntries(lpquad.options.map((option) => [option.name, option.default]));
}

export async function surfaces(lpquad: Lpquad): Promise<void> {
  await createLpquad({ surfaceUrl: '/lpquad-surface.wasm' });
  const surface: Surface = await lpquad.readSurface(bytes, { name: 'part.stl' });
  await lpquad.readSurface('', { format: 'off' });
  // @ts-expect-error no such format
  await lpquad.readSurface('', { format: 'step' });
  const mesh: SurfaceMeshResult = await lpquad.meshSurface(surface, {
    size: 1, featureAngle: 30, keepGroups: false, turn: 20, growth: 0.2, weld: 1e-7, effort: 'high', method: 'paper', norm: 4, iterations: 20,
    onProgress: ({ stage, chart, chartCount }) => stage !== 'seams' && chart <= chartCount,
  });
  await lpquad.meshSurface({ points: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles: [0, 1, 2], groups: [0], sizes: [1, 1, 0], groupNames: ['a'] });
  const corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triples = [[0, 1, 2]];
  await lpquad.meshSurface({ points: corners, triangles: triples });
  // @ts-expect-error coordinates are numbers
  await lpquad.meshSurface({ points: [['0', '0', '0']], triangles: [0, 1, 2] });
  // @ts-expect-error no such option of surfaces
  await lpquad.meshSurface(surface, { keepBoundary: true });
  // @ts-expect-error a promise
  lpquad.meshSurface(surface).quads;
  const { where, hash }: { where: Int32Array; hash: string } = { where: mesh.placeTriangles, hash: mesh.report.hash };
  lpquad.writeMesh(mesh, 'inp') satisfies string;
  // @ts-expect-error a picture is plane
  lpquad.writeMesh(mesh, 'svg');
  const more: number = mesh.surface.groups.length + (surface.groups?.length ?? 0) + where.length + hash.length;
  const session: SurfaceSession = await lpquad.startSurface(surface, { size: more });
  // @ts-expect-error the layer may not have been asked for
  session.snapshot({ charts: true }).charts.uv;
  session.snapshot({ crosses: true }).crosses?.axes satisfies Float64Array | undefined;
  session.step(2).stage satisfies 'features' | 'field' | 'charts' | 'mesh' | 'seams' | 'shape' | 'done';
  // @ts-expect-error forwards only
  session.restore(1);
  session[Symbol.dispose]();

  const remote = createLpquadWorker();
  const controller = new AbortController();
  const far: SurfaceMeshResult = await remote.meshSurface(await remote.readSurface(bytes), { size: 1 },
    { signal: controller.signal, onProgress: (progress) => progress.chart });
  await remote.writeMesh(far, 'vtu');
  const run = await remote.startSurface(surface);
  for await (const snapshot of run.run({ layers: { quads: true } })) snapshot.quads?.eta satisfies Float64Array | undefined;
  await run.dispose();
}

export async function worker(): Promise<void> {
  const remote = createLpquadWorker();
  createLpquadWorker({ wasmUrl: '/lpquad.wasm', worker: () => ({}) });
  const controller = new AbortController();
  const mesh: MeshResult = await remote.meshDomain({ loops: [[0, 0, 1, 0, 1, 1]] }, { size: 0.1 },
    { signal: controller.signal, onProgress: (progress) => progress.tick });
  // @ts-expect-error functions do not cross
  await remote.meshDomain({ loops: [] }, { sizeAt: () => 1 });
  // @ts-expect-error of sessions only
  await remote.meshDomain({ loops: [] }, { memory: false });
  await remote.start({ loops: [] }, { memory: false }, { onProgress: ({ tick }) => tick < 9 });
  // @ts-expect-error a promise
  remote.writeMesh(mesh, 'obj').length;
  const session = await remote.start({ loops: [[0, 0, 1, 0, 1, 1]] });
  for await (const snapshot of session.run({ every: 2, layers: { triangles: true }, signal: controller.signal }))
    snapshot.tick satisfies number;
  await session.dispose();
  await session[Symbol.asyncDispose]();
  (await remote.ready()).version satisfies string;
  remote.terminate();
}

export function explain(error: unknown): string {
  if (!(error instanceof LpquadError)) return '';
  const code: ErrorCode | 'BAD_WASM' | 'WORKER_LOST' = error.code;
  // @ts-expect-error no such code
  if (code === 'OOPS') return '';
  return `${code} ${error.message} ${error.where.loop ?? ''} ${error.where.x ?? ''}`;
}

export const inline: Promise<Lpquad>[] = [createInline(), createInlineSurface()];

export async function cad(factory: () => Promise<import('lpquad/cad').OcctInstance>): Promise<number> {
  const part: CadSurface = await readCad(bytes, { name: 'part.step', size: 2, unit: 'inch', occt: factory });
  // @ts-expect-error no such format
  await readCad(bytes, { format: 'stl' });
  return isCadFile('part.igs') ? part.triangles.length + part.groupNames.length : surfaceAsObj(part).length;
}

/** Whatever the version of TypeScript: results can be sent and kept, and what was received or shared can be given back. */
export async function buffers(lpquad: Lpquad, surface: Surface, shared: Float64Array): Promise<void> {
  const mesh = lpquad.meshDomain({ loops: [shared, Float32Array.of(0, 0), [0, 0, 1, 0, 1, 1]] }, { sizes: shared });
  // @ts-expect-error no list
  lpquad.meshDomain({ loops: [{ length: 6, 0: 0, 1: 0, 2: 1, 3: 0, 4: 1, 5: 1 }] });
  const { placeWeights } = await lpquad.meshSurface({ ...surface, sizes: shared });
  const transferred: ArrayBuffer[] = [mesh.points.buffer, mesh.quads.buffer, mesh.edgeTags.buffer, surface.points.buffer, placeWeights.buffer];
  new Blob([mesh.points, mesh.quads, placeWeights]);
  structuredClone(mesh, { transfer: transferred });
  lpquad.writeMesh({ ...mesh, points: shared }, 'obj');
  surfaceAsObj({ ...surface, points: shared, groups: Int32Array.of(0) });
}
