// A chapter's figure: its project in the store, and its run at the place the chapter speaks of.
/** @import { App } from '../app' */
/** @import { Chapter } from './chapters.js' */
/** @import { State } from 'lpquad' */
import { haveSameMesh } from '../state/project.js';

/**
 * The tick of a place. Of the iterations only some are in the history, each of which is a tick; they
 * may have ended before the one that is looked for.
 * @param {State[]} history  @param {Chapter['at']} at
 */
export function tickOf(history, { stage, iteration }) {
  const last = history.findLast((state) => state.stage === stage);
  return last && last.tick - (iteration === undefined ? 0 : Math.max(0, last.iteration - iteration));
}

/** Plays the run from its start, with what tells most at each stage: a chapter's own layers show one of them.
 * @param {Pick<App, 'store' | 'runner'>} app  @param {Chapter} chapter */
export function watch({ store, runner }, { title }) {
  store.change(`Watch: ${title}`, { layers: 'auto' });
  void runner.seek(0).then(() => runner.play());
}

/** @param {Pick<App, 'store' | 'runner' | 'stage'>} app  @param {Chapter} chapter */
export function showFigure({ store, runner, stage }, { title, project, at }) {
  const other = store.project.drawing !== project.drawing;
  store.change(`Tour: ${title}`, project);
  if (other) stage.fit();
  if (at.stage === 'seeds') return void runner.seek(0);
  const stop = runner.subscribe((run) => {
    if (run.project === null || !haveSameMesh(store.project, project)) return stop();
    if (run.phase === 'failed' || run.phase === 'cancelled') return stop();
    if (run.phase !== 'done' || !haveSameMesh(run.project, project)) return;
    stop();
    const tick = tickOf(run.history, at);
    if (at.stage !== 'done' && tick !== undefined) void runner.seek(tick);
  });
  const { run } = runner;
  const there = run.phase === 'done' && run.project !== null && haveSameMesh(run.project, project);
  if (there) void runner.refresh();
  else void runner.end();
}
