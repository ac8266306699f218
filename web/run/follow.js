// What is meshed when: while a gesture goes on, a coarse preview follows the hand; when it rests or
// is over, the real run starts. A drawing with faults is not meshed at all.
/** @import { App } from '../app' */
/** @import { Freshness, LayerName, Project, Run, Snapshot } from '../types' */
import { haveSameMesh } from '../state/project.js';
import { h, setText } from '../panels/dom.js';
import { shownLayers } from './needed.js';
import { Preview } from './preview.js';

const rest = 250;  // milliseconds without a change

/** Whether it is another drawing than before and not the same one, edited: the old mesh says nothing about it.
 * @param {Project} project  @param {Project} before */
export const isAnother = (project, before) => project.drawing.regions.length === 0 || project.name !== before.name
  || (project.preset !== '' && project.preset !== before.preset);

/**
 * What there is to show of a project, and whether it is its mesh.
 * @param {Project} project  @param {Run} run  @param {Preview['shown']} preview
 * @returns {{frame: Snapshot | null, result: Run['result'], freshness: Freshness, layers: ReadonlySet<LayerName>}}
 */
export function shownOf(project, run, preview) {
  const current = run.frameOf !== null && haveSameMesh(run.frameOf, project);
  if (!current && preview.frame !== null)
    return { frame: preview.frame, result: null, freshness: 'preview', layers: new Set(['boundary', 'quads']) };
  const { frame } = run;
  const result = current && frame?.stage === 'done' ? run.result : null;
  const freshness = current || frame === null ? 'current' : 'old';
  return { frame, result, freshness, layers: shownLayers(project.layers, frame ?? run.state) };
}

/** @param {App} app  @param {Preview} preview */
function createStart(app, preview) {
  const { runner } = app;
  /** @param {Project} project  @param {'play' | 'end'} going  @param {boolean} [keep] */
  return (project, going, keep = going === 'end') => {
    if (!keep) preview.clear();
    const [problem] = app.problemsOf(project.drawing);
    if (problem) runner.refuse(project, problem, { keep });
    else {
      const open = app.recordings.find((recording) => haveSameMesh(recording.project, project))?.open;
      void runner.load(project, { going: runner.still ? 'end' : going, keep, open });
    }
  };
}

/** @param {App} app  @param {Preview} preview  @returns how the first run is started */
export function installFollowing(app, preview) {
  const { store, runner } = app;
  const start = createStart(app, preview);
  let timer = /** @type {ReturnType<typeof setTimeout> | undefined} */ (undefined);
  let held = false;  // the run was stopped for a gesture, not by the person

  /** @param {Project} project  @param {'play' | 'end'} going  @param {boolean} [keep]  the old picture until there is a new one */
  function runInFull(project, going, keep) {
    clearTimeout(timer);
    const { run } = runner;
    const same = run.project !== null && haveSameMesh(run.project, project) && run.phase !== 'cancelled';
    if (same && held) void runner.end();
    if (!same) start(project, going, keep);
    held = false;
  }

  /** @param {Project} project */
  function previewNow(project) {
    clearTimeout(timer);
    held ||= runner.going;
    runner.pause();
    if (app.problemsOf(project.drawing).length > 0) {
      preview.clear();
      start(project, 'end');
    } else {
      preview.ask(project);
      timer = setTimeout(() => runInFull(store.project, 'end'), rest);
    }
  }

  store.subscribe((project, before) => {
    const changed = !haveSameMesh(project, before);
    if (changed && store.gesture !== '') previewNow(project);
    else if (changed || store.gesture === '')
      runInFull(project, project.preset !== '' && project.preset !== before.preset ? 'play' : 'end', !isAnother(project, before));
    if (project.layers !== before.layers) void runner.refresh();
  });
  runner.subscribe(({ phase, frameOf }) => {
    if (frameOf !== null && haveSameMesh(frameOf, store.project)) preview.clear();
    if (phase === 'done') void preview.warm();
  });
  preview.subscribe(() => app.stage.invalidate());
  return start;
}

/** Says beside a mesh that is not the drawing's that it is not. @param {App} app  @param {Preview} preview */
export function installFreshness({ stage, scene, store, runner }, preview) {
  const note = h('div', { className: 'freshness', hidden: true });
  stage.element.append(note);
  const words = { current: '', preview: 'Preview: coarse mesh', old: 'Out of date' };
  const refresh = () => {
    const { freshness } = scene();
    setText(note, words[freshness]);
    note.hidden = freshness === 'current';
    stage.element.dataset.freshness = freshness;
  };
  store.subscribe(refresh);
  runner.subscribe(refresh);
  preview.subscribe(refresh);
}
