// A monkey at the page: fifty projects to begin with, seeded random edits, pointers, keys, options, layers, seeks, undo and
// redo, faster than the mesher follows. Whatever it does: no error, nothing lost by undo, and no mesh
// shown as current that is not the drawing's. LPQ_MONKEY says how many actions, LPQ_SEED which.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createLpquad } from '../../dist/node.js';
import { readProject } from '../../web/state/project_file.js';
import { toFragment } from '../../web/state/link.js';
import { toCall } from '../../web/state/project.js';
import { createDice } from './dice.mjs';
import { startProjects } from './starts.mjs';
import { startPlayground } from './support.mjs';

const count = Number(process.env.LPQ_MONKEY ?? 150), seed = Number(process.env.LPQ_SEED ?? 1);
const rest = 40;  // actions between two waits for the mesher
const projects = startProjects(seed);
let opened = 0;  // of these, one after the other

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

/** In the page: what must hold at every moment; '' if it does. */
const broken = () => {
  const { store, runner, scene } = globalThis.playground;
  const decides = ['drawing', 'options', 'sizes', 'guides', 'seedPoints'];
  const same = (a, b) => a !== null && decides.every((key) => a[key] === b[key]);
  const { project } = store, { run } = runner, { frame, result, freshness } = scene();
  if (frame !== null && freshness === 'current' && !same(run.frameOf, project)) return 'an old picture is shown as current';
  if (result !== null && !same(run.project, project)) return 'an old result is shown';
  if (run.phase === 'done' && run.result === null) return 'done without a result';
  if (store.gesture !== '') return '';
  for (const [there, back, can] of [['undo', 'redo', 'canUndo'], ['redo', 'undo', 'canRedo']])
    if (store[can]) {
      store[there]();
      store[back]();
      if (store.project !== project) return `${there} and ${back} do not come back`;
    }
  return '';
};

/** What the monkey can do. Each is told the page and the dice. */
const tricks = {
  project: (page) => page.evaluate((project) => globalThis.playground.store.change('Project', project), projects[opened++ % projects.length]),
  option: (page, dice) => page.evaluate((options) => globalThis.playground.store.change('Options', ({ options: before }) => ({ options: { ...before, ...options } })),
    dice.pick([{ norm: dice.pick([2, 4, 6]) }, { iterations: dice.below(30) }, { method: dice.pick(['best', 'paper']) }, { seeds: dice.pick(['aligned', 'isotropic', 'automatic']) },
      { keepBoundary: dice.random() < 0.3 }, { smoothing: dice.below(40) }, { seed: dice.below(9) }])),
  vertex: (page, dice) => page.evaluate(([where, dx, dy, steps]) => {
    const { store } = globalThis.playground;
    const all = store.project.drawing.regions.flatMap(({ loops }, r) => loops.flatMap((loop, l) => loop.map((_, v) => [r, l, v])));
    if (all.length === 0) return;
    const [r, l, v] = all[Math.floor(where * all.length)];
    for (let k = 0; k < steps; ++k)
      store.change('Move', ({ drawing }) => ({ drawing: { ...drawing, regions: drawing.regions.map((region, i) => (i !== r ? region : { ...region, loops: region.loops.map((loop, j) =>
        (j !== l ? loop : loop.map(([x, y], m) => (m === v ? [x + dx / steps, y + dy / steps] : [x, y])))) })) } }), 'monkey');
    store.settle();
  }, [dice.random(), (dice.random() - 0.5) * 0.2, (dice.random() - 0.5) * 0.2, 1 + dice.below(4)]),
  layers: (page, dice) => page.evaluate((layers) => globalThis.playground.store.change('Layers', { layers }),
    dice.pick(['auto', ['boundary'], ['cells', 'density'], ['quads', 'quality', 'valence'], ['triangles', 'crosses'], ['sizes', 'matching'], []])),
  action: (page, dice) => page.evaluate((at) => {
    const { actions } = globalThis.playground;
    const ids = actions.all.map(({ id }) => id).filter((id) => !/^(file|page)\./.test(id));
    actions.run(ids[Math.floor(at * ids.length)]);
  }, dice.random()),
  seek: (page, dice) => page.evaluate((at) => {
    const { runner } = globalThis.playground;
    void runner.seek(Math.floor(at * (runner.run.history.at(-1)?.tick ?? 0)));
  }, dice.random()),
  travel: (page, dice) => page.evaluate(([way, times]) => { for (let k = 0; k < times; ++k) globalThis.playground.store[way](); }, [dice.pick(['undo', 'redo']), 1 + dice.below(6)]),
  key: (page, dice) => page.keyboard.press(dice.pick(['Space', ',', '.', 'e', 'Shift+E', 'Escape', 'Control+z', 'Control+y', 'Tab', 'Delete', 'Enter', 'ArrowUp', 'n', ']', 'r', '0'])),
  async pointer(page, dice) {
    const { x, y, width, height } = await page.locator('#overlay-canvas').boundingBox();
    const place = () => [x + dice.random() * width, y + dice.random() * height];
    await page.mouse.move(...place());
    await page.mouse.down();
    await page.mouse.move(...place(), { steps: 1 + dice.below(4) });
    await page.mouse.up();
  },
  wheel: (page, dice) => page.mouse.wheel(0, (dice.random() - 0.5) * 600),
  wait: (page, dice) => page.waitForTimeout(dice.below(120)),
};

