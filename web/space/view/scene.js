// Which objects are in the view: those of the layers that are on, made anew when what they show changed.
/** @import { SpaceApp, SpaceLayer, SurfaceRun, Work } from '../types' */
/** @import { Palette } from '../../types' */
import { dark, light } from '../../draw/palette.js';
import { askedSize, boxOf } from '../model/work.js';
import { cellObject, crossObject, cutObject, featureObject, irregularObject, pointedObject, quadObject, surfaceObject, targetObject } from './objects.js';

/**
 * A part of the picture: what it depends on, and how it is made; null: it is not there.
 * @typedef {{depends: unknown[], make: () => import('three').Object3D | null}} Part
 */

/** @param {SpaceApp} app */
export function installScene(app) {
  const { runner, store, themes, viewer } = app;
  /** @type {Map<string, unknown[]>} */
  const shown = new Map();
  /** @type {unknown} */
  let fitted = null;

  const refresh = () => {
    const { surface } = store.project;
    if (fitted !== surface) {
      fitted = surface;
      viewer.fit(boxOf(surface.points));
    }
    const parts = partsOf(app, app.runner.run);
    for (const [name, { depends, make }] of Object.entries(parts)) {
      const before = shown.get(name);
      if (before !== undefined && before.length === depends.length && before.every((one, i) => one === depends[i])) continue;
      shown.set(name, depends);
      viewer.show(name, make());
    }
  };
  runner.subscribe(refresh);
  store.subscribe(refresh);
  themes.subscribe(refresh);
  return refresh;
}

/** @param {SpaceApp} app  @param {SurfaceRun} run  @returns {Record<string, Part>} */
function partsOf(app, { frame, work }) {
  const on = app.layers();
  const palette = app.themes.dark ? dark : light;
  // Before the mesher has repaired it: the surface as it was read.
  const surface = work?.surface === app.store.project.surface && frame.surface ? frame.surface : app.store.project.surface;
  const { cells, charts, crosses, features, quads } = work?.surface === app.store.project.surface ? frame : {};
  return {
    ...below(app, on, surface, { cells, charts, quads }, palette),
    features: part([on.has('features'), surface, features, palette], () => (features ? featureObject(surface, features, palette) : null)),
    crosses: part([on.has('crosses'), crosses, palette],
      () => (crosses ? crossObject(surface, crosses, askedSize(app.store.project), palette) : null)),
    valence: part([on.has('valence'), quads, palette], () => (quads ? irregularObject(quads, palette) : null)),
  };
}

/** Faces and the lines on them. @param {SpaceApp} app  @param {ReadonlySet<SpaceLayer>} on
 * @param {Work['surface']} surface  @param {SurfaceRun['frame']} frame  @param {Palette} palette  @returns {Record<string, Part>} */
function below({ pointed, themes, runner }, on, surface, { cells, charts, quads }, palette) {
  const [byChart, lines, quality] = [on.has('charts') && charts !== undefined, on.has('quads'), on.has('quality')];
  const covered = runner.run.phase === 'done' && quads !== undefined && (lines || quality);
  // Where cells or quads of a chart are drawn, the triangles below would stick out where it is round.
  const meshed = quads !== undefined && !byChart && (lines || quality) ? runner.run.state?.chart ?? 0 : 0;
  const celled = on.has('cells') && cells !== undefined ? cells.chart : -1;
  const left = (/** @type {number} */ t) => charts !== undefined && (charts.charts[t] < meshed || charts.charts[t] === celled);
  return {
    surface: part([on.has('surface') || byChart || !covered, surface, byChart && charts, palette, !on.has('surface') && meshed, celled],
      () => surfaceObject(surface, themes.dark, byChart ? charts?.charts : undefined, on.has('surface') ? undefined : left)),
    target: part([true, surface], () => targetObject(surface)),
    pointed: part([pointed.chart >= 0 && charts !== undefined, pointed.chart, surface, charts, palette],
      () => (charts ? pointedObject(surface, charts, pointed.chart, palette) : null)),
    cells: part([celled >= 0, cells, palette], () => (cells ? cellObject(cells, palette) : null)),
    cuts: part([byChart, charts, palette], () => (charts ? cutObject(surface, charts, palette) : null)),
    quads: part([lines || quality, quads, quality, lines, byChart, palette],
      () => (quads ? quadObject(quads, palette, themes.dark, { quality, lines, faces: quality || !byChart }) : null)),
  };
}

/** @param {unknown[]} depends  the first: whether it is there at all  @param {Part['make']} make  @returns {Part} */
const part = (depends, make) => ({ depends: depends[0] ? depends : [false], make: () => (depends[0] ? make() : null) });
