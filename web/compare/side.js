// One half of a comparison: a run of its own, with its own worker and picture.
/** @import { LpquadWorker } from 'lpquad/worker' */
/** @import { App } from '../app' */
/** @import { Project } from '../types' */
/** @import { Side } from './comparisons.js' */
import { dark, light } from '../draw/palette.js';
import { figuresOf } from '../figures/statistics.js';
import { h, setText, withoutSubscripts, withSubscripts } from '../panels/dom.js';
import { isAnother, shownOf } from '../run/follow.js';
import { Runner } from '../run/runner.js';
import { describe } from '../run/words.js';
import { Stage } from '../stage/stage.js';
import { projectOf } from './comparisons.js';

const nothing = { project: null, frame: null };  // a side has no previews

/** @param {string} letter */
function createParts(letter) {
  const name = h('span', null), told = h('output', { className: 'quiet numbers' });
  const canvas = h('canvas', { role: 'img', tabIndex: 0 });  // arrow keys move the view
  const area = h('div', { className: 'side-stage' }, h('canvas', { 'aria-hidden': 'true' }), canvas);
  const element = h('div', { className: 'side', role: 'group', 'aria-label': `Mesh ${letter}` },
    h('div', { className: 'side-head' }, h('strong', null, letter), name, told), area);
  return { name, told, canvas, area, element };
}

/** @param {App} app  @param {() => Promise<LpquadWorker>} createEngine */
function createRunner(app, createEngine) {
  const runner = new Runner(createEngine);
  runner.still = app.runner.still;
  runner.wantedLayers = () => app.store.project.layers;
  return runner;
}

/** @param {Runner['run']} run  @param {string} freshness */
function wordsOf(run, freshness) {
  if (freshness !== 'current') return 'out of date';
  const { etaMean, fourValentPercent } = figuresOf(run);
  return describe(run) + (etaMean === undefined ? '' : `, η ${etaMean.toFixed(3)}, ${fourValentPercent?.toFixed(1)} % regular`);
}

/** @param {App} app  @param {string} letter  @param {() => Promise<LpquadWorker>} createEngine */
export function createSide(app, letter, createEngine) {
  /** @type {{project: Project, side: Side, made: Project} | null} */
  let last = null;
  const runner = createRunner(app, createEngine);
  const { name, told, canvas, area, element } = createParts(letter);
  const project = () => last?.made ?? app.store.project;
  const stage = new Stage(area, () => ({
    ...app.scene(), ...shownOf(project(), runner.run, nothing),
    palette: app.themes.dark ? dark : light, drawing: app.store.project.drawing, norm: project().options.norm ?? 6,
  }));

  const refresh = () => {
    const { freshness } = stage.scene();
    const text = wordsOf(runner.run, freshness);
    setText(told, text);
    told.title = text;  // it may be cut off
    canvas.setAttribute('aria-label', `Mesh ${letter}, ${withoutSubscripts(last?.side.name ?? '')}: ${text}`);
    area.dataset.freshness = freshness;
    stage.invalidate();
  };
  runner.subscribe(refresh);

  return {
    element, letter, project, runner, stage, refresh, scene: stage.scene,
    get name() { return `${letter}: ${last?.side.name ?? ''}`; },
    figures: () => (stage.scene().freshness === 'current' ? figuresOf(runner.run) : { final: false }),
    /** @param {Project} whole  @param {Side} side */
    follow(whole, side) {
      const made = projectOf(whole, side, last);
      const same = last !== null && made.options === last.made.options && runner.run.project !== null;
      const keep = last === null || !isAnother(whole, last.project);
      last = { project: whole, side, made };
      name.replaceChildren(...withSubscripts(side.name));
      if (same) return void runner.refresh();
      const [problem] = app.problemsOf(whole.drawing);
      if (problem) runner.refuse(made, problem, { keep });
      else void runner.load(made, { going: 'end', keep });
    },
    /** A gesture goes on: what is shown is of before. */
    wait() {
      const { drawing } = app.store.project;
      if (last !== null) last = { ...last, made: { ...last.made, drawing, options: { ...last.made.options } } };
      runner.pause();
      refresh();
    },
    close() {
      last = null;
      runner.close();
    },
  };
}
