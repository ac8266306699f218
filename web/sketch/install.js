// Everything for drawing a domain.
/** @import { App } from '../app' */
import { installDomainTab } from './domain_tab.js';
import { ErrorBar } from './error_bar.js';
import { drawGrid, drawGuides, drawMeetings } from './marks.js';
import { installOpening } from './open.js';
import { Sketch } from './sketch.js';
import { installTools, makeTools } from './tools.js';

/** @param {App} app */
export function installSketch(app) {
  const sketch = new Sketch(app);
  app.problemsOf = (drawing) => sketch.problemsOf(drawing);
  app.stage.overlays.push(
    (context, view) => drawGrid(context, view, sketch),
    (context, view) => drawGuides(context, view, sketch),
    (context, view) => drawMeetings(context, view, sketch),
  );
  const tools = makeTools(sketch);
  installTools(app, sketch, tools);
  const bar = new ErrorBar(app, sketch);
  installOpening(app, (notice) => bar.show(notice));
  installDomainTab(app, sketch, tools);
}
