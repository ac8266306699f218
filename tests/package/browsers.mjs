// Starts real browsers without a window. Pages answer by posting to the server (server.mjs), so that
// every browser works that can be started with an address.
import { spawn } from 'node:child_process';
import { accessSync, constants, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { delimiter, join } from 'node:path';

function find(...names) {
  for (const folder of (process.env.PATH ?? '').split(delimiter))
    for (const name of names) {
      try {
        accessSync(join(folder, name), constants.X_OK);
        return join(folder, name);
      } catch { /* look on */ }
    }
  return null;
}

const quietFirefox = ['app.update.enabled', 'browser.shell.checkDefaultBrowser', 'datareporting.policy.dataSubmissionEnabled',
  'browser.aboutwelcome.enabled', 'network.captive-portal-service.enabled', 'network.connectivity-service.enabled',
  'browser.safebrowsing.malware.enabled', 'browser.safebrowsing.phishing.enabled', 'extensions.getAddons.cache.enabled'];

export const browsers = {
  chromium: {
    path: find('chromium', 'chromium-browser', 'google-chrome'),
    args: (profile, url) => ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
      '--disable-background-networking', '--disable-component-update', '--disable-sync',
      '--disable-dev-shm-usage', '--password-store=basic', `--user-data-dir=${profile}`,
      // A window that nobody sees is not slowed down.
      '--disable-background-timer-throttling', '--disable-renderer-backgrounding', '--remote-debugging-port=0', url],
  },
  firefox: {
    path: find('firefox-esr', 'firefox'),
    prepare: (profile) => writeFileSync(join(profile, 'user.js'),
      quietFirefox.map((name) => `user_pref("${name}", false);\n`).join('')),
    args: (profile, url) => ['--headless', '--no-remote', '--profile', profile, url],
  },
};

/** @returns {() => void}  ends the browser and removes its profile */
export function openBrowser(name, url, folder) {
  const { path, args, prepare } = browsers[name];
  const profile = join(folder, `profile-${name}-${process.pid}`);
  mkdirSync(profile, { recursive: true });
  prepare?.(profile);
  // A process group of its own: browsers are many processes.
  const child = spawn(path, args(profile, url), { stdio: 'ignore', detached: true,
    env: { ...process.env, HOME: profile, MOZ_CRASHREPORTER_DISABLE: '1' } });
  child.on('error', (error) => console.error(`${name}: ${error.message}`));
  const end = () => {
    try { process.kill(-child.pid, 'SIGKILL'); } catch { /* it is gone */ }
    try { rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 }); } catch { /* still closing */ }
  };
  process.once('exit', end);
  return end;
}
