// Ways round the page without a pointer: from part to part, and from panel to panel.
/** @import { App } from '../app' */

const order = ['header-actions', 'tools', 'stage', 'timeline', 'panel'];  // space has no tools
const focusable = 'button, input, select, textarea, a[href], canvas[tabindex], [tabindex="0"]';

/** @param {Pick<App, 'actions' | 'tabs'>} app */
export function installRegions({ actions, tabs }) {
  actions.add(
    { id: 'page.next', label: 'To the next part of the page', keys: ['F6'], run: () => go(1) },
    { id: 'page.previous', label: 'To the part of the page before', keys: ['Shift+F6'], run: () => go(-1) },
    { id: 'panel.next', label: 'Next panel', keys: [']'], run: () => tabs.turn(1) },
    { id: 'panel.previous', label: 'Previous panel', keys: ['['], run: () => tabs.turn(-1) },
  );
}

/** @param {1 | -1} by */
function go(by) {
  const parts = order.flatMap((id) => document.getElementById(id) ?? []);
  const at = parts.findIndex((part) => part.contains(document.activeElement));
  for (let k = 1; k <= parts.length; ++k) {
    const part = parts[(Math.max(at, by < 0 ? 0 : -1) + by * k + 2 * parts.length) % parts.length];
    const first = [...part.querySelectorAll(focusable)].find(isReachable);
    if (first) return first.focus();
  }
}

/** @param {Element} element  @returns {element is HTMLElement} */
const isReachable = (element) => element instanceof HTMLElement && element.tabIndex >= 0 && element.checkVisibility();
