// Writes the domains of tests/fixtures/domains that are pure geometry: node tests/tools/make_domains.mjs
// Country outlines there come from Natural Earth (public domain) and are kept as they are.
import { writeFileSync } from 'node:fs';

const folder = new URL('../fixtures/domains/', import.meta.url);
const circle = (x, y, r, n, turn = 0) =>
  Array.from({ length: n }, (_, k) => {
    const t = turn + (2 * Math.PI * k) / n;
    return [x + r * Math.cos(t), y + r * Math.sin(t)];
  });

/** Teeth as trapezia between a foot and a tip circle. */
function gear(teeth, foot, tip) {
  const points = [];
  for (let k = 0; k < teeth; ++k) {
    for (const [share, radius] of [[0.0, foot], [0.12, tip], [0.38, tip], [0.5, foot]]) {
      const t = (2 * Math.PI * (k + share)) / teeth;
      points.push([radius * Math.cos(t), radius * Math.sin(t)]);
    }
  }
  return points;
}

const domains = {
  square: { h: 0.1, loops: [[[0, 0], [1, 0], [1, 1], [0, 1]]] },
  l_shape: { h: 0.08, loops: [[[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]] },
  annulus: { h: 0.1, loops: [circle(0, 0, 1, 64), circle(0, 0, 0.4, 32)] },
  plate_with_hole: {
    h: 0.08,
    loops: [[[-1, -1], [1, -1], [1, 1], [-1, 1]], circle(0, 0, 0.4, 48)],
  },
  twenty_to_one: {
    h: 0.1,
    loops: [[[-1, -1], [1, -1], [1, 1], [-1, 1]], circle(0, 0, 0.04, 50)],
    sizes: circle(0, 0, 0.04, 50).map((p) => [...p, 0.005]),
  },
  gear: { h: 0.05, loops: [gear(12, 0.8, 1), circle(0, 0, 0.3, 40)] },
  two_materials: {
    h: 0.1,
    regions: [
      { name: 'steel', loops: [[[0, 0], [1, 0], [1, 1], [0, 1]]], tags: [['bottom', '', '', 'inlet']] },
      { name: 'copper', loops: [[[1, 0], [2, 0], [2, 1], [1, 1]]], tags: [['bottom', 'outlet', '', '']] },
    ],
  },
};

for (const [name, domain] of Object.entries(domains)) {
  writeFileSync(new URL(`${name}.json`, folder), JSON.stringify({ name, ...domain }) + '\n');
}
