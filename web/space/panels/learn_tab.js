// The Learn tab: how the mesh of a surface is made, in the order of the run.
/** @import { SpaceApp } from '../types' */
import { citation } from '../../learn/paper.js';
import { h, withSubscripts } from '../../panels/dom.js';

/** @type {[string, string][]} */
const steps = [
  ['Why charts?', `Squares are easy to make in a plane: there, distances and right angles can be measured with a ruler. A surface in space
    is bent. So it is cut along its sharp edges into faces, and faces that cannot be spread out, such as a closed tube, are cut further. Each
    part that is left, a chart, is laid in a plane, meshed there, and the mesh is carried back.`],
  ['Conformal maps', `A map of the Earth cannot keep all lengths. It can keep all angles, as sailors’ maps do; then little squares stay
    little squares, and only their sizes differ from place to place. Such a map is called conformal. It suits quads: their right angles
    survive the way back. What a chart is stretched by at each place is known, and the quads are made so much larger or smaller
    in the plane that they have the wanted size in space.`],
  ['In the plane', `Points are spread over the chart and moved until the ground nearest to each is a square, turned as the
    cross field says: that is the L_p energy becoming small, as on the page Plane. Their triangles are merged in pairs to quads.`],
  ['Back in space', `Charts share the points of their borders, so that the parts fit. But nobody has looked across a cut: quads there
    are of two minds. The bands along the cuts are therefore meshed once more, on the surface itself, and at last all vertices
    are moved on it until the corners are as square as they get.`],
  ['Reading the picture', `On the left is the surface, beside or below it are its charts, each as large as it is in space. Point at one, and it lights
    up in both. Marks are irregular vertices, where three or five quads meet instead of four. A ball needs them; where they are is a choice.`],
];

/** @param {Pick<SpaceApp, 'tabs'>} app */
export function installLearnTab({ tabs }) {
  const article = h('article', null, ...steps.flatMap(([title, text]) => [h('h2', null, title), h('p', null, ...withSubscripts(text.replace(/\s+/g, ' ')))]),
    h('h2', null, 'The paper'),
    h('p', null, ...citation()),
    h('p', { className: 'quiet' }, 'Its surfaces have one map each. Cutting into several charts, the seams and the moves in space are additions.'));
  tabs.add('learn', 'Learn', article);
}
