// Drives Firefox by Marionette, the protocol it brings along: lines of JSON, each after its length.
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { browsers } from '../package/browsers.mjs';

const elementKey = 'element-6066-11e4-a52e-4f735466cecf';
const wait = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** The other end of the connection. */
class Line {
  #socket;
  #bytes = Buffer.alloc(0);
  #waiting = new Map();
  #next = 1;

  constructor(socket) {
    this.#socket = socket;
    socket.on('data', (data) => this.#take(data));
    socket.on('close', () => { for (const { reject } of this.#waiting.values()) reject(new Error('Firefox is gone.')); });
  }

  #take(data) {
    this.#bytes = Buffer.concat([this.#bytes, data]);
    for (;;) {
      const colon = this.#bytes.indexOf(58);
      const length = Number(this.#bytes.subarray(0, colon));
      if (colon < 0 || this.#bytes.length < colon + 1 + length) return;
      const message = JSON.parse(this.#bytes.subarray(colon + 1, colon + 1 + length));
      this.#bytes = this.#bytes.subarray(colon + 1 + length);
      if (!Array.isArray(message)) continue;  // the greeting
      const [, id, error, value] = message;
      const { resolve, reject } = this.#waiting.get(id);
      this.#waiting.delete(id);
      if (error) reject(new Error(`${error.error}: ${error.message}`));
      else resolve(value?.value !== undefined ? value.value : value);
    }
  }

  ask(command, parameters = {}) {
    const id = this.#next++;
    const text = JSON.stringify([0, id, command, parameters]);
    this.#socket.write(`${Buffer.byteLength(text)}:${text}`);
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  end() { this.#socket.destroy(); }
}

/** Firefox without a window. */
export async function openFirefox() {
  const profile = mkdtempSync(join(tmpdir(), 'lpquad-firefox-'));
  browsers.firefox.prepare(profile);
  writeFileSync(join(profile, 'user.js'), `${readFileSync(join(profile, 'user.js'), 'utf8')}user_pref("marionette.port", 0);\nuser_pref("ui.prefersReducedMotion", 1);\n`);
  const child = spawn(browsers.firefox.path, ['--marionette', ...browsers.firefox.args(profile, 'about:blank')],
    { stdio: 'ignore', detached: true, env: { ...process.env, HOME: profile, MOZ_CRASHREPORTER_DISABLE: '1' } });
  const end = () => {
    try { process.kill(-child.pid, 'SIGKILL'); } catch { /* it is gone */ }
    rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 });
  };
  process.once('exit', end);
  const told = join(profile, 'MarionetteActivePort');
  for (let k = 0; k < 600 && !existsSync(told); ++k) await wait(100);
  const socket = connect(Number(readFileSync(told, 'utf8')), '127.0.0.1');
  await new Promise((resolve, reject) => socket.once('connect', resolve).once('error', reject));
  const line = new Line(socket);
  await line.ask('WebDriver:NewSession', { capabilities: { alwaysMatch: { acceptInsecureCerts: true } } });
  return {
    go: (url) => line.ask('WebDriver:Navigate', { url }),
    evaluate: (script, ...args) => line.ask('WebDriver:ExecuteScript', { script, args, sandbox: null }),
    find: async (selector) => (await line.ask('WebDriver:FindElement', { using: 'css selector', value: selector }))[elementKey],
    async click(selector) { await line.ask('WebDriver:ElementClick', { id: await this.find(selector) }); },
    async type(selector, text) { await line.ask('WebDriver:ElementSendKeys', { id: await this.find(selector), text }); },
    /** Until the script returns something true. */
    async until(script, seconds = 60) {
      for (let k = 0; k < 10 * seconds; ++k) {
        if (await this.evaluate(`return (${script})`)) return;
        await wait(100);
      }
      throw new Error(`Not within ${seconds} s: ${script}`);
    },
    /** Moves the pointer along points of the page, with the button down from the first to the last. */
    drag: (...points) => line.ask('WebDriver:PerformActions', { actions: [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions: [
      { type: 'pointerMove', duration: 0, x: points[0][0], y: points[0][1] }, { type: 'pointerDown', button: 0 },
      ...points.slice(1).map(([x, y]) => ({ type: 'pointerMove', duration: 50, x, y })), { type: 'pointerUp', button: 0 }] }] }),
    press: (key) => line.ask('WebDriver:PerformActions', { actions: [{ type: 'key', id: 'keys', actions: [{ type: 'keyDown', value: key }, { type: 'keyUp', value: key }] }] }),
    end: async () => {
      line.end();
      end();
    },
  };
}