/** Until nothing is under way any more. */
const calm = async (page) => {
  await page.evaluate(() => {
    globalThis.playground.store.settle();
    if (globalThis.playground.runner.going) void globalThis.playground.runner.end();
  });
  await page.waitForFunction(() => {
    const { store, runner } = globalThis.playground;
    return !runner.busy && store.gesture === '' && (runner.run.project === store.project || runner.run.phase !== 'playing');
  }, null, { timeout: 180000 });
};

test('fifty different projects to begin with, and each has a mesh', async () => {
  const lpquad = await createLpquad();
  assert.equal(new Set(projects.map((project) => JSON.stringify(toCall(project)))).size, 50);
  for (const project of projects) {
    const { domain, options } = toCall(project);
    assert.equal(lpquad.meshDomain(domain, options).report.triangles, 0, project.name || project.preset);
  }
});

test(`${count} actions with seed ${seed}`, { timeout: 3_600_000 }, async (t) => {
  const dice = createDice(seed), lpquad = await createLpquad(), done = [];
  const page = await playground.open({ hash: await toFragment(dice.pick(projects)), offline: false });
  page.on('dialog', (dialog) => dialog.dismiss());
  await calm(page);
  let compared = 0;
  for (let k = 0; k < count; ++k) {
    const trick = dice.pick(Object.keys(tricks));
    done.push(trick);
    await tricks[trick](page, dice);
    const fault = await page.evaluate(broken);
    assert.equal(fault, '', `after ${done.slice(-12).join(', ')} (action ${k + 1})`);
    assert.deepEqual(page.errors, [], `after ${done.slice(-12).join(', ')} (action ${k + 1})`);
    if ((k + 1) % rest !== 0 && k + 1 < count) continue;
    await calm(page);
    compared += await compare(page, lpquad);
  }
  t.diagnostic(`${Math.min(opened, projects.length)} of ${projects.length} projects, ${compared} meshes compared with those of Node`);
  await page.context().close();
});

/** The finished mesh on the screen is that of the project, made anew elsewhere. */
async function compare(page, lpquad) {
  const shown = await page.evaluate(() => {
    const { store, runner: { run }, scene } = globalThis.playground;
    const exact = (value) => JSON.stringify(value, (_, member) => (Object.is(member, -0) ? '-0' : member)).replaceAll('"-0"', '-0');
    return run.phase === 'done' && scene().freshness === 'current' ? { text: exact({ lpquadProject: 1, ...store.project }), hash: run.result.report.hash } : null;
  });
  if (shown === null) return 0;
  const { domain, options } = toCall(readProject(shown.text));
  assert.equal(shown.hash, lpquad.meshDomain(domain, options).report.hash, 'the mesh on the screen is the project\'s');
  return 1;
}
