// How fast runs play, on either page; remembered as long as the browser's tab.
/** @import { App } from '../app' */
import { h } from '../panels/dom.js';

export const speeds = [0.25, 0.5, 1, 2, 4, 8];
const key = 'lpquad.speed';

function remembered() {
  try {
    const speed = Number(sessionStorage.getItem(key));
    return speeds.includes(speed) ? speed : 1;
  } catch {
    return 1;  // a browser may forbid it
  }
}

/** @param {Pick<App, 'actions' | 'announce'>} page  @param {{speed: number}} runner
 * @param {() => {speed: number}[]} [others]  that run with it  @returns {HTMLElement} */
export function createSpeed({ actions, announce }, runner, others = () => []) {
  const select = h('select', {
    className: 'speed', 'aria-label': 'Speed', title: 'How fast the run plays',
    onchange: () => set(Number(select.value)),
  }, ...speeds.map((speed) => h('option', { value: String(speed) }, `${speed}×`)));

  function set(/** @type {number} */ speed) {
    for (const led of [runner, ...others()]) led.speed = speed;
    select.value = String(speed);
    try {
      sessionStorage.setItem(key, String(speed));
    } catch { /* then it is forgotten */ }
    actions.refresh();
  }
  function turn(/** @type {number} */ by) {
    set(speeds[speeds.indexOf(runner.speed) + by]);
    announce(`Speed ${runner.speed}×`);
  }
  actions.add(
    { id: 'run.slower', label: 'Slower', icon: 'speed', keys: ['<'],
      enabled: () => runner.speed > speeds[0], run: () => turn(-1) },
    { id: 'run.faster', label: 'Faster', icon: 'speed', keys: ['>'],
      enabled: () => runner.speed < speeds[speeds.length - 1], run: () => turn(1) },
  );
  set(remembered());
  return select;
}
