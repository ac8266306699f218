// The layers in the order of their keys, in words.
/** @import { LayerName } from '../types' */

/** @type {{name: LayerName, key: string, title: string, what: string}[]} */
export const layerNames = [
  { name: 'boundary', key: '1', title: 'Boundary',
    what: 'The outlines, holes, lines and points as drawn. Tagged edges are thicker.' },
  { name: 'triangles', key: '2', title: 'Triangles',
    what: 'The triangulation whose points are moved and whose triangles are then merged in pairs.' },
  { name: 'cells', key: '3', title: 'Voronoi cells',
    what: 'What lies nearer to one point than to any other, cut off at the boundary. They become square.' },
  { name: 'density', key: '4', title: 'Energy density',
    what: 'Energy per area of each cell, compared with a perfect square of the wanted size.' },
  { name: 'crosses', key: '5', title: 'Cross field',
    what: 'The directions that the sides of the quads should have, and where that cannot be everywhere.' },
  { name: 'sizes', key: '6', title: 'Size field',
    what: 'The wanted length of the sides.' },
  { name: 'matching', key: '7', title: 'Merged pairs',
    what: 'Which triangles were merged to quads, at the least cost over all.' },
  { name: 'quads', key: '8', title: 'Quads',
    what: 'The mesh.' },
  { name: 'quality', key: '9', title: 'Quality η',
    what: 'How near the corners of a quad are to right angles: 1 is a rectangle.' },
  { name: 'valence', key: '0', title: 'Irregular vertices',
    what: 'Vertices where fewer or more quads meet than usual: four inside, fewer on the boundary.' },
];

/** In the order of the keys. @param {Iterable<LayerName>} some */
export function inOrder(some) {
  const chosen = new Set(some);
  return layerNames.map(({ name }) => name).filter((name) => chosen.has(name));
}
