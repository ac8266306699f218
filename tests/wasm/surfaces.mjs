// Surfaces of the tests, and one of them as a file in every format.

// A box of 1 x 1 x 2, two triangles a side.
const corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 2], [1, 0, 2], [1, 1, 2], [0, 1, 2]];
const sides = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
const triangles = sides.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]);
export const box = { points: Float64Array.from(corners.flat()), triangles: Uint32Array.from(triangles.flat()) };

const lines = (rows, write = (row) => row.join(' ')) => rows.map((row) => `${write(row)}\n`).join('');

function binaryStl() {
  const bytes = new Uint8Array(84 + 50 * triangles.length), view = new DataView(bytes.buffer);
  view.setUint32(80, triangles.length, true);
  triangles.forEach((triangle, t) => triangle.forEach((v, k) => corners[v].forEach((x, i) =>
    view.setFloat32(84 + 50 * t + 12 + 12 * k + 4 * i, x, true))));
  return bytes;
}

const facet = (triangle) => `facet normal 0 0 0\nouter loop\n${lines(triangle, (v) => `vertex ${corners[v].join(' ')}`)}endloop\nendfacet`;

export const boxFiles = {
  'box.obj': lines(corners, (p) => `v ${p.join(' ')}`) + lines(sides, (side) => `f ${side.map((v) => v + 1).join(' ')}`),
  'box.off': `OFF\n8 12 0\n${lines(corners)}${lines(triangles, (t) => `3 ${t.join(' ')}`)}`,
  'ascii.stl': `solid box\n${lines(triangles, facet)}endsolid box\n`,
  'binary.stl': binaryStl(),
  'box.ply': 'ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement face 12\n' +
    `property list uchar int vertex_indices\nend_header\n${lines(corners)}${lines(triangles, (t) => `3 ${t.join(' ')}`)}`,
  'box.msh': `$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n${lines(corners, (p) => `${corners.indexOf(p) + 1} ${p.join(' ')}`)}$EndNodes\n` +
    `$Elements\n12\n${lines(triangles, (t) => `${triangles.indexOf(t) + 1} 2 2 0 1 ${t.map((v) => v + 1).join(' ')}`)}$EndElements\n`,
};

/** Radii 1 and 0.4; so many points around the tube and along it. */
export function torus(around, along) {
  const points = [], faces = [];
  for (let j = 0; j < along; ++j)
    for (let i = 0; i < around; ++i) {
      const a = (2 * Math.PI * i) / around, b = (2 * Math.PI * j) / along, r = 1 + 0.4 * Math.cos(a);
      points.push(r * Math.cos(b), r * Math.sin(b), 0.4 * Math.sin(a));
      const at = (di, dj) => ((j + dj) % along) * around + ((i + di) % around);
      faces.push(at(0, 0), at(0, 1), at(1, 1), at(0, 0), at(1, 1), at(1, 0));
    }
  return { points: Float64Array.from(points), triangles: Uint32Array.from(faces) };
}
