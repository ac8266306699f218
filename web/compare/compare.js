// Two meshes of the same drawing side by side, with the same view and the same clock.
/** @import { LpquadWorker } from 'lpquad/worker' */
/** @import { App } from '../app' */
/** @import { Stage } from '../stage/stage.js' */
/** @import { View } from '../types' */
import { h, withoutSubscripts, withSubscripts } from '../panels/dom.js';
import { comparisonOf, comparisons } from './comparisons.js';
import { createDifferences } from './differences.js';
import { createSide } from './side.js';

/** @param {App} app  @param {() => Promise<LpquadWorker>} createEngine  @param {() => void} refreshTimeline */
export function installCompare(app, createEngine, refreshTimeline) {
  const { store, actions, announce } = app;
  const [alone] = app.sides.all;
  const section = h('section', { id: 'compare', role: 'main', hidden: true, 'aria-label': 'Comparison' });
  app.stage.element.after(section);
  const choose = (/** @type {string} */ id) => {
    const title = withoutSubscripts(comparisonOf(id)?.title ?? '');
    store.change(id === '' ? 'End the comparison' : `Compare ${title}`, { comparison: id });
    announce(id === '' ? 'Comparison ended' : `Comparing: ${title}`);
  };
  const { body, show } = createTab(app, choose);
  actions.add(
    { id: 'compare.next', label: 'Compare the next', icon: 'compare', keys: ['Shift+C'], run: () => {
      const at = comparisons.findIndex(({ id }) => id === store.project.comparison);
      choose(comparisons[(at + 1) % comparisons.length].id);
    } },
    { id: 'compare.end', label: 'End the comparison', icon: 'close',
      enabled: () => store.project.comparison !== '', run: () => choose('') });
  body.append(actions.button('compare.end', { labelled: true }));

  /** @type {ReturnType<typeof createPair> | null} */
  let pair = null;
  const refresh = () => {
    show(pair?.figures ?? []);
    app.sides.tell();
    refreshTimeline();
    actions.refresh();
  };
  function follow() {
    const comparison = comparisonOf(store.project.comparison);
    section.hidden = comparison === undefined;
    document.body.classList.toggle('comparing', comparison !== undefined);
    if (comparison === undefined) pair?.close();
    else {
      pair ??= createPair(app, section, createEngine, refresh);
      pair.follow(comparison);
    }
    app.sides.show(comparison === undefined || pair === null ? [alone] : pair.sides);
    refresh();
  }
  store.subscribe(follow);
  app.themes.subscribe(() => pair?.refresh());
  follow();
}

/**
 * @param {App} app  @param {HTMLElement} section
 * @param {() => Promise<LpquadWorker>} createEngine  @param {() => void} changed
 */
function createPair(app, section, createEngine, changed) {
  const sides = ['A', 'B'].map((letter) => createSide(app, letter, createEngine));
  section.replaceChildren(h('div', { className: 'sides' }, ...sides.map(({ element }) => element)));
  link(app.stage, sides.map(({ stage }) => stage));
  for (const { runner } of sides) runner.subscribe(changed);
  return {
    sides,
    get figures() { return sides.map(({ figures }) => figures()); },
    refresh: () => sides.forEach(({ refresh }) => refresh()),
    close: () => sides.forEach(({ close }) => close()),
    /** @param {NonNullable<ReturnType<typeof comparisonOf>>} comparison */
    follow(comparison) {
      sides.forEach((side, i) => {
        side.runner.speed = app.runner.speed;
        if (app.store.gesture !== '') side.wait();
        else side.follow(app.store.project, comparison.sides[i]);
        side.refresh();
      });
    },
  };
}

/** The same part of the world in another frame. @param {View} view  @param {View} other @returns {View} */
function sameIn({ scale, left, top, width, height }, other) {
  const turned = scale * Math.min(other.width / width, other.height / height);
  const [x, y] = [left + width / 2 / scale, top - height / 2 / scale];  // the middle stays there
  return { ...other, scale: turned, left: x - other.width / 2 / turned, top: y + other.height / 2 / turned };
}

/** What one stage looks at, the others do. @param {Stage} main  @param {Stage[]} stages */
function link(main, stages) {
  let following = false;
  const lead = (/** @type {Stage} */ from) => (/** @type {View} */ view) => {
    if (following) return;
    following = true;
    for (const stage of stages) if (stage !== from) stage.look(sameIn(view, stage.view));
    following = false;
  };
  for (const stage of [main, ...stages]) stage.looked = lead(stage);
}

/** The tab where comparisons are chosen, with the table of differences.
 * @param {App} app  @param {(id: string) => void} choose */
function createTab({ store, tabs }, choose) {
  const why = h('p', { className: 'help' });
  const radios = ['', ...comparisons.map(({ id }) => id)].map((id) =>
    h('input', { type: 'radio', name: 'comparison', value: id, 'aria-label': withoutSubscripts(comparisonOf(id)?.title ?? 'nothing'), onchange: () => choose(id) }));
  const list = h('fieldset', { className: 'comparisons' }, h('legend', null, 'Compare on this drawing'),
    ...radios.map((radio, i) => h('label', null, radio, h('span', null, ...(i === 0 ? ['nothing'] : withSubscripts(comparisons[i - 1].title))))));
  const differences = createDifferences();
  const body = tabs.add('compare', 'Compare', list, why, differences.element);
  const show = (/** @type {import('../figures/statistics.js').Figures[]} */ figures) => {
    const { comparison } = store.project;
    const chosen = comparisonOf(comparison);
    for (const radio of radios) radio.checked = radio.value === (chosen ? comparison : '');
    why.replaceChildren(...withSubscripts(chosen?.why ?? 'Two meshes of the same drawing side by side, with one thing changed.'));
    differences.show(chosen, figures);
  };
  return { body, show };
}
