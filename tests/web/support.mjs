// The built playground on a server of its own, and a browser to try it as a person does.
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { browsers } from '../package/browsers.mjs';
import { serve } from '../package/server.mjs';

export const folder = process.env.LPQ_WEB ?? fileURLToPath(new URL('../../build/web', import.meta.url));
const quiet = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--disable-dev-shm-usage'];

/** For what a slow machine does late: a test says that something happens, not when. */
export const patience = 120000;

/** One server and one Chromium for a test file; `open` gives a page of its own storage. */
export async function startPlayground() {
  const server = await serve({ web: { folder } });
  const browser = await chromium.launch({ executablePath: browsers.chromium.path, args: quiet });
  return {
    address: `${server.origin}/web/`,
    browser,
    /** @param {{hash?: string, width?: number, height?: number, dark?: boolean, still?: boolean, touch?: boolean, offline?: boolean,
     *   watch?: (app: any) => void}} [how]  `watch` runs in the page, as soon as its parts are together */
    async open({ hash = '', width = 1280, height = 800, dark = false, still = true, touch = false, offline = false, watch } = {}) {
      const context = await browser.newContext({ viewport: { width, height }, colorScheme: dark ? 'dark' : 'light',
        reducedMotion: still ? 'reduce' : 'no-preference', hasTouch: touch, acceptDownloads: true,
        serviceWorkers: offline ? 'allow' : 'block' });
      context.setDefaultTimeout(patience);
      const page = await context.newPage();
      page.errors = [];
      page.on('pageerror', (error) => page.errors.push(error.message));
      page.on('console', (message) => { if (message.type() === 'error') page.errors.push(message.text()); });
      if (watch)
        await page.addInitScript(`{ let app; Object.defineProperty(globalThis, 'playground',
          { get: () => app, set: (value) => { app = value; (${watch})(app); } }); }`);
      await page.goto(`${server.origin}/web/${hash}`);
      await page.waitForFunction(() => globalThis.playground !== undefined);  // the page has loaded before its parts are together
      return page;
    },
    async close() {
      await browser.close();
      server.close();
    },
  };
}

/** Waits for the mesh of what is on the screen. */
export const finished = (page) => page.locator('.stage-name', { hasText: /^done/ }).waitFor();
