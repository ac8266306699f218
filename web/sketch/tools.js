// The tools by name: actions, keys and the rail of buttons beside the stage.
/** @import { App } from '../app' */
/** @import { IconName } from '../panels/icons.js' */
/** @import { Tool } from '../stage/stage.js' */
/** @import { Sketch } from './sketch.js' */
import { GuideTool, sizeBrush } from './tools/brushes.js';
import { circleTool, freehandTool, rectangleTool } from './tools/drag_shapes.js';
import { EditTool } from './tools/edit.js';
import { PointsTool, pointTool } from './tools/points.js';

/** @typedef {{tool: Tool, label: string, icon: IconName, key: string, hint: string}} ToolEntry */

/** @param {Sketch} sketch */
export function makeTools(sketch) {
  const polygon = new PointsTool(sketch, true), line = new PointsTool(sketch, false), point = pointTool(sketch);
  const brush = sizeBrush(sketch), guide = new GuideTool(sketch);
  /** @type {ToolEntry[]} */
  const entries = [
    { tool: new EditTool(sketch), label: 'Edit', icon: 'edit', key: 'V',
      hint: 'Drag a vertex; click an edge to add one. N and P choose; on the stage arrows move, and Insert and Delete work.' },
    { tool: polygon, label: 'Outline by points', icon: 'polygon', key: 'P',
      hint: 'Click the corners; click the first again, or press Enter, to close. Backspace takes the last one back.' },
    { tool: freehandTool(sketch), label: 'Outline by hand', icon: 'freehand', key: 'F', hint: 'Draw around; it closes when you let go.' },
    { tool: circleTool(sketch), label: 'Circle', icon: 'circle', key: 'O', hint: 'Drag from the centre outwards.' },
    { tool: rectangleTool(sketch), label: 'Rectangle', icon: 'rectangle', key: 'R', hint: 'Drag from corner to corner.' },
    { tool: line, label: 'Line inside', icon: 'line', key: 'L', hint: 'Click its points and press Enter: the line becomes mesh edges.' },
    { tool: point, label: 'Point inside', icon: 'point', key: 'X', hint: 'Click a place: it becomes a vertex of the mesh.' },
    { tool: brush, label: 'Size brush', icon: 'brush', key: 'B', hint: 'Paint where the mesh is to be finer. Shift erases.' },
    { tool: guide, label: 'Guide strokes', icon: 'guide', key: 'G', hint: 'Draw lines that the quads are to follow. Shift erases.' },
  ];
  return { entries, polygon, line, point, brush, guide };
}

/** @typedef {ReturnType<typeof makeTools>} Tools */

/** @param {App} app  @param {Sketch} sketch  @param {Tools} tools */
export function installTools({ actions, stage, tabs, announce }, sketch, { entries }) {
  const choose = (/** @type {ToolEntry} */ { tool, label, hint }) => {
    stage.tool = tool;
    if (tool.id !== 'edit') tabs.open('domain');
    sketch.changed();
    actions.refresh();
    announce(`${label}. ${hint}`);
  };
  for (const entry of entries)
    actions.add({
      id: `tool.${entry.tool.id}`, label: entry.label, icon: entry.icon, keys: [`Shift+${entry.key}`],
      pressed: () => stage.tool === entry.tool, run: () => choose(entry),
    });
  const toggle = (/** @type {'vertices' | 'grid' | 'angles'} */ name) => {
    sketch.set({ snapping: { ...sketch.snapping, [name]: !sketch.snapping[name] } });
    actions.refresh();
  };
  actions.add(
    { id: 'snap.grid', label: 'Snap to the grid', icon: 'grid', keys: ['#'], pressed: () => sketch.snapping.grid, run: () => toggle('grid') },
    { id: 'snap.vertices', label: 'Snap to vertices', icon: 'snap', pressed: () => sketch.snapping.vertices, run: () => toggle('vertices') },
    { id: 'snap.angles', label: 'Snap to angles', icon: 'angle', pressed: () => sketch.snapping.angles, run: () => toggle('angles') },
    { id: 'sketch.whole', label: 'Move whole outlines', icon: 'whole', keys: ['Shift+W'], pressed: () => sketch.whole,
      run: () => {
        sketch.set({ whole: !sketch.whole });
        actions.refresh();
      } },
  );
  const rail = /** @type {HTMLElement} */ (document.getElementById('tools'));
  rail.append(...entries.map(({ tool }) => actions.button(`tool.${tool.id}`)));
  stage.tool = entries[0].tool;
  actions.refresh();
}
