// The tour: what somebody needs who has never heard of meshes, one idea at a time. Each chapter has
// its figure (a project and a place of its run) and the formula behind it.
/** @import { State } from 'lpquad' */
/** @import { LayerName, MeshOptions, Project } from '../types' */
import { presets } from '../sketch/presets.js';
import { emptyProject } from '../state/project.js';

/**
 * @typedef {object} Chapter
 * @property {string} id  in links
 * @property {string} title
 * @property {string} text  80 to 120 words; an empty line parts paragraphs
 * @property {string} formula  MathML
 * @property {string} spoken  the formula in words
 * @property {string} source  where the formula is from
 * @property {Project} project
 * @property {{stage: State['stage'], iteration?: number}} at  what its run shows first
 */

const plate = /** @type {Project} */ (presets.find(({ id }) => id === 'plate')?.project);
const paper = 'Carrier Baudouin et al. 2012';

/** @param {MeshOptions} options  @param {LayerName[]} layers  @returns {Project} */
const figure = (options, layers) => ({ ...emptyProject, preset: 'plate', drawing: plate.drawing, options: { size: 0.06, ...options }, layers });

const cells = /** @type {LayerName[]} */ (['boundary', 'cells', 'density']);

/** @type {Chapter[]} */
export const chapters = [
  {
    id: 'quads', title: 'Why quads?',
    text: `A computer cannot bend a whole plate at once. It cuts the plate into small pieces, solves an easy problem on each, and puts
      the answers together. Pieces with four corners are worth some trouble: they follow layers and edges, they need fewer points
      than triangles for the same accuracy, and they do not turn falsely stiff when bent.

      But they are hard to make. Anything can be cut into triangles; quads have a direction, and have to agree about it with all
      their neighbours.

      The figure shows where we want to get. The formula scores a quad by its worst angle: 1 is a rectangle, 0 is a corner gone
      flat.`,
    formula: `<mi>η</mi><mo>(</mo><mi>q</mi><mo>)</mo><mo>=</mo><mi>max</mi><mo>(</mo><mn>1</mn><mo>−</mo><mfrac><mn>2</mn><mi>π</mi></mfrac>
      <munder><mi>max</mi><mi>k</mi></munder><mo>|</mo><mfrac><mi>π</mi><mn>2</mn></mfrac><mo>−</mo><msub><mi>α</mi><mi>k</mi></msub><mo>|</mo><mo>,</mo><mn>0</mn><mo>)</mo>`,
    spoken: 'The quality eta of a quad is one minus two over pi times the largest difference of its four angles from a right angle, and not below zero.',
    source: `${paper}, section 5`,
    project: figure({}, ['boundary', 'quads', 'quality']), at: { stage: 'done' },
  },
  {
    id: 'boundary', title: 'The outline comes first',
    text: `Meshes of neighbouring parts must fit together. So the outline is cut into edges first, and then never touched again. That
      has a price.

      Every quad has four sides; a side inside belongs to two quads, a side on the outline to one. Count the sides both ways, and
      the formula follows: the number of sides on the outline is even. If it were odd, one triangle would be left over, whatever
      is done inside.

      The page cuts your outline to the size you ask for and takes care of that. If you make it keep your own points instead, it
      tells you when one is missing, and offers to add it.`,
    formula: '<mn>4</mn><mi>Q</mi><mo>=</mo><mn>2</mn><msub><mi>E</mi><mtext>inside</mtext></msub><mo>+</mo><mi>B</mi>',
    spoken: 'Four times the number of quads is twice the number of edges inside plus the number of edges on the boundary.',
    source: `A count, not in the paper; that edge meshes are kept: ${paper}, section 1`,
    project: figure({ seeds: 'isotropic', method: 'paper' }, ['boundary', 'triangles']), at: { stage: 'optimise', iteration: 0 },
  },
  {
    id: 'lloyd', title: 'To each point its own ground',
    text: `Throw points into the outline, and give each the ground that is nearer to it than to any other point: its Voronoi cell. Now
      move every point to where its own ground is easiest to reach, cut new cells, and repeat. That is Lloyd's old recipe.

      The sum in the formula adds up how far all ground is from its point, and every round makes it smaller. With ordinary
      distance, p = 2, cells become round, and round things pack like honeycomb.

      Between honeycomb cells lie triangles with three equal angles. They are pretty, but two of them make a slanted quad. Blue
      cells cost least, warm colours most.`,
    formula: `<mi>F</mi><mo>=</mo><munderover><mo>∑</mo><mrow><mi>i</mi><mo>=</mo><mn>1</mn></mrow><mi>N</mi></munderover>
      <msub><mo>∫</mo><msub><mi>R</mi><mi>i</mi></msub></msub><mi>ρ</mi><mo>(</mo><mi>y</mi><mo>)</mo>
      <msubsup><mrow><mo>‖</mo><mi>M</mi><mo>(</mo><mi>y</mi><mo>−</mo><msub><mi>x</mi><mi>i</mi></msub><mo>)</mo><mo>‖</mo></mrow><mi>p</mi><mi>p</mi></msubsup><mi>d</mi><mi>y</mi>`,
    spoken: 'The energy F is the sum over all points of the integral over the point\'s cell of the density times the p-th power of the distance, measured in the turned frame M.',
    source: `${paper}, Eq. (4), here with p = 2`,
    project: figure({ seeds: 'isotropic', method: 'paper', norm: 2 }, cells), at: { stage: 'optimise', iteration: 60 },
  },
  {
    id: 'norm', title: 'A distance with corners',
    text: `Change nothing but how distance is measured. Ordinary distance adds squares, so the places equally far from a point lie on a
      circle. Add sixth powers instead, and the circle becomes a square with rounded corners; the Mesh tab draws that shape for
      every p.

      A cell wants to look like that shape, so cells become squares, and their points line up in rows and columns. The cells
      themselves are still cut with ordinary distance.

      A larger p makes squarer cells, but the sum is harder to make small; the paper settles on six. Points in rows are joined by
      triangles with a right angle, and two of those make a good quad.`,
    formula: `<msubsup><mrow><mo>‖</mo><mi>y</mi><mo>−</mo><mi>x</mi><mo>‖</mo></mrow><mi>p</mi><mi>p</mi></msubsup><mo>=</mo>
      <msup><mrow><mo>|</mo><msub><mi>y</mi><mn>1</mn></msub><mo>−</mo><msub><mi>x</mi><mn>1</mn></msub><mo>|</mo></mrow><mi>p</mi></msup><mo>+</mo>
      <msup><mrow><mo>|</mo><msub><mi>y</mi><mn>2</mn></msub><mo>−</mo><msub><mi>x</mi><mn>2</mn></msub><mo>|</mo></mrow><mi>p</mi></msup>`,
    spoken: 'The p-th power of the distance of x and y is the p-th power of their difference along one axis plus that along the other.',
    source: `${paper}, Eq. (1), here with p = 6`,
    project: figure({ seeds: 'isotropic', method: 'paper' }, cells), at: { stage: 'optimise', iteration: 60 },
  },
  {
    id: 'field', title: 'Which way is up?',
    text: `A square cell must know which way it is turned. Along the outline that is known: quads should stand straight on it. Inside,
      we look for the smoothest directions in between.

      There is a catch: a square that is turned by a quarter is the same square. So the unknown is not the angle but four times
      the angle, as a point on a circle, and its two coordinates spread from the outline like heat.

      The crosses show what comes out. Round a hole they have to turn, and somewhere they cannot agree. These places are marked:
      there the mesh gets a point where three or five quads meet instead of four. How many, the outline decides.`,
    formula: `<mi>z</mi><mo>=</mo><msup><mi>e</mi><mrow><mi>i</mi><mn>4</mn><mi>θ</mi></mrow></msup><mo>=</mo><mi>a</mi><mo>+</mo><mi>i</mi><mi>b</mi><mo>,</mo><mspace width="0.6em"/>
      <msup><mo>∇</mo><mn>2</mn></msup><mi>a</mi><mo>=</mo><msup><mo>∇</mo><mn>2</mn></msup><mi>b</mi><mo>=</mo><mn>0</mn>`,
    spoken: 'z is e to the i four theta, with real part a and imaginary part b; the Laplacian of a and that of b are zero inside.',
    source: `${paper}, section 4`,
    project: figure({ seeds: 'isotropic', method: 'paper' }, ['boundary', 'crosses']), at: { stage: 'seeds' },
  },
  {
    id: 'matching', title: 'Triangles find partners',
    text: `Join the points by triangles, and merge the triangles in pairs. Any two neighbours can become a quad, some better than
      others, but each triangle has only one partner. To take the best pair first does not work: the last triangles would be far
      apart, with nobody left for them.

      Edmonds' Blossom algorithm finds, among all ways to pair everybody, one with the smallest total cost, and proves that none
      is cheaper. A pair costs what its quad lacks to a rectangle.

      The figure shows which pairs were chosen. On the outline a few pairs take an extra edge, so that no triangle is left over.`,
    formula: `<munder><mi>min</mi><mtext>pairings</mtext></munder><munder><mo>∑</mo><mtext>pairs</mtext></munder><mo>(</mo><mn>1</mn><mo>−</mo><mi>η</mi><mo>(</mo><mi>q</mi><mo>)</mo><mo>)</mo>`,
    spoken: 'Of all pairings, the one with the least sum over its pairs of one minus the quality eta of the quad.',
    source: `${paper}, step 5 of section 5; cost as in Blossom-Quad`,
    project: figure({ seeds: 'isotropic', method: 'paper' }, ['boundary', 'matching']), at: { stage: 'clean' },
  },
  {
    id: 'quality', title: 'Repair, polish, prove',
    text: `Most of the quads are good now, some are not. A point where three or five quads meet bends the rows around it; these points
      are marked.

      So edges are turned, and whole patches are taken out and filled again with fewer such points, as long as nothing gets worse.
      Then all points inside move a little, until angles are nearly right and sizes even.

      In the end an exact check proves that every quad is convex, that all fit together and that the outline is as it was. The
      mean of the scores from the first chapter says how good the mesh is; look at the worst one, too. Now draw something of your
      own.`,
    formula: `<mover><mi>η</mi><mo>‾</mo></mover><mo>=</mo><mfrac><mn>1</mn><mi>Q</mi></mfrac><munder><mo>∑</mo><mi>q</mi></munder><mi>η</mi><mo>(</mo><mi>q</mi><mo>)</mo>`,
    spoken: 'Mean eta is the sum of eta over all quads divided by their number.',
    source: `${paper}, section 5`,
    project: figure({}, ['boundary', 'quads', 'quality', 'valence']), at: { stage: 'done' },
  },
];
