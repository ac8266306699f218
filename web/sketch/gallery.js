// The presets as pictures to choose from. The pictures are made of the drawings themselves.
/** @import { App } from '../app' */
/** @import { Preset } from './presets.js' */
/** @import { Point, Project } from '../types' */
import { h, s } from '../panels/dom.js';
import { replaceProject } from '../state/replace.js';
import { boxOfDrawing } from './model/drawing.js';
import { presets } from './presets.js';

const width = 96, height = 64, margin = 5;

/** Path data of a project's outlines, lines and given points. @param {Pick<Project, 'drawing' | 'seedPoints'>} project */
export function thumbnailPaths({ drawing, seedPoints }) {
  const [left, bottom, right, top] = boxOfDrawing(drawing);
  const scale = Math.min((width - 2 * margin) / (right - left), (height - 2 * margin) / (top - bottom));
  const at = (/** @type {Point} */ [x, y]) =>
    `${(width / 2 + scale * (x - (left + right) / 2)).toFixed(1)} ${(height / 2 - scale * (y - (bottom + top) / 2)).toFixed(1)}`;
  const line = (/** @type {Point[]} */ points) => `M${points.map(at).join('L')}`;
  const dots = [...seedPoints, ...drawing.points.map(({ position }) => position)];
  return {
    areas: drawing.regions.map(({ loops }) => loops.map((loop) => `${line(loop)}Z`).join('')),
    lines: drawing.polylines.map(({ points }) => line(points)).join(''),
    dots: dots.map((p) => `M${at(p)}h0`).join(''),
  };
}

/** @param {Preset} preset */
function thumbnail({ project }) {
  const { areas, lines, dots } = thumbnailPaths(project);
  return s('svg', { viewBox: `0 0 ${width} ${height}`, class: 'thumbnail', 'aria-hidden': 'true' },
    ...areas.map((d, i) => s('path', { d, class: `area area-${i % 2}`, 'fill-rule': 'evenodd' })),
    lines !== '' && s('path', { d: lines, class: 'line' }), dots !== '' && s('path', { d: dots, class: 'dots' }));
}

/** @param {App} app */
export function createGallery(app) {
  const { actions, store, announce } = app;
  const choose = (/** @type {Preset} */ { title, why, project }) => {
    replaceProject(app, `Open ${title}`, { ...project, comparison: store.project.comparison });
    announce(`${title}. ${why}`);
  };
  for (const preset of presets)
    actions.add({ id: `preset.${preset.id}`, label: preset.title, pressed: () => store.project.preset === preset.id, run: () => choose(preset) });
  const cards = presets.map((preset) => {
    const card = actions.button(`preset.${preset.id}`, { labelled: true, title: preset.why, className: 'preset' });
    card.prepend(thumbnail(preset));
    return card;
  });
  return h('section', { className: 'gallery', 'aria-label': 'Domains to begin with' }, h('h2', null, 'Begin with'), h('div', { className: 'presets' }, ...cards));
}
