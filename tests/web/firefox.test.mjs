// A smoke test in Firefox: the page starts, meshes, plays, takes keys and pointers, and exports.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createLpquad } from '../../dist/node.js';
import { presets } from '../../web/sketch/presets.js';
import { toCall } from '../../web/state/project.js';
import { browsers } from '../package/browsers.mjs';
import { serve } from '../package/server.mjs';
import { openFirefox } from './marionette.mjs';
import { folder } from './support.mjs';

const skip = browsers.firefox.path ? false : 'SKIPPED: firefox is not installed';
let server, firefox;
before(async () => {
  if (skip) return;
  server = await serve({ web: { folder } });
  firefox = await openFirefox();
});
after(async () => {
  await firefox?.end();
  server?.close();
});

const done = 'window.playground?.runner.run.phase === "done"';

test('Firefox meshes, steps, edits, undoes and exports as Chromium does', { skip }, async () => {
  const project = presets[0].project;
  await firefox.go(`${server.origin}/web/#preset=plate`);
  await firefox.evaluate('window.faults = []; addEventListener("error", (e) => faults.push(e.message)); addEventListener("unhandledrejection", (e) => faults.push(String(e.reason)));');
  await firefox.until(done);
  const { domain, options } = toCall(project);
  const { hash } = (await createLpquad()).meshDomain(domain, options).report;
  assert.equal(await firefox.evaluate('return playground.runner.run.result.report.hash'), hash);

  await firefox.press(',');
  await firefox.until('playground.runner.run.phase === "paused"');
  await firefox.press('e');
  await firefox.until(done);

  const from = await firefox.evaluate(`
    const { view } = playground.stage, { left, top } = document.getElementById('overlay-canvas').getBoundingClientRect();
    const [x, y] = playground.store.project.drawing.regions[0].loops[0][2];
    return [Math.round(left + (x - view.left) * view.scale), Math.round(top + (view.top - y) * view.scale)];`);
  await firefox.drag(from, [from[0] - 10, from[1] + 20], [from[0] - 40, from[1] + 40]);
  await firefox.until('playground.store.canUndo && playground.store.gesture === ""');
  await firefox.until(`${done} && playground.runner.run.result.report.hash !== "${hash}"`);
  await firefox.click('[data-action="edit.undo"]');
  await firefox.until(`${done} && playground.runner.run.result.report.hash === "${hash}"`);

  for (const tab of await firefox.evaluate('return [...document.querySelectorAll("[role=tab]")].map((tab) => tab.id)')) {
    await firefox.click(`#${tab}`);
    assert.equal(await firefox.evaluate('return document.querySelector("[role=tab][aria-selected=true]").id'), tab);
  }
  await firefox.click('#tab-files');
  await firefox.evaluate('HTMLAnchorElement.prototype.click = function () { window.saved = this.download; }');
  await firefox.click('[data-format="msh"]');
  await firefox.until('window.saved === "plate.msh"');
  assert.ok(await firefox.evaluate(`
    const { width, height } = document.getElementById('mesh-canvas');
    return new Set(document.getElementById('mesh-canvas').getContext('2d').getImageData(0, 0, width, height).data).size > 10;`), 'something is drawn');
  assert.deepEqual(await firefox.evaluate('return faults'), []);
});
