// What the parts of the page are given: everything shared, made once in main.js.
import type { Sides } from './compare/sides.js';
import type { Stage } from './stage/stage.js';
import type { Actions } from './panels/actions.js';
import type { Tabs } from './panels/tabs.js';
import type { Runner } from './run/runner.js';
import type { Store } from './state/store.js';
import type { Themes } from './header/theme.js';
import type { Reading } from './files/reading.js';
import type { Notify } from './panels/notice.js';
import type { Keeping } from './state/keeping.js';
import type { WorkerSession } from 'lpquad/worker';
import type { Drawing, Project, Run, Scene } from './types';

export interface App {
  store: Store<Project>;
  runner: Runner;
  actions: Actions;
  stage: Stage;
  tabs: Tabs;
  themes: Themes;
  /** Says a sentence to screen readers. */
  announce: (text: string) => void;
  /** What is on the screen: the run, or those that are compared. */
  sides: Sides;
  /** The runs that the timeline leads: of what is on the screen. */
  led: () => Runner[];
  /** What is wrong with a drawing; the mesher is not called with it. Set by the sketch part. */
  problemsOf: (drawing: Drawing) => NonNullable<Run['error']>[];
  keeping: Keeping;
  /** Runs that were recorded elsewhere: shown instead of meshing their projects. */
  recordings: { project: Project; open: () => Promise<WorkerSession> }[];
  /** Shows a sentence above the stage, and says it. */
  notify: Notify;
  /** Reads a file so that it can be given up. Set when all is together. */
  reading: Reading;
  /** Opens what a person chose, dropped or pasted. Set by the sketch part. */
  openFiles: (files: File[]) => Promise<void>;
  /** Asked first, in order, whether files are theirs; the sketch part takes what is left. */
  openers: ((files: File[], signal: AbortSignal) => Promise<boolean> | boolean)[];
  /** The scene as it is drawn now. */
  scene: () => Scene;
}
