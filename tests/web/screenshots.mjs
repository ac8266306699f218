// Pictures of the page to look at: every preset at 360, 768 and 1440 px, dark and light, and every
// tab once. Needs build/web.
// usage: node tests/web/screenshots.mjs FOLDER [TEXT]   (TEXT: only pictures whose name contains it)
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { presets } from '../../web/sketch/presets.js';
import { presets as surfaces } from '../../web/space/presets/presets.js';
import { startPlayground } from './support.mjs';

const [folder, only = ''] = process.argv.slice(2);
if (!folder) {
  console.error('usage: node tests/web/screenshots.mjs FOLDER [TEXT]');
  process.exit(2);
}
mkdirSync(folder, { recursive: true });
const playground = await startPlayground();
const widths = { 360: 740, 768: 1024, 1440: 900 };

async function shoot(name, how, prepare = async () => {}) {
  if (!name.includes(only)) return;
  const page = await playground.open(how);
  await page.waitForFunction(() => ['done', 'failed'].includes(globalThis.playground?.runner.run.phase), null, { timeout: 180000 });
  await prepare(page);
  await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
  await page.screenshot({ path: join(folder, `${name}.png`) });
  const wrong = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth || document.documentElement.scrollHeight > innerHeight);
  if (wrong || page.errors.length > 0) console.log(`${name}: ${wrong ? 'overflows ' : ''}${page.errors.join(' ')}`);
  await page.context().close();
}

for (const { id } of presets)
  for (const [width, height] of Object.entries(widths))
    for (const dark of [false, true])
      await shoot(`preset-${id}-${width}-${dark ? 'dark' : 'light'}`, { hash: `#preset=${id}`, width: Number(width), height, dark });
for (const { id } of surfaces)
  for (const [width, height] of Object.entries(widths))
    for (const dark of [false, true])
      await shoot(`space-${id}-${width}-${dark ? 'dark' : 'light'}`, { hash: `space.html#preset=${id}`, width: Number(width), height, dark });
const titles = ['domain', 'mesh', 'layers', 'figures', 'compare', 'files', 'learn'];
for (const [width, height] of [...Object.entries(widths), ['3840', 2160]])
  for (const dark of [false, true])
    for (const id of titles)
      await shoot(`tab-${id}-${width}-${dark ? 'dark' : 'light'}`, { width: Number(width), height, dark }, async (page) => {
        const tab = page.locator(`#tab-${id}`);
        if (await tab.count() > 0) await tab.click();
      });
await playground.close();
