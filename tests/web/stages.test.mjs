// The --stages folder of a native run, stepped through in the page.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, unlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { createLpquad } from '../../dist/node.js';
import { presets } from '../../web/sketch/presets.js';
import { BadStages } from '../../web/stages/parse.js';
import { isStagesFolder, readStages, RecordedSession } from '../../web/stages/recording.js';
import { startPlayground } from './support.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const native = join(root, 'build/release/bin/lpquad');
const folder = mkdtempSync(join(tmpdir(), 'lpquad-stages-'));
after(() => rmSync(folder, { recursive: true, force: true }));

const { drawing } = presets[0].project;
const [command, ...first] = existsSync(native) ? [native] : [process.execPath, join(root, 'dist/cli.js')];
function produce(name, options, flags) {
  writeFileSync(join(folder, 'domain.json'), JSON.stringify({ loops: drawing.regions[0].loops }));
  execFileSync(command, [...first, 'mesh', 'domain.json', '-o', 'mesh.msh', '--quiet', '--stages', name, '--report', `${name}.report.json`, ...flags], { cwd: folder });
  const read = (file) => readFileSync(join(folder, name, file), 'utf8');
  const names = readdirSync(join(folder, name));
  const binary = names.includes('iterates.bin') ? readFileSync(join(folder, name, 'iterates.bin')) : undefined;
  return { options, names, files: new Map(names.filter((file) => /\.(json|obj)$/.test(file)).map((file) => [file, read(file)])), bytes: binary && Uint8Array.from(binary).buffer };
}
const paper = produce('paper', { size: 0.15, method: 'paper', seeds: 'isotropic' }, ['--size', '0.15', '--method', 'paper', '--seeds', 'isotropic']);
const best = produce('best', { size: 0.06 }, ['--size', '0.06']);  // the first of its meshes is kept
const other = produce('other', { size: 0.15 }, ['--size', '0.15']);  // one of another size is

const close = (a, b, what, tolerance = 1e-9) => {
  assert.equal(a.length, b.length, what);
  a.forEach((value, k) => assert.ok(Math.abs(value - b[k]) <= tolerance * (1 + Math.abs(b[k])), `${what}[${k}]: ${value}, ${b[k]}`));
};
const layers = { triangles: true, cells: true, crosses: true, sizes: true, matching: true, quads: true };

/** A session of the library at the first state of a stage, or after all iterations. */
function at(session, stage) {
  session.restore(0);
  while (session.state.stage !== stage && session.state.stage !== 'done') session.step();
  return session.snapshot(layers);
}

test('what a folder holds is what the library shows of the same run', async () => {
  const lpquad = await createLpquad();
  for (const { files, bytes, options } of [paper, best]) {
    const recorded = new RecordedSession(readStages(files, bytes));
    const session = lpquad.start({ loops: drawing.regions[0].loops }, options);
    for (let tick = 0; recorded.state.stage !== 'done'; tick = recorded.state.tick + 1) {
      const { stage } = await recorded.restore(tick);
      if (stage === 'seeds' || stage === 'optimise') continue;  // judged by the next test
      const [ours, theirs] = [await recorded.snapshot(layers), at(session, stage)];
      for (const [layer, fields] of Object.entries({ crosses: ['points', 'axes', 'singularities', 'indices'], sizes: ['points', 'triangles', 'sizes'],
        ...(stage === 'match' && { triangles: ['points', 'triangles'], cells: ['points', 'offsets', 'sites', 'density'] }),
        ...(stage === 'clean' && { matching: ['points', 'triangles', 'mates', 'extra', 'costs'] }),
        ...(['clean', 'done'].includes(stage) && { quads: ['points', 'quads', 'triangles', 'eta', 'valence', 'excess'] }) }))
        for (const field of fields) close([...ours[layer][field]], [...theirs[layer][field]], `${stage} ${layer}.${field}`);
      assert.equal(ours.triangles?.boundaryNodes ?? theirs.triangles?.boundaryNodes, theirs.triangles?.boundaryNodes);
      if (stage === 'match') close([ours.tau], [theirs.tau], 'tau', 1e-6);
    }
    const result = await recorded.finish(), wanted = session.finish();
    close([...result.points.toSorted()], [...wanted.points.toSorted()], 'points');  // in another order
    assert.deepEqual(result.report.quality.valenceHistogram, wanted.report.quality.valenceHistogram);
    close([result.report.quality.etaMean, result.report.quality.etaMin], [wanted.report.quality.etaMean, wanted.report.quality.etaMin], 'eta');
    session.dispose();
  }
});

test('a folder tells how the mesh that is kept was made', async () => {
  const lpquad = await createLpquad();
  const recorded = new RecordedSession(readStages(other.files, other.bytes));
  const session = lpquad.start({ loops: drawing.regions[0].loops }, other.options);
  const first = at(session, 'match').triangles.points.length, kept = at(session, 'done');
  assert.notEqual(first, kept.triangles.points.length);
  for (let tick = 0; recorded.state.stage !== 'done'; tick = recorded.state.tick + 1) {
    const { stage } = await recorded.restore(tick);
    const ours = await recorded.snapshot(layers);
    if (stage === 'match') for (const field of ['points', 'triangles']) close([...ours.triangles[field]], [...kept.triangles[field]], field);
    if (stage === 'clean') for (const field of ['points', 'mates', 'costs']) close([...ours.matching[field]], [...kept.matching[field]], field);
    if (stage === 'done') for (const field of ['points', 'quads']) close([...ours.quads[field]], [...kept.quads[field]], field);
  }
  session.dispose();
});

