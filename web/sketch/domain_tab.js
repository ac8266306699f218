// The Domain tab: the numbers of the tool in hand and of what is chosen, snapping, and domains to
// begin with. Where there is little room those come first, or the tool that something is drawn with.
/** @import { App } from '../app' */
/** @import { Field } from './fields.js' */
/** @import { Sketch } from './sketch.js' */
/** @import { Tools } from './tools.js' */
import { h } from '../panels/dom.js';
import { atNextPicture } from '../panels/next_picture.js';
import { firstWhereSmall } from '../panels/small.js';
import { numberField } from './fields.js';
import { createGallery } from './gallery.js';
import { selectionSection } from './selection_fields.js';
import { toolFields } from './tool_fields.js';

/** @param {App} app  @param {Sketch} sketch  @param {Tools} tools */
export function installDomainTab(app, sketch, tools) {
  const { actions, stage } = app;
  const tool = h('section', { className: 'tool-section', 'aria-label': 'Tool in hand' });
  const selection = selectionSection(app, sketch);
  const snapping = snapSection(app, sketch);
  const gallery = createGallery(app);
  /** @type {Field[]} */
  let fields = [];
  let shown = '';

  function refresh() {
    if (shown !== stage.tool.id) {
      shown = stage.tool.id;
      const entry = tools.entries.find((one) => one.tool === stage.tool) ?? tools.entries[0];
      const made = toolFields(app, sketch, tools, entry.tool.id);
      fields = made.fields;
      tool.replaceChildren(h('h2', null, entry.label), h('p', { className: 'hint' }, entry.hint), ...made.content);
      for (const place of places) place();
    }
    selection.element.hidden = shown !== 'edit';
    for (const field of fields) field.refresh();
    selection.refresh();
    snapping.refresh();
  }

  const soon = atNextPicture(refresh);  // not at every step of a drag
  sketch.subscribe(soon);
  app.store.subscribe(soon);
  app.tabs.add('domain', 'Domain',
    h('div', { className: 'buttons' }, actions.button('file.open', { labelled: true }), actions.button('sketch.empty', { labelled: true })),
    tool, selection.element, snapping.element, gallery);
  const editing = () => stage.tool.id === 'edit';
  const places = [firstWhereSmall(gallery, editing), firstWhereSmall(tool, () => !editing())];
  refresh();
}

/** @param {App} app  @param {Sketch} sketch */
function snapSection({ actions }, sketch) {
  const grid = numberField({ label: 'Grid', min: 1e-300, hint: 'auto', title: 'Grid size; leave empty for one that fits the view',
    get: () => sketch.snapping.gridSize || null, set: (gridSize) => sketch.set({ snapping: { ...sketch.snapping, gridSize } }) });
  grid.element.addEventListener('change', () => {
    if (grid.value() === null) sketch.set({ snapping: { ...sketch.snapping, gridSize: 0 } });
  });
  const angle = h('select', { onchange: () => sketch.set({ snapping: { ...sketch.snapping, angleStep: Number(angle.value) } }) },
    ...['15', '30', '45', '90'].map((degrees) => h('option', { value: degrees }, `${degrees}°`)));
  const element = h('section', { className: 'snap-section', 'aria-label': 'Snapping' },
    h('div', { className: 'fields' },
      h('div', { className: 'buttons', role: 'group', 'aria-label': 'Snap to' },
        actions.button('snap.vertices'), actions.button('snap.grid'), actions.button('snap.angles')),
      grid.element, h('label', { className: 'field' }, h('span', null, 'Angles'), angle)));
  return { element, refresh: grid.refresh };
}

