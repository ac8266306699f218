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
  return { options, names, files: new Map(names.filter((file) => /\.(json|obj)$/.test(file)).map((file) => [file, read(file)])) };
}
const paper = produce('paper', { size: 0.15, method: 'paper', seeds: 'isotropic' }, ['--size', '0.15', '--method', 'paper', '--seeds', 'isotropic']);
const best = produce('best', { size: 0.15 }, ['--size', '0.15']);

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
  for (const { files, options } of [paper, best]) {
    const recorded = new RecordedSession(readStages(files));
    const session = lpquad.start({ loops: drawing.regions[0].loops }, options);
    for (let tick = 0; recorded.state.stage !== 'done'; tick = recorded.state.tick + 1) {
      const { stage } = await recorded.restore(tick);
      if (stage === 'seeds' || stage === 'optimise') continue;  // judged by what follows
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

test('missing and damaged files are named', () => {
  const without = (name) => new Map([...paper.files].filter(([file]) => file !== name));
  const changed = (name, text) => new Map([...paper.files, [name, text]]);
  assert.throws(() => readStages(without('cells.json')), (error) => error instanceof BadStages && /lacks cells\.json/.test(error.message));
  assert.throws(() => readStages(new Map()), /lacks background\.json.*quads-1/);
  for (const [name, text] of [['energy.json', '{"p":6'], ['energy.json', '{"p":6}'], ['triangles.json', '{"points":[[0,0]],"triangles":[[0,1,2]]}'],
    ['crosses.json', '[]'], ['start.obj', 'v 0 x 0'], ['quads-1-matched.obj', 'v 0 0 0\nf 1 2 3 4'], ['cells.json', '{"cells":[]}'], ['matching.json', 'null']])
    assert.throws(() => readStages(changed(name, text)), (error) => error instanceof BadStages && error.message.includes(name), name);
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
  const { steps, result } = readStages(paper.files);
  await page.locator('.stage-name', { hasText: `done: ${result.quads.length / 4} quads` }).waitFor();
  for (let tick = steps.length - 2; tick >= 0; --tick) {
    await page.keyboard.press(',');
    await page.waitForFunction((at) => globalThis.playground.runner.run.frame?.tick === at, tick);
    assert.equal(await page.evaluate(() => globalThis.playground.runner.run.state.stage), steps[tick].state.stage);
  }
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
