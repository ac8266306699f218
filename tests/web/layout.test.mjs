// What is in the panels sits where it belongs: nothing lower than it must be, nothing broken, nothing out of sight.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { finished, startPlayground } from './support.mjs';

let playground;
before(async () => { playground = await startPlayground(); });
after(() => playground.close());

async function onPage(how, what) {
  const page = await playground.open(how);
  await finished(page);
  await what(page);
  assert.deepEqual(page.errors, []);
  await page.context().close();
}

for (const place of ['', 'space.html#preset=saddle&size=0.25'])
  test(`every tab begins at its top: ${place || 'plane'}`, () => onPage({ hash: place, width: 1280 }, async (page) => {
    for (const tab of await page.getByRole('tab').all()) {
      await tab.click();
      const gap = await page.locator('.tab-body:not([hidden])').evaluate((body) => {
        const words = document.createTreeWalker(body, NodeFilter.SHOW_ELEMENT);
        while (words.nextNode()) {
          const box = words.currentNode.getBoundingClientRect();
          if (box.height > 0 && words.currentNode.matches('h2, h3, p, button, legend, label, input')) return box.top - body.getBoundingClientRect().top;
        }
        return NaN;
      });
      assert.ok(gap <= 18, `${await tab.textContent()}: ${gap} px`);
    }
  }));

test('numbers of a vertex leave no room that others need, whatever is chosen', () => onPage({ width: 768, height: 1024 }, async (page) => {
  const gap = () => page.locator('.one-of').evaluate((element) => {
    const shown = [...element.children].find((group) => !group.classList.contains('away'));
    return element.getBoundingClientRect().bottom - shown.lastElementChild.getBoundingClientRect().bottom;
  });
  assert.ok(await gap() < 12, `${await gap()} px`);
  await page.click('[data-action="vertex.next"]');  // of the rectangle
  await page.locator('.one-of > [aria-label="Rectangle"]:not(.away)').waitFor();
  assert.ok(await gap() < 12);
}));