test('every iteration is there, bit for bit', async () => {
  const lpquad = await createLpquad();
  const recorded = new RecordedSession(readStages(paper.files, paper.bytes));
  const session = lpquad.start({ loops: drawing.regions[0].loops }, paper.options);
  session.step();
  await recorded.restore(1);
  for (let iteration = 0; session.state.stage === 'optimise'; ++iteration) {
    const [ours, theirs] = [await recorded.snapshot(layers), session.snapshot(layers)];
    assert.equal(ours.tick, theirs.tick);
    for (const field of ['stage', 'iteration', 'energy', 'gradientNorm', 'maxIterations']) assert.equal(ours[field], theirs[field], `${field} of iteration ${iteration}`);
    close([ours.tau], [theirs.tau], 'tau', 1e-6);
    assert.deepEqual(ours.triangles.points, theirs.triangles.points);
    if (iteration > 0) {
      assert.deepEqual(ours.triangles.triangles, theirs.triangles.triangles);
      assert.deepEqual({ ...ours.cells, energy: 0 }, { ...theirs.cells, energy: 0 });
    }
    session.step();
    await recorded.step();
  }
  assert.equal(recorded.state.stage, 'match');
  assert.ok(recorded.state.iteration > 20);
  session.dispose();
});

test('missing and damaged files are named', () => {
  const without = (name) => new Map([...paper.files].filter(([file]) => file !== name));
  const changed = (name, text) => new Map([...paper.files, [name, text]]);
  assert.throws(() => readStages(without('cells.json')), (error) => error instanceof BadStages && /lacks cells\.json/.test(error.message));
  assert.throws(() => readStages(new Map()), /lacks background\.json.*quads-1/);
  for (const [name, text] of [['energy.json', '{"p":6'], ['energy.json', '{"p":6}'], ['triangles.json', '{"points":[[0,0]],"triangles":[[0,1,2]]}'],
    ['crosses.json', '[]'], ['start.obj', 'v 0 x 0'], ['quads-1-matched.obj', 'v 0 0 0\nf 1 2 3 4'], ['cells.json', '{"cells":[]}'], ['matching.json', 'null']])
    assert.throws(() => readStages(changed(name, text)), (error) => error instanceof BadStages && error.message.includes(name), name);
  for (const length of [0, 8, paper.bytes.byteLength - 8])
    assert.throws(() => readStages(paper.files, paper.bytes.slice(0, length)), (error) => error instanceof BadStages && /iterates\.bin is shorter/.test(error.message));
  const damaged = (at, value) => {
    const bytes = paper.bytes.slice(0);
    new DataView(bytes).setFloat64(at < 0 ? bytes.byteLength + at : at, value, true);
    return bytes;
  };
  assert.throws(() => readStages(paper.files, damaged(0, NaN)), /no finite number/);
  assert.throws(() => readStages(paper.files, damaged(-16, NaN)), /names something that is not there/);
  assert.throws(() => readStages(changed('iterates.json', '{"boundaryNodes":4,"iterates":[{"iteration":1,"points":9}]}'), paper.bytes), /without “pieces”/);
  assert.ok(readStages(paper.files).steps.length < 10);  // a folder of before
  assert.ok(isStagesFolder(paper.names));
  assert.ok(!isStagesFolder(['plate.json', 'notes.txt', 'energy.json']));
});

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

test('the folder opens as a run with the same timeline and layers', async () => {
  const page = await playground.open();
  await page.locator('input[aria-label="Folder of stages"]').setInputFiles(join(folder, 'paper'));
  await page.locator('#project-name', { hasText: 'paper' }).waitFor();
  await page.waitForFunction(() => globalThis.playground.runner.run.phase === 'done');
  const { steps, result } = readStages(paper.files, paper.bytes);
  await page.locator('.stage-name', { hasText: `done: ${result.quads.length / 4} quads` }).waitFor();
  const history = await page.evaluate(() => globalThis.playground.runner.run.history.map(({ iteration, energy }) => [iteration, energy]));
  for (const { state: { tick, iteration, energy } } of steps.slice(1, -3)) assert.deepEqual(history[tick], [iteration, energy]);
  for (let tick = steps.length - 2; tick >= 0; --tick) {
    await page.keyboard.press(',');
    await page.waitForFunction((at) => globalThis.playground.runner.run.frame?.tick === at, tick);
    assert.equal(await page.evaluate(() => globalThis.playground.runner.run.state.stage), steps[tick].state.stage);
  }
  const shown = (tick) => page.evaluate(async (at) => {
    await globalThis.playground.runner.seek(at);
    const { frame } = globalThis.playground.runner.run;
    return { iteration: frame.iteration, points: [...frame.triangles.points], corners: [...frame.cells.points] };
  }, tick);
  await page.evaluate(() => globalThis.playground.store.change('Layers', { layers: ['triangles', 'cells'] }));
  for (const tick of [12, 7, 30]) {
    const { iteration, points, corners } = await shown(tick);
    assert.equal(iteration, tick - 1);
    assert.deepEqual(points, [...steps[tick].shown.triangles.points]);
    assert.deepEqual(corners, [...steps[tick].shown.cells.points]);
  }
  await page.keyboard.press('Control+z');
  await page.keyboard.press('e');
  await page.waitForFunction(() => globalThis.playground.runner.run.phase === 'done');
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => globalThis.playground.store.project.preset === 'plate');
  await page.keyboard.press('Control+y');
  await page.waitForFunction((hash) => globalThis.playground.runner.run.result?.report.chain === hash, 'recorded');
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('an incomplete folder is refused in words', async () => {
  unlinkSync(join(folder, 'best', 'matching.json'));
  const page = await playground.open();
  await page.locator('input[aria-label="Folder of stages"]').setInputFiles(join(folder, 'best'));
  await page.locator('.notice', { hasText: 'lacks matching.json' }).waitFor();
  assert.deepEqual(page.errors, []);
  await page.context().close();
});
