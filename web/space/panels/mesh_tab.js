// The Mesh tab: what the surface mesher is told.
/** @import { SpaceApp } from '../types' */
import { installForm } from '../../mesh/form.js';
import { createSizeField } from '../../mesh/size_field.js';
import { once } from '../../draw/once.js';
import { areaOf, boxOf } from '../model/work.js';

const main = ['size', 'quads', 'featureAngle', 'turn', 'growth', 'effort'];

/** @param {SpaceApp} app */
export function installMeshTab(app) {
  const { store } = app;
  // Of hundreds of thousands of triangles, and asked for at every step of the slider.
  const extent = () => {
    const { surface } = store.project;
    return once(surface, 'extent', () => ({ area: areaOf(surface), radius: boxOf(surface.points).radius }));
  };
  const range = () => ({ least: extent().radius / 150, most: extent().radius / 2.5 });
  installForm(app, ({ surfaceOptions }) => surfaceOptions, main, {
    size: (info, give) => createSizeField(info, give, range, () => extent().area),
  });
}