test('a comparison leaves the page as high as the screen', async () => {
  const page = await playground.open({ hash: '#preset=plate&comparison=lp', width: 720, height: 450 });
  await page.getByRole('tab', { name: 'Compare' }).click();
  await page.locator('.differences').waitFor();
  const [high, screen] = await page.evaluate(() => [document.documentElement.scrollHeight, innerHeight]);
  assert.ok(high <= screen, `${high} of ${screen} px`);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

test('a notice about a file with a long name stays within its frame', () => onPage({ hash: 'space.html#preset=saddle&size=0.25', width: 720, height: 450 }, async (page) => {
  await page.evaluate(() => globalThis.playground.notify(`Reading ${'housing_cover_'.repeat(8)}.step …`, () => {}));
  const [bar, ...parts] = await page.locator('.notice').evaluate((notice) =>
    [notice, ...notice.children].map((one) => one.getBoundingClientRect().toJSON()));
  for (const part of parts) assert.ok(part.right <= bar.right && part.bottom <= bar.bottom, JSON.stringify([bar, part]));
}));

test('L with a lower p is one word where meshes are compared', () => onPage({}, async (page) => {
  await page.getByRole('tab', { name: 'Compare' }).click();
  const gap = await page.locator('.comparisons label', { hasText: 'with L' }).evaluate((label) => {
    const sub = label.querySelector('sub'), before = document.createRange();
    before.selectNodeContents(sub.previousSibling);
    return sub.getBoundingClientRect().left - before.getBoundingClientRect().right;
  });
  assert.ok(Math.abs(gap) < 1, `${gap} px`);
}));

test('the ends of a ramp are never broken, and what is between them is level', async () => {
  const page = await playground.open({ hash: '#chapter=norm', width: 768, height: 1024 });
  await page.getByRole('tab', { name: 'Layers' }).click();
  await page.locator('.layers .ramp-ends', { hasText: '≥ 4' }).waitFor();
  const boxes = await page.locator('.layers .ramp-ends').evaluate((ends) => [...ends.children].map((one) => one.getBoundingClientRect().toJSON()));
  assert.equal(boxes.length, 3);
  for (const end of [boxes[0], boxes[2]]) assert.ok(end.height < 24, `${end.height} px`);
  assert.ok(Math.max(...boxes.map(({ top }) => top)) - Math.min(...boxes.map(({ top }) => top)) < 1);
  assert.deepEqual(page.errors, []);
  await page.context().close();
});

const screens = [[320, 740], [360, 740], [390, 844], [600, 800], [768, 1024], [844, 390], [640, 400], [900, 700], [1000, 700], [1024, 768], [1280, 800]];

for (const place of ['', 'space.html#preset=saddle&size=0.25'])
  test(`all tabs are in sight, in one row, whichever is open: ${place || 'plane'}`, () => onPage({ hash: place }, async (page) => {
    for (const [width, height] of screens) {
      await page.setViewportSize({ width, height });
      for (const tab of await page.getByRole('tab').all()) {
        await tab.click();
        const [shown, all, rows] = await page.locator('.tabs').evaluate((tabs) =>
          [tabs.clientWidth, tabs.scrollWidth, new Set([...tabs.children].map((one) => one.getBoundingClientRect().top)).size]);
        assert.ok(all <= shown && rows === 1, `${width} px, ${await tab.textContent()}: ${all} of ${shown} px in ${rows} rows`);
      }
    }
  }));

for (const touch of [false, true])
  test(`all tools are in sight and large enough to hit: ${touch ? 'fingers' : 'mouse'}`, () => onPage({ touch }, async (page) => {
    assert.equal(await page.evaluate(() => matchMedia('(pointer: coarse)').matches), touch);
    for (const [width, height] of screens) {
      await page.setViewportSize({ width, height });
      const [rail, ...boxes] = await page.locator('#tools').evaluate((tools) => [tools, ...tools.children].map((one) => one.getBoundingClientRect().toJSON()));
      for (const box of boxes) {
        assert.ok(box.left >= 0 && box.right <= width && box.bottom <= rail.bottom, `${width} px: ${JSON.stringify(box)}`);
        assert.ok(box.width >= 28 && box.height >= (touch ? 44 : 24), `${width} px: ${box.width} x ${box.height}`);
      }
    }
  }));

for (const width of [320, 768, 1440])
  test(`formulas are complete: ${width} px`, () => onPage({ width, height: 900 }, async (page) => {
    await page.getByRole('tab', { name: 'Learn' }).click();
    const chapters = page.locator('.chapters a');
    for (let k = 0; k < await chapters.count(); ++k) {
      await chapters.nth(k).click();
      const [wide, high] = await page.locator('.formula').evaluate((f) => [f.scrollWidth - f.clientWidth, f.scrollHeight - f.clientHeight]);
      assert.ok(wide <= 0 && high <= 0, `${await chapters.nth(k).textContent()}: ${wide} px too wide, ${high} px too high`);
    }
  }));

for (const [width, height] of [[320, 740], [360, 640], [360, 740], [390, 844], [740, 360], [844, 390]])
  test(`a phone shows domains to begin with at once, and what a tool says once it is in hand: ${width} x ${height}`, () => onPage({ width, height, touch: true }, async (page) => {
    const within = (place) => page.locator(place).first().evaluate((element) => {
      const box = element.getBoundingClientRect(), panel = element.closest('.tab-body').getBoundingClientRect();
      return box.height > 0 && box.top >= panel.top && box.bottom <= Math.min(panel.bottom, innerHeight) && box.left >= panel.left && box.right <= panel.right;
    });
    assert.ok(await within('.preset'), 'the first domain');
    const last = page.locator('.preset').last();
    await last.focus();  // and the others without going down
    assert.equal(await page.locator('#panel-domain').evaluate((panel) => panel.scrollTop), 0);
    await last.click();
    await page.waitForFunction(() => globalThis.playground.store.project.preset === 'lines');
    await page.click('#tools [data-action="tool.circle"]');
    await page.getByRole('heading', { name: 'Circle' }).waitFor();
    assert.ok(await within('.tool-section h2') && await within('.tool-section .hint'), 'what the tool says');
    await page.click('#tools [data-action="tool.edit"]');
    await page.getByRole('heading', { name: 'Edit' }).waitFor();
    assert.ok(await within('.preset'), 'the first domain again');
  }));

for (const place of ['', 'space.html#preset=saddle&size=0.25'])
  test(`the bar at the top is one row, with all of it in sight and large enough to hit: ${place || 'plane'}`, () => onPage({ hash: place, touch: true }, async (page) => {
    for (const [width, height] of screens) {
      await page.setViewportSize({ width, height });
      const [bar, ...boxes] = await page.locator('header').evaluate((header) =>
        [header, ...header.querySelectorAll('a, button')].map((one) => one.getBoundingClientRect().toJSON()));
      assert.equal(new Set(boxes.map(({ top }) => Math.round(top))).size, 1, `${width} px: rows`);
      for (const box of boxes) {
        assert.ok(box.left >= 0 && box.right <= width && box.bottom <= bar.bottom, `${width} px: ${JSON.stringify(box)}`);
        assert.ok(box.width >= 26 && box.height >= 44, `${width} px: ${box.width} x ${box.height}`);
      }
    }
  }));

for (const [width, height] of [[320, 740], [360, 640], [360, 740], [740, 360]])
  test(`a phone shows surfaces to begin with at once: ${width} x ${height}`, () => onPage({ hash: 'space.html#preset=saddle&size=0.25', width, height, touch: true }, async (page) => {
    const [top, bottom, left] = await page.locator('.space-presets button').first().evaluate((button) => {
      const box = button.getBoundingClientRect(), panel = button.closest('.tab-body').getBoundingClientRect();
      return [box.top - panel.top, panel.bottom - box.bottom, box.left - panel.left];
    });
    assert.ok(top >= 0 && bottom >= 0 && left >= 0, `${top} ${bottom} ${left}`);
  }));

test('on a phone a tool says at once what it is for, however far down the tab was', () => onPage({ width: 360, height: 740, touch: true }, async (page) => {
  const panel = page.locator('#panel-domain');
  await panel.evaluate((body) => body.scrollTo(0, body.scrollHeight));
  assert.ok(await panel.evaluate((body) => body.scrollTop) > 0);
  await page.click('#tools [data-action="tool.polygon"]');
  await page.getByRole('heading', { name: 'Outline by points' }).waitFor();
  assert.equal(await panel.evaluate((body) => body.scrollTop), 0);
}));

test('turning a phone takes no focus away', () => onPage({ width: 1280, height: 800 }, async (page) => {
  await page.focus('[data-action="preset.gear"]');
  for (const [width, height] of [[360, 740], [1280, 800]]) {
    await page.setViewportSize({ width, height });
    await page.waitForFunction((small) => (document.querySelector('.gallery').nextElementSibling !== null) === small, width < 400);
    assert.equal(await page.evaluate(() => document.activeElement.dataset.action), 'preset.gear');
  }
}));

test('the sign of a problem is beside its title', () => onPage({ hash: 'space.html#preset=saddle&size=0.25', width: 360, height: 740 }, async (page) => {
  await page.evaluate(() => globalThis.playground.store.change('Too small', { options: { size: 1e-9 } }));
  await page.locator('.error-bar:not([hidden])').waitFor();
  const [sign, title] = await page.locator('.error-bar .words').evaluate(({ children: [a, b] }) => [a, b].map((one) => one.getBoundingClientRect().toJSON()));
  assert.ok(sign.right <= title.left + 1 && Math.abs(sign.top - title.top) < 8, JSON.stringify([sign, title]));
}));

test('where the browser chooses the colours, what is on is told from what is not', () => onPage({ hash: '#preset=square' }, async (page) => {
  await page.emulateMedia({ forcedColors: 'active' });
  await finished(page);
  const differ = (on, off) => page.evaluate(([on, off]) => {
    const [a, b] = [on, off].map((selector) => getComputedStyle(document.querySelector(selector)));
    return a.backgroundColor !== b.backgroundColor && a.backgroundColor !== a.color;
  }, [on, off]);
  assert.ok(await differ('#tools button[aria-pressed="true"]', '#tools button[aria-pressed="false"]'), 'tools');
  assert.ok(await differ('.tabs button[aria-selected="true"]', '.tabs button[aria-selected="false"]'), 'tabs');
  assert.ok(await differ('a.place[aria-current]', 'a.place:not([aria-current])'), 'places');
  await page.getByRole('tab', { name: 'Layers' }).click();
  assert.ok(await differ('.layer button[aria-pressed="true"]', '.layer button[aria-pressed="false"]'), 'layers');
  await page.getByRole('tab', { name: 'Mesh' }).click();
  assert.ok(await differ('.choices input:checked + span', '.choices input:not(:checked) + span'), 'choices');
}));

test('whoever stops a run is told so, and not alarmed', () => onPage({ hash: '#preset=square' }, async (page) => {
  await page.evaluate(() => globalThis.playground.store.change('Many', { options: { quads: 60000 } }));
  await page.waitForFunction(() => globalThis.playground.runner.run.project?.options.quads === 60000);
  await page.evaluate(() => globalThis.playground.actions.run('run.cancel'));
  const bar = page.locator('.error-bar', { hasText: 'You stopped this run.' });
  await bar.waitFor();
  assert.equal(await bar.locator('.words .icon').isVisible(), false);
  assert.equal(await bar.getAttribute('aria-label'), 'What to do');
  await bar.getByRole('button', { name: 'Run again' }).waitFor();
}));

test('what the run says is not cut off', () => onPage({ hash: '#preset=square' }, async (page) => {
  await finished(page);
  await page.evaluate(() => globalThis.playground.actions.run('sketch.empty'));
  const name = page.locator('.stage-name', { hasText: 'no mesh' });
  for (const width of [360, 800, 1280, 1440]) {
    await page.setViewportSize({ width, height: 800 });
    await name.waitFor();
    const [inside, outside] = await name.evaluate((one) => [[one.scrollWidth, one.scrollHeight], [one.clientWidth + 1, one.clientHeight + 1]]);
    assert.ok(inside.every((size, i) => size <= outside[i]), `${width} px: ${inside} in ${outside}`);
  }
}));

test('what snaps stands in line with its fields', () => onPage({ hash: '#preset=square' }, async (page) => {
  const bottoms = await page.locator('.snap-section').evaluate((section) =>
    [...section.querySelectorAll('button, input, select')].map((one) => one.getBoundingClientRect().bottom));
  assert.ok(bottoms.length > 4 && Math.max(...bottoms) - Math.min(...bottoms) < 1, String(bottoms));
}));

for (const place of ['#preset=square', 'space.html#preset=saddle&size=0.25'])
  test(`on a phone the bar for the run takes two rows, with all of it large enough to hit: ${place}`, () => onPage({ hash: place, touch: true, width: 360, height: 740 }, async (page) => {
    for (const width of [320, 360, 390]) {
      await page.setViewportSize({ width, height: 740 });
      const [bar, ...boxes] = await page.locator('#timeline').evaluate((element) =>
        [element, ...element.querySelectorAll('button, select, input, progress')].map((one) => one.getBoundingClientRect().toJSON()));
      assert.ok(bar.height <= 2 * 44 + 20, `${width} px: ${bar.height} px high`);
      for (const box of boxes) assert.ok(box.left >= 0 && box.right <= width && box.width >= 28, `${width} px: ${JSON.stringify(box)}`);
      const name = await page.locator('.stage-name').boundingBox();
      assert.ok(name.width >= 110 && name.x + name.width <= width, `${width} px: ${JSON.stringify(name)}`);
    }
  }));
