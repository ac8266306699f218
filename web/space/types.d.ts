// The plain values of the page for surfaces.
import type { Surface, SurfaceMeshResult, SurfaceOptions, SurfaceSnapshot, SurfaceProgress } from 'lpquad';
import type { Actions } from '../panels/actions.js';
import type { Tabs } from '../panels/tabs.js';
import type { Themes } from '../header/theme.js';
import type { Store } from '../state/store.js';
import type { SurfaceRunner } from './run/runner.js';
import type { Viewer } from './view/viewer.js';

export type SpaceLayer = 'surface' | 'features' | 'charts' | 'cells' | 'crosses' | 'quads' | 'quality' | 'valence';

/** What a person works on. Immutable; undo is going back to an old one. */
export interface Work {
  name: string;
  /** its id, if the surface is one of the page's own */
  preset?: string;
  surface: Surface;
  options: SurfaceOptions;
  /** 'auto': what tells most at each stage of the run */
  layers: readonly SpaceLayer[] | 'auto';
}

export type Phase = 'idle' | 'running' | 'done' | 'failed' | 'cancelled';

/** One run of the mesher, as far as it is. */
export interface SurfaceRun {
  phase: Phase;
  work: Work | null;
  state: SurfaceProgress | null;
  /** every layer since its stage is over */
  frame: Partial<SurfaceSnapshot>;
  result: SurfaceMeshResult | null;
  error: { code: string; message: string } | null;
  paused: boolean;
}

/** What the parts of this page are given. */
export interface SpaceApp {
  store: Store<Work>;
  runner: SurfaceRunner;
  actions: Actions;
  tabs: Tabs;
  themes: Themes;
  viewer: Viewer;
  announce: (text: string) => void;
  notify: import('../panels/notice.js').Notify;
  /** The layers that are drawn now. */
  layers: () => ReadonlySet<SpaceLayer>;
  /** The chart that is pointed at, -1 for none; both views show it. */
  pointed: { chart: number };
  point: (chart: number) => void;
}
